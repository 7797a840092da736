#pragma once
// Waves in a finite elastic bar that starts with piecewise constant velocity and stress: d'Alembert's solution, exact
// for linear elasticity. With c = sqrt(E/rho) the invariants
//   w+ = v - stress/(rho c)  and  w- = v + stress/(rho c)
// travel unchanged at +c and -c; a free end reflects one as the other, a fixed end with the sign turned. The bar is
// therefore unfolded: beyond an end follows its mirror image, in which w+ and w- have changed places.
// x is the place of a particle in the unstretched bar; tension is positive.
#include <vector>

#include "reference/unfolded_wave.hpp"

namespace plumbline::reference {

enum class BarEnd { free, fixed };

/// From `from` to the next piece, or the right end.
struct BarPiece {
  double from = 0;
  double velocity = 0;
  double stress = 0;
};

/// {0, velocity 1} and {0.5, velocity 0}, without stress.
std::vector<BarPiece> left_half_moves();

/// The bar is [left, left + length]. Any consistent units; youngs_modulus, density, area, length > 0; the pieces in the
/// order of `from`, the first at `left`.
struct BarRiemannProblem {
  double youngs_modulus = 1e5;
  double density = 1;
  double area = 1;  // of the energies
  double left = 0;
  double length = 1;
  BarEnd left_end = BarEnd::free;
  BarEnd right_end = BarEnd::free;
  std::vector<BarPiece> pieces = left_half_moves();
};

struct BarState {
  Bounded displacement;  // since t = 0
  Bounded velocity, stress;
};

class BarRiemann {
 public:
  /// Throws ParameterError with the key of a value out of range ("from" for the pieces).
  explicit BarRiemann(const BarRiemannProblem& problem);

  const BarRiemannProblem& problem() const { return problem_; }
  Bounded wave_speed() const { return speed_; }
  Bounded impedance() const { return impedance_; }  // rho c
  Bounded transit_time() const { return Bounded(problem_.length) / speed_; }
  /// left <= x <= left + length, time >= 0. At a jump the value on its right; where rounding leaves the side of a jump
  /// open, the bounds cover both.
  BarState state(Bounded x, Bounded time) const;
  Bounded energy() const;    // kinetic + strain, constant
  Bounded momentum() const;  // at t = 0; constant if both ends are free

 private:
  BarRiemannProblem problem_;
  Bounded speed_, impedance_;
  UnfoldedWave rightward_, leftward_;  // the latter in the mirror image of the bar
};

}  // namespace plumbline::reference
