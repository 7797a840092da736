#include "tests/parts/around_quadratic.hpp"

namespace plumbline::wrong::wrong_blur {
namespace {

template <class Geometry>
struct Blur final : AroundQuadratic<Geometry> {
  using Base = AroundQuadratic<Geometry>;
  using Base::Base;
  ShapeTraits shape() const override {
    ShapeTraits traits = Base::shape();
    traits.blur *= 1.001;
    return traits;
  }
};
const RegisterPart entry(shape_around<Blur>("wrong-blur",
                                            "quadratic B-splines that say they smooth 1.001 times as much"));

}  // namespace
}  // namespace plumbline::wrong::wrong_blur
