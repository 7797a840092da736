#include "tests/parts/wrong_shape.hpp"

namespace plumbline::wrong::wrong_affine {
namespace {

struct Affine : Quadratic {
  template <class Number>
  static void affine_weights(const Number& f, Number (&a)[support]) {
    Quadratic::affine_weights(f, a);
    for (Number& one : a) one *= 1 + 1e-6;
  }
};
const RegisterPart entry(shape<Affine>("wrong-affine", "quadratic B-splines that take 1.000001 of the affine part"));

}  // namespace
}  // namespace plumbline::wrong::wrong_affine
