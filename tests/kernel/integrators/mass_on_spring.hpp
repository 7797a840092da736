// A mass on a spring as a state and its rate: what methods of lines see, without maps; and what a step of theirs makes of it.
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "kernel/time_integrator.hpp"

namespace plumbline {

// u'' = pull(u, u'), by default -u. State (u, u'). Everything but states and rates is not to be called.
class MassOnSpring final : public Stages {
 public:
  double u, v;
  std::function<double(double u, double v)> pull = [](double place, double) { return -place; };
  std::vector<Eigen::Vector2d> states_set = {};
  int rates = 0;

  MassOnSpring(double displacement, double velocity) : u(displacement), v(velocity) {}

  State state() const override { return {{u, v}}; }
  void set_state(const State& state) override {
    u = state.values.at(0);
    v = state.values.at(1);
    states_set.emplace_back(u, v);
  }
  State rate() override {
    ++rates;
    return {{v, pull(u, v)}};
  }
  State velocities_of(State state) const override {
    state.values.at(0) = 0;
    return state;
  }

  void locate_points() override { unexpected(); }
  void map_mass_and_momentum() override { unexpected(); }
  void map_forces() override { unexpected(); }
  void advance_momentum(double) override { unexpected(); }
  void move_points(double, NodalVelocity) override { unexpected(); }
  void drift_points(double) override { unexpected(); }
  void kick_points(double) override { unexpected(); }
  void map_momentum() override { unexpected(); }
  void strain_points(double, NodalVelocity) override { unexpected(); }
  void evaluate_stress(NodalVelocity) override { unexpected(); }
  void predict_stress(double, NodalVelocity) override { unexpected(); }
  bool reverse_cooling() override {
    unexpected();
    return false;
  }
  void return_transfer_loss() override { unexpected(); }

 private:
  static void unexpected() { ADD_FAILURE() << "a method of lines called a stage"; }
};

// What one step of length z makes of the unit states of u'' = -u, column by column. Of integrators without memory.
inline Eigen::Matrix2d spring_matrix(const std::string& integrator, double z) {
  Eigen::Matrix2d matrix;
  for (int k = 0; k < 2; ++k) {
    MassOnSpring mass(k == 0, k == 1);
    find_integrator(integrator)->make()->step(mass, z);
    matrix.col(k) << mass.u, mass.v;
  }
  return matrix;
}

// R(z A) = sum_k (z A)^k / k! up to `order`, A = ((0, 1), (-1, 0)): what any Runge-Kutta method of as many stages makes.
inline Eigen::Matrix2d taylor(double z, int order) {
  Eigen::Matrix2d generator, term = Eigen::Matrix2d::Identity(), sum = Eigen::Matrix2d::Zero();
  generator << 0, 1, -1, 0;
  for (int k = 0; k <= order; term = term * (z / ++k) * generator) sum += term;
  return sum;
}

// Distance of (u, v) from (cos t, -sin t) at t = 2 after so many steps from (1, 0).
inline double error_on_spring(TimeIntegrator& integrator, int steps) {
  MassOnSpring mass(1, 0);
  for (int k = 0; k < steps; ++k) integrator.step(mass, 2.0 / steps);
  return std::hypot(mass.u - std::cos(2.0), mass.v + std::sin(2.0));
}

// With half the step the error falls by 2^order, to a share of the order of the step, 2/64.
inline void expect_order_on_spring(const std::string& name, int order) {
  const auto error = [&](int steps) { return error_on_spring(*find_integrator(name)->make(), steps); };
  EXPECT_NEAR(std::log2(error(64) / error(128)), order, 0.05) << name;
}

}  // namespace plumbline
