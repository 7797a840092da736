#pragma once
// A mass hanging from a spring without mass, gravity suddenly applied [York 5.10, 5.11].
#include "reference/bounded.hpp"

namespace plumbline::reference {

/// An elastic bar of Young's modulus E, section A and length L, fixed at its top, with a point mass at its lower end.
/// Bar and mass start at rest and unstretched; gravity acts on both from t = 0. Any consistent units; all positive,
/// but `density` (of the bar, per volume) may be 0 and gravity may be 0 or negative. Defaults: (York, section 5.5).
struct SpringProblem {
  double youngs_modulus = 1e6;
  double area = 0.1;
  double length = 0.3;
  double mass = 3.33;
  double density = 0.1;
  double gravity = 250;
};

/// Throws ParameterError, with the key of the parameter, unless the ranges above hold.
void check_spring(const SpringProblem& problem);

/// Ignores the bar's density. Displacement, velocity: positive along gravity, from the unstretched position.
class MasslessSpring {
 public:
  explicit MasslessSpring(const SpringProblem& problem);

  Bounded stiffness() const { return stiffness_; }
  Bounded omega() const { return omega_; }
  Bounded period() const;
  Bounded static_displacement() const { return rest_; }
  Bounded max_displacement() const;

  Bounded displacement(double time) const;
  Bounded velocity(double time) const;
  Bounded kinetic_energy(double time) const;
  Bounded spring_energy(double time) const;

 private:
  Bounded mass_, stiffness_, omega_, rest_;
};

}  // namespace plumbline::reference
