#include "cases/harness/laboratory/oscillator.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "cases/harness/laboratory/matrices.hpp"

namespace plumbline {

OneMass::OneMass(double displacement, double velocity, Spring spring)
    : spring_(std::move(spring)),
      u_(displacement),
      v_(velocity),
      x_(displacement),
      force_(force(displacement, velocity)),
      damper_velocity_(velocity) {}

void OneMass::carry(const Eigen::Vector3d& carried) {
  u_ = carried[0];
  v_ = carried[1];
  force_ = carried[2];
}

void OneMass::map_mass_and_momentum() {
  start_ = end_ = remapped_ = v_;
  current_ = NodalVelocity::start;
}

void OneMass::advance_momentum(double dt) {
  end_ = start_ + dt * nodal_force_;
  current_ = NodalVelocity::end;
}

void OneMass::move_points(double dt, NodalVelocity carrying) {
  x_ += dt * nodal(carrying);
  v_ = end_;
}

void OneMass::drift_points(double dt) { x_ += dt * v_; }

void OneMass::kick_points(double /*dt*/) { v_ = end_; }

void OneMass::map_momentum() {
  remapped_ = v_;
  current_ = NodalVelocity::remapped;
}

double OneMass::nodal(NodalVelocity which) const {
  switch (which == NodalVelocity::current ? current_ : which) {
    case NodalVelocity::end:
      return end_;
    case NodalVelocity::midpoint:
      return 0.5 * (start_ + end_);
    case NodalVelocity::remapped:
      return remapped_;
    default:
      return start_;
  }
}

void OneMass::strain_points(double dt, NodalVelocity velocity) { u_ += dt * nodal(velocity); }

void OneMass::evaluate_stress(NodalVelocity velocity) {
  damper_velocity_ = nodal(velocity);
  force_ = force(u_, damper_velocity_);
}

void OneMass::predict_stress(double ahead, NodalVelocity velocity) {
  damper_velocity_ = nodal(velocity);
  force_ = force(u_ + ahead * damper_velocity_, damper_velocity_);
}

// A damper may not push.
bool OneMass::reverse_cooling() {
  const double middle = nodal(NodalVelocity::midpoint);
  if (spring_.damping == 0 || damper_velocity_ * middle >= 0) return false;
  force_ += 2 * spring_.damping * (damper_velocity_ - middle);
  damper_velocity_ = middle;
  return true;
}

void OneMass::set_state(const State& state) {
  x_ = state.values.at(0);
  v_ = state.values.at(1);
  u_ = state.values.at(2);
}

State OneMass::rate() {
  map_mass_and_momentum();
  evaluate_stress(NodalVelocity::start);
  return {{v_, force_ + spring_.gravity, v_}};
}

State OneMass::velocities_of(State state) const {
  state.values.at(0) = state.values.at(2) = 0;
  return state;
}

namespace {

std::unique_ptr<TimeIntegrator> make(const IntegratorChoice& choice) {
  const IntegratorEntry* entry = find_integrator(choice.name);
  if (!entry) throw std::invalid_argument("no integrator " + choice.name);
  auto integrator = entry->make();
  set_parameters(*integrator, choice.parameters);
  return integrator;
}

}  // namespace

Eigen::MatrixXd step_matrix(const IntegratorChoice& choice, double damping, double dt) {
  const auto integrator = make(choice);
  OneMass mass(1, 0, damping);
  integrator->step(mass, dt);
  std::vector<double*> remembered;
  for (State* state : integrator->memory()) {
    for (double& value : state->values) remembered.push_back(&value);
  }
  const auto size = static_cast<Eigen::Index>(3 + remembered.size());
  Eigen::MatrixXd matrix(size, size);
  for (Eigen::Index k = 0; k < size; ++k) {
    const Eigen::VectorXd unit = Eigen::VectorXd::Unit(size, k);
    mass.carry(unit.head<3>());
    for (Eigen::Index j = 3; j < size; ++j) *remembered[static_cast<std::size_t>(j - 3)] = unit[j];
    integrator->step(mass, dt);
    matrix.col(k).head<3>() = mass.carried();
    for (Eigen::Index j = 3; j < size; ++j) matrix(j, k) = *remembered[static_cast<std::size_t>(j - 3)];
  }
  return matrix;
}

Run run_oscillator(const IntegratorChoice& choice, double damping, const Watch& watch, double dt) {
  const auto integrator = make(choice);
  OneMass mass(0.6, 0.8, damping);
  GrowthInRun growth(watch);
  do {
    integrator->step(mass, dt);
  } while (growth.goes_on(std::hypot(mass.displacement(), mass.velocity())));
  return growth.run();
}

Eigen::Vector2d oscillation(const IntegratorChoice& choice, double damping, const Eigen::Vector2d& start, double t,
                            int steps) {
  const auto integrator = make(choice);
  OneMass mass(start[0], start[1], damping);
  for (int k = 0; k < steps; ++k) integrator->step(mass, t / steps);
  return {mass.displacement(), mass.velocity()};
}

Eigen::Vector2d exact_oscillation(double damping, const Eigen::Vector2d& start, double t) {
  Eigen::MatrixXd rates(2, 2);
  rates << 0, 1, -1, -2 * damping;
  return exponential(t * rates) * start;
}

}  // namespace plumbline
