#pragma once
// A solid elastic cylinder that breathes without axial strain; linear elasticity. Tag [Graff 8.2]: A. E. H. Love, A Treatise on the
// Mathematical Theory of Elasticity, 4th ed., 1927, chapter XII; K. F. Graff, Wave Motion in Elastic Solids, 1975, section 8.2. With
// c^2 = (lambda + 2 mu)/rho, omega = c k and x = k R,
//   u = V/omega J_1(k r)/J_1(x) sin omega t,  x J_0(x) = (1 - 2 nu)/(1 - nu) J_1(x),
// the second of which leaves the surface free of traction.
#include "reference/bounded.hpp"

namespace plumbline::reference {

/// Any consistent units; all positive but the velocity, -1 < nu < 1/2, mode 1 to 1000.
struct CylinderVibrationProblem {
  double radius = 1;          // R
  double youngs_modulus = 1;  // E
  double poisson = 0.3;       // nu
  double density = 1;         // rho
  double velocity = 1e-5;     // V, radial, of the surface at t = 0
  int mode = 1;
};

/// Per unit length of the cylinder. Radii are those at rest, in [0, R]; of small strains alone.
class CylinderVibration {
 public:
  /// Throws ParameterError with the key of a value out of range.
  explicit CylinderVibration(const CylinderVibrationProblem& problem);

  Bounded wave_speed() const { return speed_; }
  Bounded wavenumber() const { return root_ / problem_.radius; }
  Bounded omega() const { return wavenumber() * speed_; }
  Bounded period() const;
  Bounded amplitude() const;  // |V|/omega

  // Throw ParameterError "radius" or "time".
  Bounded displacement(double radius, double time) const;  // radial
  Bounded velocity(double radius, double time) const;
  Bounded radial_stress(double radius, double time) const;
  Bounded hoop_stress(double radius, double time) const;
  Bounded energy() const;  // of motion and strain, of the whole section

 private:
  Bounded shape(double radius) const;     // J_1(k r)/J_1(x)
  Bounded slope(double radius) const;     // its derivative
  Bounded circling(double radius) const;  // itself over r

  CylinderVibrationProblem problem_;
  Bounded lambda_, twice_mu_, speed_, share_, root_, edge_;  // share: (1 - 2 nu)/(1 - nu); root: x; edge: J_1(x)
};

}  // namespace plumbline::reference
