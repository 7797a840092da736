#include "tests/parts/wrong_shape.hpp"

namespace plumbline::wrong::wrong_unity {
namespace {

struct Unity : Quadratic {
  template <class Number>
  static void weights(const Number& f, Number (&w)[support]) {
    Quadratic::weights(f, w);
    for (Number& one : w) one *= 1 + 1e-6;
  }
};

const RegisterPart entry(shape<Unity>("wrong-unity", "quadratic B-splines whose weights add up to 1.000001"));

}  // namespace
}  // namespace plumbline::wrong::wrong_unity
