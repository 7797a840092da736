// Sod's shock tube in space.
#include "cases/catalog/gas/gas_case.hpp"
#include "cases/catalog/gas/sod_tube.hpp"
#include "cases/harness/verify/restart_gate.hpp"

namespace plumbline {
namespace {

const ShockTube tube = [] {
  ShockTube solid = sod_tube;
  solid.dimension = 3;
  return solid;
}();

class Sod3d final : public Case {
 public:
  std::string name() const override { return "sod-3d"; }

  Kind kind() const override { return Kind::gas; }
  std::vector<Key> keys() const override { return shock_tube_keys(tube); }
  std::vector<Override> points_and_end(const std::string& scheme) const override { return york_points(scheme); }
  void derive(Settings& settings, const std::string& scheme) const override { york_step(settings, scheme); }
  std::unique_ptr<Problem> problem(const Settings& settings) const override {
    return shock_tube_problem(shock_tube_from(settings, tube), settings);
  }
  std::vector<double> default_levels() const override { return {50, 70, 100, 140, 200}; }

  std::vector<StudyPlan> studies() const override {
    const std::string why = "Shock and contact are jumps: order 1, in any number of dimensions.";
    const std::vector<double> few{50, 100}, levels{50, 70, 100, 140, 200};
    return {{.id = "default", .title = "default, in space", .why = why, .values = few, .full_values = levels},
            {.id = "line",
             .title = "default, on a line",
             .why = why,
             .overrides = {{"dimension", 1.0}},
             .values = few,
             .full_values = levels},
            {.id = "equal-volume",
             .title = "default with points of equal volume, in space",
             .why = why,
             .overrides = {{"points", "equal-volume"}, {"ppc", 3.0}},
             .values = {50}},
            {.id = "equal-volume-line",
             .title = "default with points of equal volume, on a line",
             .why = why,
             .overrides = {{"dimension", 1.0}, {"points", "equal-volume"}, {"ppc", 3.0}},
             .values = {50}}};
  }

  std::vector<CaseGate> gates() const override {
    std::vector<CaseGate> all{same_numbers_gate("default", "line", 50), same_numbers_gate("default", "line", 100),
                              same_numbers_gate("equal-volume", "equal-volume-line", 50), energy_gate("default"),
                              coverage_gate("default", 100)};
    all.push_back(fitted_order_gate("default", "density.L1",
                                    declare("default/density-order", {0.8, {}}, Origin::theory,
                                            "shock and contact allow 1; 0.8 as of the other shock tubes"),
                                    Tier::full));
    all.push_back(restart_gate("default", "runs in space"));
    return all;
  }
};

PLUMBLINE_CASE(Sod3d);

}  // namespace
}  // namespace plumbline
