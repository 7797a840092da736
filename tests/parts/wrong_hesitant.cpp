#include "tests/parts/around_neo_hookean.hpp"

namespace plumbline::wrong::wrong_hesitant {
namespace {

struct Hesitant final : AroundNeoHookean {
  std::string name() const override { return "wrong-hesitant"; }
  StepBounds step_bounds(const Columns& points, PointRange range, int dim) const override {
    return {.fastest = 3 * AroundNeoHookean::step_bounds(points, range, dim).fastest};
  }
};
const RegisterPart entry(material<Hesitant>("neo-Hookean that takes its waves to be three times as fast as they are"));

}  // namespace
}  // namespace plumbline::wrong::wrong_hesitant
