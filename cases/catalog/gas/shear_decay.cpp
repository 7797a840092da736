// A shear flow that its own viscosity brings to rest.
#include <cmath>
#include <map>
#include <memory>
#include <numbers>

#include "cases/catalog/gas/gas_case.hpp"
#include "cases/harness/description/parameters.hpp"
#include "reference/shear_decay.hpp"

namespace plumbline::shear_decay {
namespace {

// Rigid ends at y = 0 and y = height hold the sliding gas up; what they send comes with the speed of sound, 1.19 m/s,
// by 0.24 m until the end, spread by viscosity over sqrt(4/3 nu t) = 0.2 m. Judged is a strip in the middle, 1.4 m from
// either end: the front of the sound, and five of those lengths beyond it.
constexpr double height = 3, half_strip = 0.1;  // m

struct Shear : Parameters {
  using Parameters::Parameters;
  reference::ShearDecayProblem decay{.amplitude = number({.name = "amplitude",
                                                          .value = 0.01,
                                                          .unit = "m/s",
                                                          .low = -0.1,
                                                          .high = 0.1,
                                                          .description = "U, largest velocity at t = 0"}),
                                     .wavenumber = std::numbers::pi,
                                     .viscosity = number({.name = "viscosity",
                                                          .value = 0.15,
                                                          .unit = "Pa s",
                                                          .low = 0,
                                                          .high = 0.15,
                                                          .description = "mu [York 4.1]"})};
  double end_time = within("t_end", 0.2, "s", 0, 0.2, "end time");
  bool mirrored = yes_or_no("mirrored", false, "the gas beyond the wall at x = 0 in its place");
};

GasFlow shear_flow(const Settings& settings) {
  const Shear shear(settings);
  const auto exact = std::make_shared<const reference::ShearDecay>(shear.decay);
  GasFlow flow;
  flow.dim = 2;
  flow.high = {1, height, 0};
  flow.gamma = exact->problem().gamma;
  flow.viscosity = exact->problem().viscosity;
  flow.end_time = shear.end_time;
  // The reference sums a series; many points stand at each x.
  flow.initial = [exact, known = std::make_shared<std::map<double, reference::GasState>>()](double x) {
    const auto [at, is_new] = known->try_emplace(x);
    if (is_new) at->second = state_of(exact->sample(x, 0));
    return at->second;
  };
  flow.exact = [exact](double x, double t) { return exact->sample(x, t); };
  flow.direction = [](const Position&) { return Position{0, 1, 0}; };
  flow.inside = [](const Position& x) { return std::abs(x[1] - height / 2) <= half_strip; };
  flow.filled = false;
  return shear.mirrored ? with_mirror_image(flow) : flow;
}

// A little more than 60 of the longest steps at this many cells.
constexpr double limited_end = 0.1877;  // s
constexpr double finest = 20;

CaseGate steps_gate() {
  const Number steps = number_of("steps to the end at " + to_text(finest),
                                 [](const StudyResult& s) {
                                   const RunResult& run = s.level(finest)->run;
                                   return stop_of(run).value_or(Measured::of(static_cast<double>(run.steps)));
                                 },
                                 {finest});
  return gate(
      "longest-step/steps", steps, exactly(61),
      theory(
          "0.1877 s over h^2/(2 dim 4/3 nu), h = 0.05 m, two dimensions, nu = 0.15 m^2/s: 60.06 at the density of 1, "
          "and up to 1.5 % more where ends let the gas out; another dimension is half or twice of it, 2 % of a "
          "coefficient one step more or less"));
}

Case shear_decay() {
  return {.name = "shear-decay",
          .kind = Kind::gas,
          .keys = Shear().keys(),
          .york1997 = york_points,
          .york_step = york_step,
          .problem = gas_run(shear_flow),
          .studies = {study("default", "default, shear between slip walls",
                            "Nothing jumps: shapes, step and points are each of second order.", {10, 12, 14, 17, 20})
                          .in_full({7, 10, 14, 20, 28, 40}),
                      study("longest-step", "with the longest step that viscosity allows",
                            "The same: the step goes with the square of the cell size.", {10, 12, 14, 17, 20})
                          .with({{"cfl", 1.0}, {"t_end", limited_end}})
                          .in_full({10, 14, 20, 28, 40}),
                      study("mirrored", "the same without the wall at x = 0", "As with the wall.", {10})
                          .with({{"mirrored", "yes"}})},
          .gates = joined({required_order("default", "velocity.L1", 1.8,
                                          "smooth flow allows 2; 0.2 for the coarsest mesh, as of the sound pulse"),
                           required_order("default", "pressure.L1", 1.8,
                                          "the heat of viscosity is of second order as what makes it is"),
                           required_order("longest-step", "velocity.L1", 1.8,
                                          "the step, too, is h^2; what is unstable would grow by each of 61 steps"),
                           {energy_gate("default"), steps_gate(), mirror_gate("mirrored", "default", 10)}}),
          .levels = {10, 14, 20, 28, 40}};
}
PLUMBLINE_CASE(shear_decay);

}  // namespace
}  // namespace plumbline::shear_decay
