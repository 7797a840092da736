#include "tests/parts/wrong_shape.hpp"

namespace plumbline::wrong::wrong_inertia {
namespace {

struct Inertia : Quadratic {
  template <class Number>
  static Number inertia(const Number&) {
    return 0.2500001;
  }
};

const RegisterPart entry(shape<Inertia>("wrong-inertia", "quadratic B-splines with an inertia of 0.2500001 cells"));

}  // namespace
}  // namespace plumbline::wrong::wrong_inertia
