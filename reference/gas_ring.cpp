#include "reference/gas_ring.hpp"

#include <gsl/gsl_sf_bessel.h>

#include "reference/argument.hpp"
#include "reference/bessel.hpp"
#include "reference/circle.hpp"
#include "reference/exponential.hpp"
#include "reference/interlacing.hpp"
#include "reference/root.hpp"

namespace plumbline::reference {
namespace {

void check_problem(const GasRingProblem& p) {
  check_positive("youngs_modulus", p.youngs_modulus);
  check({"poisson_ratio", 0, -0.5, 0.5, true, true, "", ""}, p.poisson_ratio);
  check_positive("thickness", p.thickness);
  check_positive("radius", p.radius);
  check_positive("line_mass", p.line_mass);
  check_positive("pressure", p.pressure);
  check_positive("gas_density", p.gas_density);
  check({"gamma", 0, 1, rounding::infinity, true, true, "", ""}, p.gamma);
  check_finite("velocity", p.velocity);
}

/// The n-th positive zero of J1; 0 for n = 0.
Bounded zero_of_J1(int n) {
  if (n == 0) return 0;
  const double guess = gsl_sf_bessel_zero_J1(static_cast<unsigned>(n));
  const double slope = gsl_sf_bessel_J0(guess);  // J1' = J0 - J1/x
  const double sign = slope > 0 ? 1 : -1;
  auto increasing = [sign](double x) { return Bounded(sign) * bessel_J1(x); };
  return enclose_root(increasing, guess, std::abs(slope), 0, 1e4);
}

}  // namespace

GasRing::GasRing(const GasRingProblem& problem) : problem_(problem) {
  check_problem(problem);
  const GasRingProblem& p = problem_;
  const Bounded nu = p.poisson_ratio, r = p.radius;
  modulus_ = Bounded(p.youngs_modulus) / (Bounded(1) - nu * nu);  // [York 5.12]
  const Bounded elastic = modulus_ * p.thickness;
  if (p.law != RingLaw::bare) strain_ = Bounded(p.pressure) * r / elastic;
  stiffness_ = elastic / (r * r);
  if (p.law == RingLaw::accumulated) stiffness_ = stiffness_ * (Bounded(1) - Bounded(2) * strain_);
  speed_ = sqrt(Bounded(p.gamma) * p.pressure / p.gas_density);
  mass_ = Bounded(p.line_mass) / (Bounded(p.gas_density) * r);
  spring_ = stiffness_ * r / (Bounded(p.gamma) * p.pressure);
}

Bounded GasRing::tension() const { return Bounded(problem_.pressure) * problem_.radius; }

Bounded GasRing::unstretched_radius() const {
  const Bounded r = problem_.radius;
  return problem_.law == RingLaw::accumulated ? r / exp(strain_) : r / (Bounded(1) + strain_);
}

Bounded GasRing::dry_omega() const { return sqrt(stiffness_ / problem_.line_mass); }

Bounded GasRing::quasi_static_omega() const {
  const Bounded gas = Bounded(2) * problem_.gamma * problem_.pressure / problem_.radius;
  return sqrt((stiffness_ + gas) / problem_.line_mass);
}

// ((mu z^2 - kappa) J1 - z J0) has no poles; times the sign of J1 it goes from negative to positive at the root.
// kappa > -2 for every law, as gamma > 1: the lowest root is real.
Bounded GasRing::wavenumber(int n) const {
  check({"mode", 0, 1, most_mode, false, false, "", ""}, n);
  const Bounded sign = n % 2 == 1 ? 1.0 : -1.0;
  auto f = [&](double at) {
    const Bounded z = at;
    return sign * ((mass_ * z * z - spring_) * bessel_J1(z) - z * bessel_J0(z));
  };
  auto slope = [&](double z) {  // (z J1)' = z J0
    const double j0 = gsl_sf_bessel_J0(z), j1 = gsl_sf_bessel_J1(z), m = mass_.value, k = spring_.value;
    return sign.value * ((m * z + k / z + z) * j1 + (m * z * z - k - 1) * j0);
  };
  // The zeros' sum of 1/j^2 is 1/8, so up to z = 0.1 z J0/J1 > 2 - 0.26 z^2: the first root lies above twice this.
  const double first = 0.05 * std::min(1.0, std::sqrt((spring_.value + 2) / (mass_.value + 0.25)));
  return root_between(f, slope, n == 1 ? Bounded(first, first) : zero_of_J1(n - 1), zero_of_J1(n));
}

Bounded GasRing::omega(int n) const { return wavenumber(n) * speed_ / problem_.radius; }

Bounded GasRing::period(int n) const { return Bounded(2) * pi / omega(n); }

// pi rho R^2 int over the disc of (J1(k r)/J1(k R))^2 = 1 + q^2 - 2 q/z, q = J0/J1 at z and by the
// equation q = mu z - kappa/z.
Bounded GasRing::modal_mass(int n) const {
  const Bounded z = wavenumber(n), r = problem_.radius, q = mass_ * z - spring_ / z;
  const Bounded disc = Bounded(1) + q * (q - Bounded(2) / z);
  return pi * problem_.gas_density * r * r * (Bounded(2) * mass_ + disc);
}

Bounded GasRing::shape(double r, int n) const {
  check_within("radius", r, 0, problem_.radius);
  if (r == problem_.radius) return 1;
  const Bounded z = wavenumber(n);
  return bessel_J1(z * r / problem_.radius) / bessel_J1(z);
}

Bounded GasRing::pressure_shape(double r, int n) const {
  check_within("radius", r, 0, problem_.radius);
  const Bounded z = wavenumber(n), at = bessel_J0(z * r / problem_.radius);
  return -(Bounded(problem_.gamma) * problem_.pressure / problem_.radius * z * at / bessel_J1(z));
}

Bounded GasRing::displacement(double time, int n) const {
  check_not_negative("time", time);
  const Bounded w = omega(n);
  return Bounded(problem_.velocity) / w * sin(w * time);
}

Bounded GasRing::velocity(double time, int n) const {
  check_not_negative("time", time);
  return Bounded(problem_.velocity) * cos(omega(n) * time);
}

Bounded GasRing::pressure_change(double r, double time, int n) const {
  return pressure_shape(r, n) * displacement(time, n);
}

Bounded GasRing::mode_energy(int n) const {
  return Bounded(0.5) * modal_mass(n) * problem_.velocity * problem_.velocity;
}

}  // namespace plumbline::reference
