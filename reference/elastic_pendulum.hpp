#pragma once
// A bob on an elastic string without mass, started at rest (York, section 5.7): two degrees of freedom, integrated by
// GSL's rk8pd; and the pendulum on a rigid string in closed form, T = 4 sqrt(L/g) K(sin(theta0/2)) [Landau 11.1]
// (L. D. Landau, E. M. Lifshitz, Mechanics, 3rd ed., section 11, problem 1).
//
// With the angle p from the vertical, the strain e = r/L0 - 1, s = kappa e the tension over m g, kappa = k L0/(m g),
// and time in units of sqrt(L0/g):   s'' = kappa ((1 + e) p'^2 + cos p - s),   p'' = -(sin p + 2 e' p')/(1 + e).
// A one-way string carries no pressure: where s < 0 it drops out of the first equation. The integration is stopped and
// started again at every such change, so that each piece is smooth; the step is halved until the answer stays, and the
// bound is twice the last change, plus the rounding of all steps.
#include <array>
#include <span>
#include <vector>

#include "reference/bounded.hpp"

namespace plumbline::reference {

/// Pivot and bob at t = 0, any consistent units, gravity along -y; the bob below the pivot and not straight below it.
/// mass, gravity, youngs_modulus, area > 0; density >= 0 (of the string, for heavy_period() alone). `strain`, in
/// (-0.1, 0.1), is that of the string at t = 0. E A/(m g) at least 10. Defaults: York's coordinates (section A.4.5).
struct ElasticPendulumProblem {
  double pivot_x = 0.33333, pivot_y = 0.99990;
  double bob_x = 0.101, bob_y = 0.303;
  double mass = 3.3;
  double gravity = 20;
  double youngs_modulus = 1e6;
  double area = 0.1;
  double density = 0.1;
  double strain = 0;
  bool one_way = true;
};

/// The problem with the pivot at the origin and the bob at that angle from the vertical; the rest as in `like`.
ElasticPendulumProblem pendulum_at(double length, double angle, ElasticPendulumProblem like = {});

struct PendulumState {
  Bounded x, y, velocity_x, velocity_y;
  Bounded angle;    // from the vertical below the pivot, counter-clockwise: negative where x < pivot_x
  Bounded length;   // of the string
  Bounded tension;  // a force
};

/// A turning point of the angle: the angular momentum about the pivot is zero.
struct PendulumExtreme {
  Bounded time, angle;
};

class ElasticPendulum {
 public:
  /// Throws ParameterError with the key of a value out of range.
  explicit ElasticPendulum(const ElasticPendulumProblem& problem);

  const ElasticPendulumProblem& problem() const { return problem_; }
  Bounded angle() const { return angle_; }    // at t = 0
  Bounded length() const { return length_; }  // at t = 0
  Bounded rest_length() const { return rest_; }
  Bounded stiffness() const;     // k = E A/L0
  Bounded axial_omega() const;   // sqrt(k/m)
  Bounded rigid_period() const;  // of a rigid string of the rest length

  /// n = 0 is the start, 1 the turning point on the other side, 2 the one on the side of the start. n >= 0.
  PendulumExtreme extreme(int n) const;
  /// The first n + 1 turning points, 0 to n, in one integration.
  std::vector<PendulumExtreme> extremes(int n) const;
  /// Time of the n-th passage through the vertical, n >= 1.
  Bounded crossing(int n) const;
  std::vector<Bounded> crossings(int n) const;
  /// From the start to the next turning point on the same side: extreme(2).time.
  Bounded period() const;
  /// |angle| of turning point 1 over that of the start.
  Bounded amplitude_ratio() const;

  /// time >= 0; the second form takes times that do not decrease and is cheaper for many. Errors of axial phase grow
  /// with time: so do the bounds.
  PendulumState at(double time) const;
  std::vector<PendulumState> at(std::span<const double> times) const;

  // The string's own mass, rho A L0, to first order.
  Bounded string_mass_ratio() const;  // over the bob's
  /// By which the string's mass changes the period: a uniform rigid rod, sqrt((1 + mu/3)/(1 + mu/2)); the bound covers
  /// what the string does otherwise (see the source).
  Bounded string_factor() const;
  Bounded heavy_period() const;  // period() * string_factor()

 private:
  std::array<double, 4> begin() const;  // as swing.hpp has it
  double first_step() const;
  void check_count(int n) const;
  PendulumState place(Bounded s, Bounded s_rate, Bounded angle, Bounded angle_rate) const;

  ElasticPendulumProblem problem_;
  Bounded angle_, length_, rest_, kappa_, unit_time_;
};

/// 4 sqrt(length/gravity) K(sin(angle/2)) [Landau 11.1], 0 < |angle| < pi.
Bounded rigid_pendulum_period(Bounded length, Bounded gravity, Bounded angle);

}  // namespace plumbline::reference
