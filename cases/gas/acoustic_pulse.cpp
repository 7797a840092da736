// A smooth pulse that runs through gas at rest.
#include <memory>

#include "cases/gas/gas_case.hpp"
#include "cases/gas/gas_problem.hpp"
#include "cases/harness/errors.hpp"
#include "reference/simple_wave.hpp"

namespace plumbline {
namespace {

constexpr const char* sketch =
    R"svg(<svg viewBox="0 0 360 110" role="img" aria-label="A smooth pulse of velocity at the start and, further right, at the end">
<g stroke="currentColor" stroke-width="1.5" fill="none"><path d="M20 75h320"/><path d="M60 75c25 0 30 -50 50 -50s25 50 50 50"/><path d="M190 75c25 0 32 -50 54 -50s23 50 46 50" stroke-dasharray="4 3"/><path d="M150 35h50m-8 -5l8 5l-8 5"/></g>
<g fill="currentColor" font-size="12" text-anchor="middle"><text x="110" y="95">t = 0</text><text x="244" y="95">t = 0.3</text><text x="180" y="25">c + u</text></g></svg>)svg";

reference::SimpleWaveProblem wave_of(const Settings& settings) {
  reference::SimpleWaveProblem wave;
  wave.amplitude = settings.number("amplitude");
  wave.gamma = settings.number("gamma");
  return wave;
}

GasFlow pulse_flow(const Settings& settings) {
  const auto wave = std::make_shared<const reference::SimpleWave>(wave_of(settings));
  if (const double breaks = wave->breaking_time().value; settings.number("t_end") >= breaks) {
    const std::string allowed = "below " + to_text(breaks) + " s";
    throw UsageError("t_end", to_text(settings.number("t_end")), allowed, {},
                     "the pulse breaks: t_end must be " + allowed);
  }
  GasFlow flow;
  flow.gamma = wave->problem().gamma;
  flow.end_time = settings.number("t_end");
  flow.initial = [wave](double x) {
    const reference::Sample at = wave->sample(x, 0);
    return reference::GasState{at.density.value, at.velocity.value, at.pressure.value};
  };
  flow.exact = [wave](double x, double t) { return wave->sample(x, t); };
  return flow;
}

class AcousticPulse final : public Case {
 public:
  Statement statement() const override {
    Statement s;
    s.name = "acoustic-pulse";
    s.title = "A smooth sound pulse";
    s.source = "R. Courant, K. O. Friedrichs, Supersonic Flow and Shock Waves, 1948, sections 40 and 41";
    s.claim = "Where nothing jumps the scheme is of second order.";
    s.physics =
        "A pulse of 0.001 m/s, five times continuously differentiable, runs right through gas at rest (ρ = p = 1). It "
        "is a simple wave: one entropy, u − 2c/(γ − 1) the same everywhere, each state travelling with its own u + c. "
        "It "
        "steepens a little and would break much later; the end time is before it reaches the wall.\n\n"
        "Points have equal masses, so that they stand closer where the gas is denser, to second order.";
    s.equations = gas_equations();
    s.sketch = sketch;
    s.cells_along = "the tube's length of 1 m";
    s.reference_name = "simple-wave";
    s.reference_text = "Characteristics: the state at (x, t) is that of the foot x − (u + c) t, found by bracketing.";
    s.reference_bound = "Computed: residual of the root, and rounding carried through.";
    for (const char* measure : {"density.L1", "velocity.L1", "pressure.L1", "energy.L1"}) {
      s.theory_orders.push_back(
          {measure, 2,
           "quadratic shapes, midpoint work and points by cumulative mass are of second order; only a "
           "viscosity linear in h would be of first"});
    }
    s.known_limits = {
        "An artificial viscosity linear in h acts on smooth compressions, too: there the scheme is of first order in h "
        "with a small constant.",
        "Points that moved no longer stand at equal shares of a cell: in a strain of a pressure p the sum of quadratic "
        "shapes over them is off by about the cube of the strain of their spacing times p/h. At 0.01 m/s that is a "
        "hundredth of the pulse at 200 cells and does not fall with h; at 0.001 m/s it is a thousand times less."};
    return s;
  }

  Kind kind() const override { return Kind::gas; }

  std::vector<Key> keys() const override {
    return {{.name = "amplitude",
             .value = 0.001,
             .unit = "m/s",
             .low = -0.5,
             .high = 0.5,
             .description = "largest velocity of the pulse at t = 0"},
            {.name = "gamma",
             .value = 1.4,
             .low = 1,
             .high = 3,
             .low_open = true,
             .description = "ratio of specific heats"},
            {.name = "t_end",
             .value = 0.3,
             .unit = "s",
             .low = 0,
             .high = 0.5,
             .low_open = true,
             .description = "end time"}};
  }

  std::vector<Override> points_and_end(const std::string& scheme) const override { return york_points(scheme); }
  void derive(Settings& settings, const std::string& scheme) const override { york_step(settings, scheme); }
  std::unique_ptr<Problem> problem(const Settings& settings) const override {
    return gas_problem(pulse_flow(settings), settings);
  }
  std::vector<double> default_levels() const override { return {50, 100, 200, 400, 800}; }

  std::vector<StudyPlan> studies() const override {
    return {{.id = "default",
             .title = "default, smooth flow",
             .why = "Nothing jumps: shapes, step and points are each of second order.",
             .values = {50, 70, 100, 140, 200},
             .full_values = {50, 100, 200, 400, 800}}};
  }

  std::vector<CaseGate> gates() const override {
    std::vector<CaseGate> all;
    for (const char* measure : {"density.L1", "velocity.L1"}) {
      for (CaseGate& gate : target_order("default", measure, 1.8, "smooth flow allows 2; 0.2 for the coarsest mesh")) {
        all.push_back(std::move(gate));
      }
    }
    all.push_back(energy_gate("default"));
    all.push_back(coverage_gate("default", 100));
    return all;
  }

  GateCount gate_count() const override { return {10, 10}; }
};

PLUMBLINE_CASE(AcousticPulse);

}  // namespace
}  // namespace plumbline
