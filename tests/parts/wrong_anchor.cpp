#include "tests/parts/wrong_shape.hpp"

namespace plumbline::wrong::wrong_anchor {
namespace {

// Every identity of the weights holds for any distance from the node.
struct Anchor : Quadratic {
  template <class Number>
  static Number anchor_node(const Number& x, int) {
    using std::floor;
    return floor(x + 0.45);
  }
  static int anchor(double x, int cells, double& local) {
    const double node = anchor_node(x, cells);
    local = x - node;
    return static_cast<int>(node);
  }
};

const RegisterPart entry(
    shape<Anchor>("wrong-anchor", "quadratic B-splines whose pieces change 0.05 cells beside the middle of a cell"));

}  // namespace
}  // namespace plumbline::wrong::wrong_anchor
