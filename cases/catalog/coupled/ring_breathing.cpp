// A ring filled with gas breathes: gas and membrane swing together in modes known by Bessel functions.
#include <array>
#include <cmath>
#include <optional>

#include "cases/catalog/coupled/damped_wave.hpp"
#include "cases/catalog/coupled/ring.hpp"
#include "cases/harness/description/archive.hpp"
#include "cases/harness/description/case.hpp"
#include "cases/harness/judge/gates.hpp"
#include "cases/harness/verify/restart_gate.hpp"

namespace plumbline {
namespace {

class RingBreathingRun final : public Problem {
 public:
  explicit RingBreathingRun(const Settings& settings)
      : settings_(settings),
        exact_(ring_problem(settings)),
        mode_(settings.integer("mode")),
        shape_(exact_, mode_, settings.number("radius")),
        velocity_(settings.number("mach") * exact_.sound_speed().value),
        times_{0},
        shares_{velocity_} {}

  double end_time() const override { return settings_.number("periods") * exact_.period(mode_).value; }

  Scene scene() const override {
    Scene scene = ring_scene(settings_, resting_ring(settings_));
    start_mode(scene, shape_, velocity_);
    return scene;
  }

  void observe(const Simulation& simulation) override {
    if (!share_) share_.emplace(scene(), shape_);
    times_.push_back(simulation.time());
    shares_.push_back(share_->of(simulation.scene()));
  }
  void history(Archive& archive) override {
    archive("times", times_);
    archive("shares", shares_);
  }

  std::vector<Measure> measures(const Simulation&) const override {
    const reference::Bounded omega = exact_.omega(mode_);
    const auto wave = damped_wave(times_, shares_);
    const double none = std::nan("");
    Measure damping = scalar_measure("damping", wave ? wave->damping : none, 0, 0, "1");
    damping.scale = 1;
    return {scalar_measure("omega", wave ? wave->omega : none, omega.value, omega.bound, "rad/s"), damping};
  }

  Profile profile(const Simulation&) const override {
    std::vector<std::array<double, 3>> rows;
    for (std::size_t k = 0; k < times_.size(); ++k) {
      rows.push_back({times_[k], shares_[k], velocity_ * std::cos(exact_.omega(mode_).value * times_[k])});
    }
    return history_profile({{"time", "s", "time", {}},
                            {"velocity", "m/s", "the mode's velocity at the ring", {}},
                            {"velocity_reference", "m/s", "exact velocity of the ring", {}}},
                           rows);
  }

 private:
  Settings settings_;
  reference::GasRing exact_;
  int mode_;
  RingMode shape_;
  double velocity_;
  std::optional<ModeShare> share_;
  std::vector<double> times_, shares_;
};

Override accumulated() { return {"membrane.strain", "accumulated"}; }

class RingBreathing final : public Case {
 public:
  std::string name() const override { return "ring-breathing"; }

  Kind kind() const override { return Kind::coupled; }

  std::vector<Key> keys() const override {
    std::vector<Key> keys = ring_keys();
    keys.push_back(
        {.name = "mode", .value = 1.0, .low = 1, .high = 20, .integer = true, .description = "of breathing"});
    keys.push_back({.name = "mach",
                    .value = 3e-3,
                    .low = 0,
                    .high = 0.1,
                    .low_open = true,
                    .description = "velocity of the ring at the start over the speed of sound"});
    keys.push_back({.name = "periods", .value = 4.0, .low = 2, .high = 1e4, .description = "end time, of the mode"});
    return keys;
  }

  std::vector<Override> points_and_end(const std::string&) const override { return {{"cells", 16.0}}; }
  void derive(Settings& settings, const std::string& scheme) const override { york_ring_step(settings, scheme); }
  std::unique_ptr<Problem> problem(const Settings& settings) const override {
    return std::make_unique<RingBreathingRun>(settings);
  }
  std::vector<double> default_levels() const override { return {8, 10, 13, 17, 22}; }

  std::vector<StudyPlan> studies() const override {
    const std::vector<double> long_waves{8, 10, 13, 17, 22}, short_waves{10, 12, 15, 18, 22};
    return {{.id = "default",
             .title = "first mode",
             .why = "Order 2 of the frequency, 3 of the damping.",
             .values = long_waves,
             .full_values = {8, 11, 16, 22, 32, 44}},
            {.id = "mode-2",
             .title = "second mode",
             .why = "As the first.",
             .overrides = {{"mode", 2.0}},
             .values = short_waves,
             .full_values = {11, 16, 22, 32, 44}},
            {.id = "mode-3",
             .title = "third mode",
             .why = "As the first. At 8 cells it has 6.1 cells a wave length: levels start at 10.",
             .overrides = {{"mode", 3.0}},
             .values = short_waves,
             .full_values = {11, 16, 22, 32, 44},
             .frames = 25},
            {.id = "accumulated",
             .title = "first mode, strain summed from rates",
             .why = "Order 2 until strains of single points drift apart.",
             .overrides = {accumulated()},
             .values = {10, 16},
             .full_values = {8, 11, 16, 22, 32}}};
  }

  std::vector<CaseGate> gates() const override {
    std::vector<CaseGate> all;
    const char* ids[] = {"default", "mode-2", "mode-3"};
    for (int mode = 1; mode <= 3; ++mode) {
      const std::string id = ids[mode - 1];
      all.push_back(error_gate(
          id, "omega", 22,
          declare(id + "/omega-22", {{}, 0.01 * omega(mode, reference::RingLaw::segments)}, Origin::requirement,
                  "within 1 % of the exact frequency; those of the ring alone and of the gas alone are further off")));
      all.push_back(
          fitted_order_gate(id, "omega",
                            declare(id + "/omega-order", {1.8, {}}, Origin::theory,
                                    "polygon, shapes and step are of second order; 0.2 for the coarse levels")));
      all.push_back(
          fitted_order_gate(id, "damping",
                            declare(id + "/damping-order", {2.5, {}}, Origin::theory,
                                    "the affine transfer loses (kh)^4 a step, steps follow h: order 3; 0.5 for the "
                                    "ring, over whose width the kernel sees a kink")));
    }
    all.push_back(
        error_gate("default", "omega", 8,
                   declare("default/omega-8", {{}, 0.01 * omega(1, reference::RingLaw::segments)}, Origin::requirement,
                           "the first frequency within 1 % with 16 cells a wave length already")));
    all.push_back(error_gate(
        "accumulated", "omega", 16,
        declare("accumulated/omega-16", {{}, 0.01 * omega(1, reference::RingLaw::accumulated)}, Origin::requirement,
                "within 1 % of its own law's frequency, which is 7.7 % below that of segments")));
    all.push_back(restart_gate("default", "runs of gas and membrane"));
    return all;
  }

 private:
  static double omega(int mode, reference::RingLaw law) {
    reference::GasRingProblem problem;
    problem.law = law;
    return reference::GasRing(problem).omega(mode).value;
  }
};

PLUMBLINE_CASE(RingBreathing);

}  // namespace
}  // namespace plumbline
