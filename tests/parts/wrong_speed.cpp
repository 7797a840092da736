#include "tests/parts/around_neo_hookean.hpp"

namespace plumbline::wrong::wrong_speed {
namespace {

struct Speed final : AroundNeoHookean {
  std::string name() const override { return "wrong-speed"; }
  StepBounds step_bounds(const Columns& points, PointRange range, int dim) const override {
    return {.fastest = 0.9 * AroundNeoHookean::step_bounds(points, range, dim).fastest};
  }
};
const RegisterPart entry(material<Speed>("neo-Hookean that takes its waves to be a tenth slower than they are"));

}  // namespace
}  // namespace plumbline::wrong::wrong_speed
