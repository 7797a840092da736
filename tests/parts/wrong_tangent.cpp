#include <cmath>

#include "tests/parts/around_neo_hookean.hpp"

namespace plumbline::wrong::wrong_tangent {
namespace {

struct Tangent final : AroundNeoHookean {
  std::string name() const override { return "wrong-tangent"; }
  StepBounds step_bounds(const Columns& points, PointRange range, int dim) const override {
    const LameConstants c = right().constants();
    return {.fastest = std::sqrt((c.lambda + 2 * c.mu) / density) + fastest_point(points, range, dim)};
  }
};
const RegisterPart entry(
    material<Tangent>("neo-Hookean that takes its waves to be as fast as where nothing is strained"));

}  // namespace
}  // namespace plumbline::wrong::wrong_tangent
