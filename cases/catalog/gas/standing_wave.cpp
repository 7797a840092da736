// A standing sound wave: how fast waves of a given number of cells travel.
#include <memory>
#include <numbers>

#include "cases/catalog/gas/gas_case.hpp"
#include "cases/harness/description/parameters.hpp"
#include "reference/standing_wave.hpp"

namespace plumbline::standing_wave {
namespace {

struct Wave : Parameters {
  using Parameters::Parameters;
  reference::StandingWaveProblem wave{.amplitude = number({.name = "amplitude",
                                                           .value = 5e-4,
                                                           .unit = "m/s",
                                                           .low = -0.01,
                                                           .high = 0.01,
                                                           .description = "largest velocity at t = 0"}),
                                      .wavenumber = 2 * std::numbers::pi,
                                      .gamma = within("gamma", 1.4, "1", 1, 3, "ratio of specific heats")};
  double periods = within("periods", 1.25, "1", 0, 10, "of the wave until the end");
  bool mirrored = yes_or_no("mirrored", false, "the gas beyond the wall at x = 0 in its place");
};

GasFlow wave_flow(const Settings& settings) {
  const Wave parameters(settings);
  const auto wave = std::make_shared<const reference::StandingWave>(parameters.wave);
  GasFlow flow;
  flow.gamma = parameters.wave.gamma;
  flow.end_time = parameters.periods * wave->period().value;
  flow.initial = [wave](double x) { return state_of(wave->sample(x, 0)); };
  flow.exact = [wave](double x, double t) { return wave->sample(x, t); };
  return parameters.mirrored ? with_mirror_image(flow) : flow;
}

std::vector<CaseGate> gates() {
  const std::string smooth = "smooth flow allows 2; 0.2 for the coarsest mesh";
  const Because fast = requirement(
      "at 32 cells a wavelength the mean error of the velocity at most 0.003 of the amplitude: a phase off by 0.6 "
      "thousandths "
      "of a turn a period");
  return joined({required_order("default", "density.L1", 1.8, smooth),
                 required_order("default", "velocity.L1", 1.8, smooth),
                 {gate("default/velocity-32", error_at("velocity.L1", 32), at_most(1.5e-6), fast),
                  energy_gate("default"), coverage_gate("default", 32), mirror_gate("mirrored", "default", 16)}});
}

Case standing_wave() {
  return {.name = "standing-wave",
          .kind = Kind::gas,
          .keys = Wave().keys(),
          .sets = {{"cells", 32.0}},
          .york1997 = york_points,
          .york_step = york_step,
          .problem = gas_run(wave_flow),
          .studies = {study("default", "default, smooth flow",
                            "Nothing jumps: shapes, step and points are each of second order.", {16, 22, 32, 44, 64}),
                      study("mirrored", "the same without the wall at x = 0", "As with the wall.", {16})
                          .with({{"mirrored", "yes"}})},
          .gates = gates(),
          .levels = {16, 22, 32, 44, 64}};
}
PLUMBLINE_CASE(standing_wave);

}  // namespace
}  // namespace plumbline::standing_wave
