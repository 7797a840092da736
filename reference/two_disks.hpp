#pragma once
// Two equal elastic disks fly at each other along the line of their centres (D. Sulsky, Z. Chen, H. L. Schreyer,
// Comput. Methods Appl. Mech. Eng. 118 (1994) 179). No closed solution is known for the impact; this is what is exact
// without one: free flight before it, momentum and energy at all times.
//
// Not given: a law of contact. In two dimensions the force of two cylinders depends on the size of the bodies through a
// logarithm, and these disks are struck faster than their vibrations can be left out.
#include "reference/bounded.hpp"

namespace plumbline::reference {

/// Per thickness; all but the centres positive. Each has the speed, against the other along the line of the centres,
/// which are further apart than two radii. Defaults: Sulsky's; the speed is that of (0.1, 0.1).
struct TwoDisksProblem {
  double left_x = 0.2, left_y = 0.2;
  double right_x = 0.8, right_y = 0.8;
  double radius = 0.2;
  double youngs_modulus = 1000;
  double poisson = 0.3;
  double density = 1000;
  double speed = 0.141421356237309505;
};

class TwoDisks {
 public:
  /// Throws ParameterError with the key of a value out of range.
  explicit TwoDisks(const TwoDisksProblem& problem = {});

  const TwoDisksProblem& problem() const { return problem_; }
  Bounded mass() const;          // of one disk
  Bounded gap() const;           // at t = 0
  Bounded contact_time() const;  // first touch
  Bounded contact_x() const;     // its place
  Bounded contact_y() const;
  Bounded energy() const;         // total, kinetic at first, seen from the common centre of mass
  Bounded wave_speed() const;     // of pressure waves, plane strain
  Bounded crossing_time() const;  // of such a wave, once through a disk

  /// Strain energy at any time and kinetic energy after the impact are at most energy(). As the momentum of either disk
  /// reverses, its centre of mass stops once: all of its kinetic energy is then elastic or vibration.
  Bounded largest_strain_energy() const { return energy(); }
  /// Total momentum is zero and stays so; that of one disk before the impact, along the line of the centres.
  Bounded momentum_of_one() const;

 private:
  Bounded distance() const;
  TwoDisksProblem problem_;
};

}  // namespace plumbline::reference
