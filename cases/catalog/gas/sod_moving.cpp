// Sod's shock tube on a train.
#include <cmath>

#include "cases/catalog/gas/gas_case.hpp"
#include "cases/catalog/gas/sod_tube.hpp"
#include "cases/harness/description/parameters.hpp"

namespace plumbline::sod_moving {
namespace {

struct Train : Parameters {
  using Parameters::Parameters;
  double speed = number({.name = "speed",
                         .value = 10.0,
                         .unit = "m/s",
                         .low = -100,
                         .high = 100,
                         .description = "of the frame, beside the gas's own"});
};

GasFlow moving_flow(const Settings& settings) {
  GasFlow flow = tube_flow(sod_tube);
  flow.frame_velocity = Train(settings).speed;
  flow.margin = {0.25, 0.25};
  flow.space = {0.05, 0.05};
  flow.pistons = {0.0, 0.0};
  return flow;
}

// The Courant number that gives the gas at rest the steps of the moving one: the fastest gas, between contact and
// shock, bounds both.
double matched_courant(const Settings& settings) {
  const reference::RiemannSolution exact(sod_tube.states);
  const auto& star = exact.star();
  const double c = std::sqrt(sod_tube.states.gamma * star.pressure.value / star.density_right.value);
  const double at_rest = star.velocity.value + c;
  return settings.number("cfl") * at_rest / (at_rest + std::abs(Train(settings).speed));
}

std::vector<StudyPlan> studies(const Settings& settings) {
  const std::string why = "Shock and contact are jumps: order 1, whatever the frame.";
  return {
      study("default", "default, moving at 10 m/s", why, {100, 140, 200, 280, 400}).in_full({100, 200, 400, 800, 1600}),
      study("rest", "default, the same gas and pistons at rest", why, {100, 400}).with({{"speed", 0.0}}),
      study("rest-same-step", "default, the same gas and pistons at rest, steps as when moving", why, {100, 400})
          .with({{"speed", 0.0}, {"cfl", matched_courant(settings)}})};
}

// The error against that of the same gas at rest.
CaseGate against(const std::string& other, const std::string& id, double level) {
  return gate("default/" + id + "-" + to_text(level), error_over("density.L1", other, "study " + other, level),
              between(0.9, 1.1),
              requirement("within 10 % of the error of the same gas at rest, as of the tube that is turned: at first "
                          "order so much comes of cells a tenth larger"))
      .beside({other});
}

std::vector<CaseGate> gates() {
  const auto at = [](double level) -> std::vector<CaseGate> {
    return {against("rest-same-step", "invariance-same-step", level), against("rest", "invariance", level)};
  };
  return joined(
      {required_order("default", "density.L1", 0.8, "shock and contact allow 1; 0.8 as of the other shock tubes"),
       {energy_gate("default"), coverage_gate("default", 100)},
       at(100),
       at(400)});
}

Case sod_moving() {
  Case made{.name = "sod-moving",
            .kind = Kind::gas,
            .keys = Train().keys(),
            .york1997 = york_points,
            .york_step = york_step,
            .problem = gas_run(moving_flow),
            .gates = gates(),
            .levels = {100, 200, 400, 800, 1600}};
  made.studies = studies(made.settings("default", {}));
  return made;
}
PLUMBLINE_CASE(sod_moving);

}  // namespace
}  // namespace plumbline::sod_moving
