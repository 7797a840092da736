#include "tests/parts/wrong_shape.hpp"

namespace plumbline::wrong::wrong_nearest {
namespace {

struct Nearest : Quadratic {
  template <class Number>
  static void weights(const Number&, Number (&w)[support]) {
    w[0] = w[2] = 0.0;
    w[1] = 1.0;
  }
};
const RegisterPart entry(shape<Nearest>("wrong-nearest", "all of a point goes to its nearest node"));

}  // namespace
}  // namespace plumbline::wrong::wrong_nearest
