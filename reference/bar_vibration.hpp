#pragma once
// Longitudinal vibration of an elastic bar, fixed at x = 0, free at x = L: modes sin k x, k = (2n - 1) pi/(2L), w = k
// c, c = sqrt(E/rho). Exact for linear elasticity; x is the place of a particle in the unstretched bar.
#include "reference/bounded.hpp"

namespace plumbline::reference {

/// One mode, started unstretched with the velocity v0 sin k x. Any consistent units; all positive, the velocity may
/// have any sign. For plane strain or plane stress the modulus is the one of that law. Defaults: the vibrating bar of
/// D. Sulsky, Z. Chen, H. L. Schreyer, 1994, as used since.
struct BarVibrationProblem {
  double youngs_modulus = 100;
  double density = 1;
  double area = 1;  // of the energies
  double length = 25;
  double velocity = 0.1;  // v0, at the free end of the first mode
  int mode = 1;
};

/// Positions 0 <= x <= length; times have any sign.
class BarVibration {
 public:
  /// Throws ParameterError with the key of a value out of range.
  explicit BarVibration(const BarVibrationProblem& problem);

  const BarVibrationProblem& problem() const { return problem_; }
  Bounded wave_speed() const { return speed_; }
  Bounded wavenumber() const { return wavenumber_; }
  Bounded omega() const { return omega_; }
  Bounded period() const;
  Bounded amplitude() const;  // largest displacement, v0/w
  Bounded displacement(double x, double time) const;
  Bounded velocity(double x, double time) const;
  Bounded strain(double x, double time) const;
  Bounded stress(double x, double time) const;
  Bounded mean_velocity(double time) const;  // of the centre of mass
  Bounded energy() const;
  Bounded kinetic_energy(double time) const;
  Bounded strain_energy(double time) const;

 private:
  Bounded shape(double x) const;
  Bounded slope(double x) const;

  BarVibrationProblem problem_;
  Bounded speed_, wavenumber_, omega_;
};

}  // namespace plumbline::reference
