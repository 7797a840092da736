#pragma once
// A rigid block and a rigid disk released on an incline with Coulomb friction, gravity growing from zero: motion along the
// incline in closed form. Tag: [Goldstein 1.4] is Newton's second law, with Coulomb's |F| <= mu N, N = m g cos(theta).
//
// Gravity is g f(t), f = s^2 (3 - 2 s) with s = t/rise, 1 after the rise: what slides, sticks or rolls does so at any g, and
// velocity and way follow from the integrals of f,
//   T1 = rise (s^3 - s^4/2), T2 = rise^2 (s^4/4 - s^5/10),  beyond the rise T1 = t - rise/2, T2 = (3/20) rise^2 + (t^2 - rise t)/2.
#include "reference/bounded.hpp"

namespace plumbline::reference {

/// slope = tan(theta) >= 0; friction mu >= 0; gravity > 0, m/s^2; rise >= 0, s.
struct InclineProblem {
  double slope = 0.6;
  double friction = 0.3;
  double gravity = 1;
  double rise = 0;
};

class Incline {
 public:
  /// Throws ParameterError with the key of a value out of range.
  explicit Incline(const InclineProblem& problem = {});

  const InclineProblem& problem() const { return problem_; }
  Bounded along() const;   // g sin(theta)
  Bounded across() const;  // g cos(theta), what the incline bears per mass

  /// Of the block: g (sin(theta) - mu cos(theta)), 0 where tan(theta) <= mu.
  Bounded block_acceleration() const;
  /// Of a homogeneous disk's centre: (2/3) g sin(theta) where it rolls, tan(theta) <= 3 mu, else the block's.
  Bounded disk_acceleration() const;
  /// Of its angle, times its radius: as fast where it rolls, else 2 mu g cos(theta).
  Bounded disk_spin_up() const;
  bool disk_rolls() const { return problem_.slope <= 3 * problem_.friction; }

  /// The integral of f, s, and its integral, s^2: velocity and way are the acceleration times these. time >= 0.
  Bounded velocity_time(double time) const;
  Bounded way_time(double time) const;
  /// What friction takes of the block that slides, over its mass: mu g cos(theta) times the way, each at its time, m^2/s^2.
  Bounded block_friction_work(double time) const;

 private:
  InclineProblem problem_;
};

}  // namespace plumbline::reference
