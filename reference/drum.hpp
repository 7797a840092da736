#pragma once
// Small vibration of a circular membrane with a fixed rim under uniform tension T, mass per area m (Lord Rayleigh, The
// Theory of Sound, sections 199-206): with j = j_mn the n-th positive zero of J_m,
//   w = J_m(j r/a) cos(m phi) cos(omega t),  omega = j/a sqrt(T/m). [Surface 9]
// A sheet of plane stress after St. Venant and Kirchhoff, stretched by l along both tangents, has T = t S along every
// direction (equal_stretches.hpp) and m = rho t/l^2 with thickness and density at rest.
#include "reference/bounded.hpp"

namespace plumbline::reference {

/// Any consistent units; all positive.
struct DrumProblem {
  double radius = 1;        // a
  double tension = 1;       // T, force per length
  double area_density = 1;  // m, mass per area
};

/// All positive, -1 < nu <= 1/2, stretch > 1; the radius is that of the drum as it is stretched.
struct PrestretchedSheet {
  double youngs_modulus = 1;
  double poisson_ratio = 0.3;
  double thickness = 0.01;  // at rest
  double density = 1;       // at rest
  double stretch = 1.05;
  double radius = 1;
};

/// Modes have `around` nodal diameters, 0 to 100, and `across` nodal circles with the rim, 1 to 1000.
class Drum {
 public:
  /// Throws ParameterError with the key of a value out of range.
  explicit Drum(const DrumProblem& problem = {});

  Bounded tension() const { return tension_; }
  Bounded area_density() const { return area_density_; }
  Bounded wave_speed() const;
  /// ParameterError "order" or "mode".
  Bounded omega(int around, int across = 1) const;
  /// J_m(j r/a), the mode along its meridian phi = 0, 0 <= r <= radius; ParameterError "position".
  Bounded shape(int around, double r, int across = 1) const;

 private:
  friend Drum drum_of(const PrestretchedSheet& sheet);

  double radius_ = 1;
  Bounded tension_, area_density_;
};

/// Throws ParameterError with the key of a value out of range.
Drum drum_of(const PrestretchedSheet& sheet);

}  // namespace plumbline::reference
