#include "tests/parts/around_quadratic.hpp"

namespace plumbline::wrong::wrong_force {
namespace {

template <class Geometry>
struct Force final : AroundQuadratic<Geometry> {
  using Base = AroundQuadratic<Geometry>;
  using Base::Base;
  double map_forces(const Body& body, const typename Base::At& at, const Chunk& chunk, Shares shares,
                    typename Base::Field& field) const override {
    const double hoop = Base::map_forces(body, at, chunk, shares, field);
    for (auto& force : field.force) force *= 1 + 1e-6;
    return hoop;
  }
};
const RegisterPart entry(shape_around<Force>("wrong-force", "quadratic B-splines whose forces are 1e-6 strong"));

}  // namespace
}  // namespace plumbline::wrong::wrong_force
