// The stages of a step in the words of the step written straight from the equations, in any order.
#pragma once

#include <optional>
#include <stdexcept>

#include "kernel/stages.hpp"
#include "tests/kernel/naive/step.hpp"

namespace plumbline {

class NaiveStages final : public Stages {
 public:
  explicit NaiveStages(NaiveStep& naive) : naive_(naive) {}

  void locate_points() override {
    naive_.locate();
    naive_.forces_known_ = false;
    naive_.stored_first_ = strained_first_ = 0;
  }
  void map_mass_and_momentum() override {
    naive_.to_grid();
    newest_ = Of::start;
    advanced_.reset();
  }
  // What was strained before the forces counts with the stress that they use.
  void map_forces() override {
    if (!naive_.forces_known_) {
      const double power = power_of(Of::start, strained_first_);
      naive_.integration += power;
      naive_.constitutive += naive_.stored_first_ - power;
    }
    naive_.forces();
  }
  void advance_momentum(double dt) override {
    naive_.advance(dt);
    newest_ = Of::end;
    advanced_ = dt;
    power_.reset();
  }
  void move_points(double dt, NodalVelocity carrying) override {
    book_power();
    naive_.move(dt, true, carrying == NodalVelocity::midpoint);
  }
  void kick_points(double dt) override {
    book_power();
    naive_.move(dt, false, false);
  }
  void drift_points(double dt) override { naive_.drift(dt); }
  void map_momentum() override {
    naive_.again();
    newest_ = Of::again;
  }
  void strain_points(double dt, NodalVelocity velocity) override {
    settle_power();
    if (!naive_.forces_known_) strained_first_ += dt;
    naive_.strain(dt, of(velocity));
  }
  void evaluate_stress(NodalVelocity velocity) override { predict_stress(0, velocity); }
  void predict_stress(double ahead, NodalVelocity velocity) override {
    settle_power();
    naive_.set_stress(of(velocity), ahead);
  }
  bool reverse_cooling() override { return naive_.gas_ && naive_.viscosity_would_cool(); }
  void return_transfer_loss() override {
    for (NaivePoint& point : naive_.points) {
      point.energy += point.loss / point.m;  // [EC-APIC 6]
      naive_.transfer += point.loss;
    }
  }
  State state() const override { throw std::logic_error("no method of lines"); }
  void set_state(const State&) override { throw std::logic_error("no method of lines"); }
  State rate() override { throw std::logic_error("no method of lines"); }
  State velocities_of(State) const override { throw std::logic_error("no method of lines"); }

 private:
  using Of = NaiveStep::Of;

  Of of(NodalVelocity which) const {
    switch (which) {
      case NodalVelocity::start:
        return Of::start;
      case NodalVelocity::end:
        return Of::end;
      case NodalVelocity::midpoint:
        return Of::middle;
      case NodalVelocity::remapped:
        return Of::again;
      default:
        return newest_;
    }
  }
  double power_of(Of which, double dt) const {
    double power = 0;
    for (std::size_t p = 0; p < naive_.points.size(); ++p) power += dt * naive_.power_of(p, which);
    return power;
  }
  // Of the forces of the last advance: before stresses or strains change.
  void settle_power() {
    if (advanced_ && !power_) power_ = power_of(Of::middle, *advanced_);
  }
  void book_power() {
    settle_power();
    naive_.integration -= power_.value_or(0);
  }

  NaiveStep& naive_;
  Of newest_ = Of::start;
  double strained_first_ = 0;
  std::optional<double> advanced_, power_;
};

}  // namespace plumbline
