// A smooth pulse that runs through gas at rest.
#include <memory>

#include "cases/catalog/gas/gas_case.hpp"
#include "cases/catalog/gas/gas_problem.hpp"
#include "cases/harness/files/errors.hpp"
#include "reference/simple_wave.hpp"

namespace plumbline {
namespace {

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
  std::string name() const override { return "acoustic-pulse"; }

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
      for (CaseGate& gate :
           required_order("default", measure, 1.8, "smooth flow allows 2; 0.2 for the coarsest mesh")) {
        all.push_back(std::move(gate));
      }
    }
    all.push_back(energy_gate("default"));
    all.push_back(coverage_gate("default", 100));
    return all;
  }
};

PLUMBLINE_CASE(AcousticPulse);

}  // namespace
}  // namespace plumbline
