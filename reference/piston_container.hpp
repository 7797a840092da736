#pragma once
// A piston between a spring and a closed column of gas: longitudinal vibration [York 6.2], the spring with its own mass
// if wanted; the participation of the modes is derived here.
//
// Along y the gas fills [0, L] with a wall at 0, the piston (a point mass m) stands at L, the spring [L, L + L_s] ends in
// a wall. Gas: pressure -beta u_y, wave speed c = sqrt(beta/rho); spring: an elastic bar, c_s = sqrt(E/rho_s).
//   u = sin(w y/c)/sin(w L/c) in the gas,  sin(w (L + L_s - y)/c_s)/sin(w L_s/c_s) in the spring,  1 at the piston,
//   rho c A w cot(w L/c) + rho_s c_s A w cot(w L_s/c_s) = m w^2        (spring without mass: K = E A/L_s instead).
// The left side over w falls from +inf to -inf between any two neighbouring poles k pi c/L, k pi c_s/L_s, and m w grows:
// the n-th frequency lies between the poles n - 1 and n (pole 0 being 0), all poles counted; where two poles coincide it
// is that pole itself, with the piston at rest.
//
// Energy of a mode: M_n w_n^2/2 at unit amplitude of the piston, where the equation above turns the integrals into
//   M_n = (m + m_g/sin(w L/c)^2 + m_s/sin(w L_s/c_s)^2)/2,   K/w^2 in place of the last term without spring mass.
// If the piston alone starts with velocity v, it moves by sum b_n sin(w_n t), b_n = v (m/M_n)/w_n. At t = 0+ all of v is
// there: the sum of all m/M_n is 1, so those left out are known and bound what the sum leaves out.
#include <vector>

#include "reference/bounded.hpp"

namespace plumbline::reference {

/// SI units. All positive, but spring_density may be 0 (spring without mass) and velocity is any finite number.
/// Defaults: York, section 6.1.
struct PistonContainerProblem {
  double spring_modulus = 2000;  // E, Pa
  double spring_length = 20;     // L_s, m
  double spring_density = 0;     // rho_s, kg/m^3
  double area = 1;               // A of piston, spring and gas, m^2
  double mass = 0.1;             // m, kg
  double gas_density = 1e-4;     // rho, kg/m^3
  double bulk_modulus = 1.58e6;  // beta, Pa
  double gas_length = 20;        // L, m
  double velocity = -1;          // of the piston at t = 0, m/s, positive away from the gas
};

/// Modes are numbered from 1 to `most_mode`: ParameterError "mode" beyond.
class PistonContainer {
 public:
  static constexpr int most_mode = 100000;

  /// Throws ParameterError with the key.
  explicit PistonContainer(const PistonContainerProblem& problem);

  Bounded stiffness() const { return spring_; }   // K, N/m
  Bounded gas_stiffness() const { return gas_; }  // beta A/L, N/m
  Bounded spring_mass() const { return spring_mass_; }
  Bounded gas_mass() const { return gas_mass_; }

  Bounded omega(int n = 1) const;  // rad/s
  Bounded period(int n = 1) const;
  Bounded modal_mass(int n = 1) const;  // M_n, kg; infinite bound where the piston may be at rest in the mode
  /// b_n, m: how far mode n moves the piston if the piston alone starts with the velocity.
  Bounded participation(int n = 1) const;

  /// Displacement of the gas or the spring at y in [0, L + L_s], the piston's being 1, and its derivative, 1/m (at the
  /// piston the gas's). The gas's pressure is -beta slope. Throws ParameterError "position".
  Bounded shape(double y, int n = 1) const;
  Bounded slope(double y, int n = 1) const;

  /// The piston alone starts with the velocity: m, m/s.
  Bounded displacement(double time) const;
  Bounded velocity(double time) const;

  /// Everything starts with the velocity of mode n, the piston's being the given one: m, m/s, and the energy, J.
  Bounded mode_displacement(double time, int n = 1) const;
  Bounded mode_velocity(double time, int n = 1) const;
  Bounded mode_energy(int n = 1) const;

 private:
  struct Mode {
    Bounded omega, share;  // m/M_n
  };
  bool heavy() const { return problem_.spring_density > 0; }
  std::vector<Bounded> poles_up_to(int n) const;
  Bounded below_first() const;
  Bounded root(int n, Bounded below, Bounded above) const;
  Bounded share(Bounded omega) const;
  double left_out(int power) const;  // bounds the sum of |b_n| w_n^power over the modes left out; power 0, 1

  PistonContainerProblem problem_;
  Bounded spring_, gas_, spring_mass_, gas_mass_, spring_time_, gas_time_;  // times: transit, s
  std::vector<Mode> modes_;
  double rest_ = 0;  // bounds the sum of m/M_n over the modes left out
};

}  // namespace plumbline::reference
