#pragma once
// A solid elastic disk that turns steadily about its axis; linear elasticity. Tag [Timoshenko 32]: S. P. Timoshenko,
// J. N. Goodier, Theory of Elasticity, 3rd ed., 1970, section 32. With q = rho omega^2/8, in plane stress,
//   sigma_r = q (3 + nu)(R^2 - r^2),   sigma_theta = q ((3 + nu) R^2 - (1 + 3 nu) r^2),
//   u = q (1 - nu)/E r ((3 + nu) R^2 - (1 + nu) r^2),
// and in plane strain the same with E/(1 - nu^2) for E and nu/(1 - nu) for nu.
#include "reference/bounded.hpp"

namespace plumbline::reference {

enum class PlaneState { stress, strain };

/// All positive, poisson in (-1, 1/2), angular velocity of either sign; strains below 0.1. Per thickness.
struct RotatingDiskProblem {
  double radius = 1;
  double youngs_modulus = 1e4;
  double poisson = 0.3;
  double density = 1;
  double angular_velocity = 1;
  PlaneState plane = PlaneState::stress;
};

/// Radii are those of the disk at rest, in [0, R]. What linear elasticity leaves out is of the order of the strain: the
/// load acts at the displaced radius, radii and section change, and so does the measure of strain. The bounds allow
/// four times the largest strain of the largest value of a kind; that is an estimate, not a proof, and enough for a
/// neo-Hookean law.
class RotatingDisk {
 public:
  /// Throws ParameterError with the key of a value out of range.
  explicit RotatingDisk(const RotatingDiskProblem& problem);

  const RotatingDiskProblem& problem() const { return problem_; }
  double largest_strain() const;  // at the centre

  Bounded displacement(double radius) const;  // radial
  Bounded velocity(double radius) const;      // along the circle, of the displaced point
  Bounded radial_stress(double radius) const;
  Bounded hoop_stress(double radius) const;
  Bounded axial_stress(double radius) const;  // zero in plane stress
  Bounded centre_stress() const;              // (3 + nu)/8 rho omega^2 R^2 in plane stress

  // Of the displaced disk.
  Bounded angular_momentum() const;
  Bounded kinetic_energy() const;
  Bounded strain_energy() const;

 private:
  Bounded bounded(Bounded value, Bounded largest) const;
  Bounded inertia() const;

  RotatingDiskProblem problem_;
  Bounded stiffness_, nu_, load_;  // E, nu as in plane stress; q R^2
};

}  // namespace plumbline::reference
