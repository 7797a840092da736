#include "tests/parts/wrong_shape.hpp"

namespace plumbline::wrong::wrong_centre {
namespace {

// The weights add up to 1, and their mean place is off by 2e-7 cells.
struct Centre : Quadratic {
  template <class Number>
  static void weights(const Number& f, Number (&w)[support]) {
    Quadratic::weights(f, w);
    w[0] -= 1e-7;
    w[2] += 1e-7;
  }
};

const RegisterPart entry(shape<Centre>("wrong-centre",
                                       "quadratic B-splines that move the mean place of a point by 2e-7 cells"));

}  // namespace
}  // namespace plumbline::wrong::wrong_centre
