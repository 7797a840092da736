// A ring filled with gas breathes: gas and membrane swing together in modes known by Bessel functions.
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "cases/catalog/coupled/ring.hpp"
#include "cases/harness/description/archive.hpp"
#include "cases/harness/description/case.hpp"
#include "cases/harness/judge/gates.hpp"
#include "cases/harness/verify/restart_gate.hpp"

namespace plumbline::ring_breathing {
namespace {

struct BreathingRing : RingParameters {
  using RingParameters::RingParameters;
  int mode = integer({.name = "mode", .value = 1.0, .low = 1, .high = 20, .description = "of breathing"});
  double mach = within("mach", 3e-3, "1", 0, 0.1, "velocity of the ring at the start over the speed of sound");
  double periods = number(
      {.name = "periods", .value = 4.0, .low = 2, .high = 1e4, .description = "end time, of the mode"});
};

class RingBreathingRun final : public Problem {
 public:
  explicit RingBreathingRun(const Settings& settings)
      : settings_(settings),
        at_(settings),
        exact_(at_.problem),
        shape_(ring_mode(exact_, at_.mode, at_.problem.radius)),
        velocity_(at_.mach * exact_.sound_speed().value),
        record_(shape_, velocity_) {}

  double end_time() const override { return at_.periods * exact_.period(at_.mode).value; }

  Scene scene() const override {
    Scene scene = ring_scene(settings_, resting_ring(settings_));
    start_mode(scene, shape_, velocity_);
    return scene;
  }

  void observe(const Simulation& simulation) override {
    record_.observe(simulation.time(), simulation.scene(), [this] { return scene(); });
  }
  void history(Archive& archive) override { record_.history(archive); }

  std::vector<Measure> measures(const Simulation&) const override { return record_.measures(exact_.omega(at_.mode)); }
  Profile profile(const Simulation&) const override { return record_.profile("ring", exact_.omega(at_.mode).value); }

 private:
  Settings settings_;
  BreathingRing at_;
  reference::GasRing exact_;
  RadialMode shape_;
  double velocity_;
  ModeRecord record_;
};

std::vector<StudyPlan> studies() {
  const std::vector<double> short_waves{10, 12, 15, 18, 22}, short_waves_in_full{11, 16, 22, 32, 44};
  return {
      study("default", "first mode", "Order 2 of the frequency, 3 of the damping.", ring_levels)
          .in_full({8, 11, 16, 22, 32, 44}),
      study("mode-2", "second mode", "As the first.", short_waves).with({{"mode", 2.0}}).in_full(short_waves_in_full),
      study("mode-3", "third mode", "As the first. At 8 cells it has 6.1 cells a wave length: levels start at 10.",
            short_waves)
          .with({{"mode", 3.0}})
          .in_full(short_waves_in_full)
          .pictured(25),
      study("accumulated", "first mode, strain summed from rates",
            "Order 2 until strains of single points drift apart.", {10, 16})
          .with({{"membrane.strain", "accumulated"}})
          .in_full({8, 11, 16, 22, 32})};
}

double exact_omega(int mode, reference::RingLaw law) {
  reference::GasRingProblem problem;
  problem.law = law;
  return reference::GasRing(problem).omega(mode).value;
}

std::vector<CaseGate> gates() {
  std::vector<CaseGate> all;
  for (const auto& [study, mode] :
       std::vector<std::pair<std::string, int>>{{"default", 1}, {"mode-2", 2}, {"mode-3", 3}}) {
    all.push_back(gate(study + "/omega-22", error_at("omega", 22),
                       at_most(0.01 * exact_omega(mode, reference::RingLaw::segments)),
                       requirement("within 1 % of the exact frequency; those of the ring alone and of the gas alone "
                                   "are further off")));
    all.push_back(gate(study + "/omega-order", fitted_order_of("omega"), at_least(1.8),
                       theory("polygon, shapes and step are of second order; 0.2 for the coarse levels")));
    all.push_back(gate(study + "/damping-order", fitted_order_of("damping"), at_least(2.5),
                       theory("the affine transfer loses (kh)^4 a step, steps follow h: order 3; 0.5 for the ring, "
                              "over whose width the kernel sees a kink")));
  }
  all.push_back(gate("default/omega-8", error_at("omega", 8),
                     at_most(0.01 * exact_omega(1, reference::RingLaw::segments)),
                     requirement("the first frequency within 1 % with 16 cells a wave length already")));
  all.push_back(gate("accumulated/omega-16", error_at("omega", 16),
                     at_most(0.01 * exact_omega(1, reference::RingLaw::accumulated)),
                     requirement("within 1 % of its own law's frequency, which is 7.7 % below that of segments")));
  all.push_back(restart_gate("default", "runs of gas and membrane"));
  return all;
}

Case ring_breathing() {
  return {.name = "ring-breathing",
          .kind = Kind::coupled,
          .keys = BreathingRing().keys(),
          .sets = {{"cells", 16.0}},
          .york_step = york_ring_step,
          .problem = run_of<RingBreathingRun>,
          .studies = studies(),
          .gates = gates(),
          .levels = ring_levels};
}
PLUMBLINE_CASE(ring_breathing);

}  // namespace
}  // namespace plumbline::ring_breathing
