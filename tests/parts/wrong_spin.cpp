#include "tests/parts/around_quadratic.hpp"

namespace plumbline::wrong::wrong_spin {
namespace {

template <class Geometry>
class Spin final : public AroundQuadratic<Geometry> {
 public:
  using Base = AroundQuadratic<Geometry>;
  using Base::Base;
  MotionSums gather_motion(Body& body, const typename Base::At& at, const Chunk& chunk,
                           const typename Base::Field& field, const typename Base::Motion& motion) const override {
    const MotionSums sums = Base::gather_motion(body, at, chunk, field, motion);
    if (!body.points.has(column::affine)) return sums;
    for (int p = chunk.first; p < chunk.last; ++p) {
      for (int k = 0; k < Geometry::dim * Geometry::dim; ++k) body.points(column::affine, k)[p] *= 0.99;
    }
    return sums;
  }
};
const RegisterPart entry(shape_around<Spin>("wrong-spin", "points take 0.99 of the affine part"));

}  // namespace
}  // namespace plumbline::wrong::wrong_spin
