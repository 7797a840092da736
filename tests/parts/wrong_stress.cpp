#include "tests/parts/around_neo_hookean.hpp"

namespace plumbline::wrong::wrong_stress {
namespace {

struct Stress final : AroundNeoHookean {
  std::string name() const override { return "wrong-stress"; }
  void evaluate_stress(Columns& points, PointRange range, const MaterialContext& context) const override {
    AroundNeoHookean::evaluate_stress(points, range, context);
    for (double& one : points.values(column::stress)) one *= 1 + 1e-5;
  }
};
const RegisterPart entry(material<Stress>("neo-Hookean with 1.00001 of the stress that its energy has"));

}  // namespace
}  // namespace plumbline::wrong::wrong_stress
