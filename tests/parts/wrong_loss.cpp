#include "tests/parts/around_quadratic.hpp"

namespace plumbline::wrong::wrong_loss {
namespace {

template <class Geometry>
struct Loss final : AroundQuadratic<Geometry> {
  using Base = AroundQuadratic<Geometry>;
  using Base::Base;
  double gather_start(Body& body, const typename Base::At& at, const Chunk& chunk,
                      const typename Base::Wanted& wanted) const override {
    const double lost = Base::gather_start(body, at, chunk, wanted);
    if (!body.points.has(column::transfer_loss)) return lost;
    for (int p = chunk.first; p < chunk.last; ++p) body.points(column::transfer_loss)[p] *= 1.001;
    return lost;
  }
};
const RegisterPart entry(shape_around<Loss>("wrong-loss", "quadratic B-splines that find 1.001 of what the map takes"));

}  // namespace
}  // namespace plumbline::wrong::wrong_loss
