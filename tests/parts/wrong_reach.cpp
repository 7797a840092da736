#include "tests/parts/around_quadratic.hpp"

namespace plumbline::wrong::wrong_reach {
namespace {

template <class Geometry>
struct Reach final : AroundQuadratic<Geometry> {
  using Base = AroundQuadratic<Geometry>;
  using Base::Base;
  ShapeTraits shape() const override {
    ShapeTraits traits = Base::shape();
    traits.support = 2;
    return traits;
  }
};
const RegisterPart entry(shape_around<Reach>("wrong-reach",
                                             "quadratic B-splines that say they reach two nodes a direction"));

}  // namespace
}  // namespace plumbline::wrong::wrong_reach
