// Stages that only write down in which order an integrator calls them, and with what; and the smallest
// oscillator that tells all orders apart: one membrane point between a fixed node and a moving one.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/kernel/scenes.hpp"

namespace plumbline {

class RecordingStages final : public Stages {
 public:
  std::vector<std::string> calls;
  bool cools = false;  // what reverse_cooling() answers

  void locate_points() override { calls.push_back("locate_points"); }
  void map_mass_and_momentum() override { calls.push_back("map_mass_and_momentum"); }
  void map_forces() override { calls.push_back("map_forces"); }
  void advance_momentum(double dt) override { calls.push_back("advance_momentum " + number(dt)); }
  void move_points(double dt, NodalVelocity carrying) override {
    calls.push_back("move_points " + number(dt) + (carrying == NodalVelocity::end ? "" : name(carrying)));
  }
  void drift_points(double dt) override { calls.push_back("drift_points " + number(dt)); }
  void kick_points(double dt) override { calls.push_back("kick_points " + number(dt)); }
  void map_momentum() override { calls.push_back("map_momentum"); }
  void strain_points(double dt, NodalVelocity v) override { calls.push_back("strain_points " + number(dt) + name(v)); }
  void evaluate_stress(NodalVelocity v) override { calls.push_back("evaluate_stress" + name(v)); }
  void predict_stress(double ahead, NodalVelocity v) override {
    calls.push_back("predict_stress " + number(ahead) + (v == NodalVelocity::start ? "" : name(v)));
  }
  bool reverse_cooling() override {
    calls.push_back("reverse_cooling");
    return cools;
  }
  void return_transfer_loss() override { calls.push_back("return_transfer_loss"); }
  State state() const override { return {}; }
  void set_state(const State&) override { calls.push_back("set_state"); }
  State rate() override { return {}; }
  State velocities_of(State state) const override { return state; }

 private:
  static std::string number(double dt) { return dt == 1.0 ? "dt" : dt == 0.5 ? "dt/2" : std::to_string(dt); }
  static std::string name(NodalVelocity v) {
    constexpr const char* names[] = {" current", " start", " end", " midpoint", " remapped"};
    return names[static_cast<int>(v)];
  }
};

inline std::vector<std::string> calls_of(const std::string& integrator, bool cools = false) {
  RecordingStages stages;
  stages.cools = cools;
  find_integrator(integrator)->make()->step(stages, 1.0);
  return stages.calls;
}

// One point in the cell between a wall node and a free node: the free node is the one degree of freedom.
struct OnePointOscillator {
  double h = 1, m = 2, volume = 0.5, modulus = 3;
  double x = 0.4, v = 0.2, strain = 0.1, stress = 0.3;

  Scene scene() const {
    UniaxialMembrane law;
    law.youngs_modulus = modulus;
    law.density = m / volume;
    Body body = scenes::membrane_body(law, 1, {{x, 0}}, volume, [this](auto&) { return scenes::Place{v, 0}; });
    body.points(column::strain)[0] = strain;
    return scenes::scene_of(scenes::line(2, h, scenes::walls(Wall::no_slip, Wall::free)), {std::move(body)}, "linear",
                            "flip");
  }

  // The acceleration of the free node: f = -V sigma / h over M = m N with N = x / h. [York 3.15, 3.17, 3.19]
  double acceleration() const { return -volume * stress / h / (m * weight()); }
  double weight() const { return x / h; }
  // [York 3.21, 3.22] with the free node's velocity before, which is the point's own: P / M = m v N / (m N).
  // [York 3.16]
  void move(double a, double dt) {
    const double n = weight();
    x += dt * n * (v + dt * a);
    v += dt * n * a;
  }
  // [York 5.2, 5.3, 5.5]
  void stretch(double increment) {
    strain += increment;
    stress = strain > 0 ? modulus * strain : 0;
  }
};

// Three steps of the named integrator against three of `by_hand`. About fifty roundings of numbers below one.
template <class Step>
void expect_steps_as_by_hand(const std::string& integrator, Step&& by_hand) {
  OnePointOscillator oscillator;
  Simulation run(oscillator.scene(), integrator, {0.3, 0.05});
  for (int k = 0; k < 3; ++k) {
    run.step(1);
    by_hand(oscillator, 0.05);
    const Columns& points = run.scene().bodies[0].points;
    EXPECT_NEAR(points(column::position)[0], oscillator.x, 1e-15);
    EXPECT_NEAR(points(column::velocity)[0], oscillator.v, 1e-14);
    EXPECT_NEAR(points(column::strain)[0], oscillator.strain, 1e-14);
    EXPECT_NEAR(points(column::stress)[0], oscillator.stress, 1e-14);
  }
}

}  // namespace plumbline
