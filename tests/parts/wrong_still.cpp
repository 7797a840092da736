#include "tests/parts/around_neo_hookean.hpp"

namespace plumbline::wrong::wrong_still {
namespace {

struct Still final : AroundNeoHookean {
  std::string name() const override { return "wrong-still"; }
  StepBounds step_bounds(const Columns& points, PointRange range, int dim) const override {
    return {.fastest = AroundNeoHookean::step_bounds(points, range, dim).fastest - fastest_point(points, range, dim)};
  }
};
const RegisterPart entry(material<Still>("neo-Hookean whose steps forget how fast points move"));

}  // namespace
}  // namespace plumbline::wrong::wrong_still
