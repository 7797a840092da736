// A mass on a spring behind the stages of a step: what a time integrator does without maps between points and grid.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <vector>

#include "cases/harness/laboratory/limits.hpp"
#include "kernel/stages.hpp"
#include "kernel/time_integrator.hpp"

namespace plumbline {

// The force of a spring by its stretch; ratio zeta of a damper beside it; a body force.
struct Spring {
  std::function<double(double u)> force = [](double u) { return -u; };
  double damping = 0, gravity = 0;
};

// u'' = f(u) - 2 zeta u' + g, the mass one. One point on one node: its strain is the stretch u, its stress the force of
// spring and damper. The node has the point's velocity, whatever the transfer, so nothing is lost in maps. The place x at
// which the point stands moves with it and acts on nothing: x' = v as u' = v, by other stages.
class OneMass final : public Stages {
 public:
  OneMass(double displacement, double velocity, Spring spring);
  OneMass(double displacement, double velocity, double damping)
      : OneMass(displacement, velocity, Spring{.damping = damping}) {}

  double displacement() const { return u_; }
  double velocity() const { return v_; }
  double place() const { return x_; }  // the displacement at the start, and what the point has moved since

  // All that one step hands to the next: displacement, velocity, and the force as it was last evaluated.
  Eigen::Vector3d carried() const { return {u_, v_, force_}; }
  void carry(const Eigen::Vector3d& carried);

  void locate_points() override {}
  void map_mass_and_momentum() override;
  void map_forces() override { nodal_force_ = force_ + spring_.gravity; }
  void advance_momentum(double dt) override;
  void move_points(double dt, NodalVelocity carrying) override;
  void drift_points(double dt) override;
  void kick_points(double dt) override;
  void map_momentum() override;
  void strain_points(double dt, NodalVelocity velocity) override;
  void evaluate_stress(NodalVelocity velocity) override;
  void predict_stress(double ahead, NodalVelocity velocity) override;
  bool reverse_cooling() override;
  void return_transfer_loss() override {}
  State state() const override { return {{x_, v_, u_}}; }  // as of a body: places, velocities, strains
  void set_state(const State& state) override;
  State rate() override;
  State velocities_of(State state) const override;

 private:
  double nodal(NodalVelocity which) const;
  double force(double displacement, double velocity) const {
    return spring_.force(displacement) - 2 * spring_.damping * velocity;
  }

  Spring spring_;
  double u_, v_, x_;
  double force_, damper_velocity_;
  double nodal_force_ = 0, start_ = 0, end_ = 0, remapped_ = 0;
  NodalVelocity current_ = NodalVelocity::start;
};

// One step of an integrator on it as a matrix: of displacement, velocity, force, and what the integrator remembers, each
// changed by one. The integrator has taken a step of the same dt before. dt > 0 in units of 1/omega.
Eigen::MatrixXd step_matrix(const IntegratorChoice& integrator, double damping, double dt);

// From a displaced mass on its way. Its size is sqrt(u^2 + u'^2), one at first.
Run run_oscillator(const IntegratorChoice& integrator, double damping, const Watch& watch, double dt);

// Displacement and velocity after `steps` equal steps to t (1/omega), from (start.u, start.v).
Eigen::Vector2d oscillation(const IntegratorChoice& integrator, double damping, const Eigen::Vector2d& start, double t,
                            int steps);
// The same without steps: the exponential of the equation's matrix.
Eigen::Vector2d exact_oscillation(double damping, const Eigen::Vector2d& start, double t);

}  // namespace plumbline
