#include "tests/parts/wrong_shape.hpp"

namespace plumbline::wrong::wrong_gradient {
namespace {

// The gradients of constants and of linear fields stay right.
struct Gradient : Quadratic {
  template <class Number>
  static void gradients(const Number& f, Number (&g)[support]) {
    Quadratic::gradients(f, g);
    g[0] += 1e-4;
    g[1] -= 2e-4;
    g[2] += 1e-4;
  }
};

const RegisterPart entry(shape<Gradient>(
    "wrong-gradient", "quadratic B-splines whose gradients are not their derivatives, by 1e-4 of a curvature"));

}  // namespace
}  // namespace plumbline::wrong::wrong_gradient
