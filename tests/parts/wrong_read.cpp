#include "tests/parts/around_quadratic.hpp"

namespace plumbline::wrong::wrong_read {
namespace {

template <class Geometry>
struct Read final : AroundQuadratic<Geometry> {
  using Base = AroundQuadratic<Geometry>;
  using Base::Base;
  double gather_start(Body& body, const typename Base::At& at, const Chunk& chunk,
                      const typename Base::Wanted& wanted) const override {
    const double lost = Base::gather_start(body, at, chunk, wanted);
    for (int p = chunk.first; wanted.density && p < chunk.last; ++p) body.points(column::volume)[p] /= 1.001;
    return lost;
  }
};
const RegisterPart entry(shape_around<Read>("wrong-read", "quadratic B-splines that read 1.001 of the density off"));

}  // namespace
}  // namespace plumbline::wrong::wrong_read
