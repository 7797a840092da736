#include "tests/parts/around_quadratic.hpp"

namespace plumbline::wrong::wrong_overshoot {
namespace {

template <class Geometry>
class Overshoot final : public AroundQuadratic<Geometry> {
 public:
  using Base = AroundQuadratic<Geometry>;
  using Base::Base;
  MotionSums gather_motion(Body& body, const typename Base::At& at, const Chunk& chunk,
                           const typename Base::Field& field, const typename Base::Motion& motion) const override {
    const MotionSums sums = Base::gather_motion(body, at, chunk, field, motion);
    for (int p = chunk.first; p < chunk.last; ++p) {
      for (int d = 0; d < Geometry::dim; ++d) body.points(column::velocity, d)[p] *= 1 + 1e-4;
    }
    return sums;
  }
};
const RegisterPart entry(shape_around<Overshoot>("wrong-overshoot", "points take 1.0001 of what the grid gives them"));

}  // namespace
}  // namespace plumbline::wrong::wrong_overshoot
