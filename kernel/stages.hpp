// The stages of a step, as a time integrator composes them. Shapes are evaluated in locate_points() alone; every later
// stage of the step uses those frozen weights, so that masses and weights never come from different instants.
#pragma once

#include <stdexcept>
#include <vector>

namespace plumbline {

// Which nodal velocity a stage takes.
//   start      P_i / M_i as mapped at the start of the step
//   end        v~_i after the momentum update
//   midpoint   their mean, with which the forces do their work
//   remapped   from the updated point velocities
//   current    the newest of start, end and remapped
enum class NodalVelocity { current, start, end, midpoint, remapped };

// What time integration advances, all points of all bodies in one vector, or its rate of change. States of one scene
// combine linearly; those of different sizes throw std::invalid_argument.
struct State {
  std::vector<double> values;

  State& operator+=(const State& other) {
    if (other.values.size() != values.size()) throw std::invalid_argument("states of two scenes cannot be added");
    for (std::size_t k = 0; k < values.size(); ++k) values[k] += other.values[k];
    return *this;
  }
  friend State operator+(State a, const State& b) { return a += b; }
  friend State operator*(double factor, State s) {
    for (double& value : s.values) value *= factor;
    return s;
  }
};

class Stages {
 public:
  virtual ~Stages() = default;

  // Cell and shape weights N_ip, grad N_ip of every point, once per step. Stages that use them throw std::logic_error where
  // since then points were added or one of the two stages below has ended the step, or where points drifted or were set
  // before any stage had moved or kicked them: only those two keep the weights.
  virtual void locate_points() = 0;

  // M_i = sum_p m_p N_ip, M_i v_i = sum_p m_p N_ip v_p (with C_p (x_i - x_p) where the transfer is affine).
  // [York 3.15, 3.16] [EC-APIC 1]
  virtual void map_mass_and_momentum() = 0;

  // f_i = -sum_p V_p sigma_p grad N_ip + M_i b. [York 3.17, 3.18] [EC-APIC 4]
  virtual void map_forces() = 0;

  // v~_i = v_i + dt f_i / M_i. [York 3.19, 3.20] May be repeated with corrected forces; the last one counts.
  virtual void advance_momentum(double dt) = 0;

  // x_p and v_p (and C_p) from the nodal velocities, as the transfer says; points are carried by the nodal velocity
  // `carrying` (end or midpoint). [York 3.21, 3.22] [EC-APIC 5]
  virtual void move_points(double dt, NodalVelocity carrying = NodalVelocity::end) = 0;

  // x_p += dt v_p. Points that pass a wall come back as their mirror images. Chains are relaxed as move_points does it, if
  // their points were kicked before in the step.
  virtual void drift_points(double dt) = 0;

  // v_p (and C_p) from the nodal velocities; points stay where they are. [EC-APIC 5]
  virtual void kick_points(double dt) = 0;

  // v_i = sum_p m_p v_p N_ip / M_i from the updated point velocities and the frozen weights. [York 3.24]
  virtual void map_momentum() = 0;

  // Strain increments over dt from a nodal velocity; the materials' internal variables follow. [York 3.23]
  virtual void strain_points(double dt, NodalVelocity velocity = NodalVelocity::current) = 0;

  // Densities by the scene's method, then stresses, with strain rates from a nodal velocity. [York 4.1] [EC-APIC 2, 3]
  virtual void evaluate_stress(NodalVelocity velocity = NodalVelocity::current) = 0;

  // The same `ahead` seconds later, as the strain rates of a nodal velocity predict it; nothing is advanced.
  virtual void predict_stress(double ahead, NodalVelocity velocity = NodalVelocity::start) = 0;

  // strain_points, then evaluate_stress.
  void update_stress(double dt, NodalVelocity velocity = NodalVelocity::current) {
    strain_points(dt, velocity);
    evaluate_stress(velocity);
  }

  // Where viscous stress would cool over the midpoint velocity, takes it from that velocity. True if any point changed:
  // then map_forces and advance_momentum want repeating. [EC-APIC viscous heat]
  virtual bool reverse_cooling() = 0;

  // Gives what the maps of this step took from each point back as heat, where its material has an energy equation;
  // elsewhere it stays booked as lost. [EC-APIC 6] Gases of integrators that call it also exchange heat among their points,
  // as these are moved or kicked, where the scene says so. [Exchange 1]
  virtual void return_transfer_loss() = 0;

  // For methods of lines (Runge-Kutta, implicit): the state, its rate of change where it stands (forces evaluated there),
  // and setting it. Wants a FLIP transfer. Work between states set by hand is booked under `integration`. A state of another
  // size throws std::invalid_argument.
  virtual State state() const = 0;
  virtual void set_state(const State& state) = 0;
  virtual State rate() = 0;
  // The same, with zeros for everything but velocities.
  virtual State velocities_of(State state) const = 0;

  // No stage: whoever calls an integrator's step() says here that it has ended, so that nothing waits any longer.
  virtual void end_step() {}
};

}  // namespace plumbline
