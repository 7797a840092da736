// A smooth pulse that runs through gas at rest.
#include <memory>

#include "cases/catalog/gas/gas_case.hpp"
#include "cases/harness/description/parameters.hpp"
#include "cases/harness/files/errors.hpp"
#include "reference/simple_wave.hpp"

namespace plumbline::acoustic_pulse {
namespace {

struct Pulse : Parameters {
  using Parameters::Parameters;
  reference::SimpleWaveProblem wave{.amplitude = number({.name = "amplitude",
                                                         .value = 0.001,
                                                         .unit = "m/s",
                                                         .low = -0.5,
                                                         .high = 0.5,
                                                         .description = "largest velocity of the pulse at t = 0"}),
                                    .gamma = within("gamma", 1.4, "1", 1, 3, "ratio of specific heats")};
  double end_time = within("t_end", 0.3, "s", 0, 0.5, "end time");
};

GasFlow pulse_flow(const Settings& settings) {
  const Pulse pulse(settings);
  const auto wave = std::make_shared<const reference::SimpleWave>(pulse.wave);
  if (const double breaks = wave->breaking_time().value; pulse.end_time >= breaks) {
    const std::string allowed = "below " + to_text(breaks) + " s";
    throw UsageError("t_end", to_text(pulse.end_time), allowed, {}, "the pulse breaks: t_end must be " + allowed);
  }
  GasFlow flow;
  flow.gamma = pulse.wave.gamma;
  flow.end_time = pulse.end_time;
  flow.initial = [wave](double x) { return state_of(wave->sample(x, 0)); };
  flow.exact = [wave](double x, double t) { return wave->sample(x, t); };
  return flow;
}

std::vector<CaseGate> gates() {
  const std::string smooth = "smooth flow allows 2; 0.2 for the coarsest mesh";
  return joined({required_order("default", "density.L1", 1.8, smooth),
                 required_order("default", "velocity.L1", 1.8, smooth),
                 {energy_gate("default"), coverage_gate("default", 100)}});
}

Case acoustic_pulse() {
  return {.name = "acoustic-pulse",
          .kind = Kind::gas,
          .keys = Pulse().keys(),
          .york1997 = york_points,
          .york_step = york_step,
          .problem = gas_run(pulse_flow),
          .studies = {study("default", "default, smooth flow",
                            "Nothing jumps: shapes, step and points are each of second order.", {50, 70, 100, 140, 200})
                          .in_full({50, 100, 200, 400, 800})},
          .gates = gates(),
          .levels = {50, 100, 200, 400, 800}};
}
PLUMBLINE_CASE(acoustic_pulse);

}  // namespace
}  // namespace plumbline::acoustic_pulse
