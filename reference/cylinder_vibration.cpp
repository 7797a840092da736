#include "reference/cylinder_vibration.hpp"

#include <cmath>

#include "reference/argument.hpp"
#include "reference/bessel.hpp"
#include "reference/circle.hpp"
#include "reference/elementary.hpp"
#include "reference/root.hpp"

namespace plumbline::reference {
namespace {

// The n-th positive root of x J_0(x) = share J_1(x), 0 < share < 3/2: between the (n-1)-th zero of J_1 (0 of the first) and
// the n-th of J_0, between which x J_0 - share J_1 changes its sign.
Bounded surface_root(Bounded share, int mode) {
  const double sign = mode % 2 == 0 ? 1 : -1;  // increasing
  const auto f = [&](double x) { return Bounded(sign) * (Bounded(x) * bessel_J0(x) - share * bessel_J1(x)); };
  const double low = mode == 1 ? 1e-3 : bessel_zero_J(1, mode - 1).value, high = bessel_zero_J0(mode).value;
  const double guess = brent_root([&](double x) { return f(x).value; }, low, high);
  const double j0 = bessel_J0(guess).value, j1 = bessel_J1(guess).value;
  const double slope = sign * (j0 - guess * j1 - share.value * (j0 - j1 / guess));
  return enclose_root(f, guess, slope, low, high);
}

}  // namespace

CylinderVibration::CylinderVibration(const CylinderVibrationProblem& problem) : problem_(problem) {
  check_positive("radius", problem.radius);
  check_positive("youngs_modulus", problem.youngs_modulus);
  check({"poisson", 0, -1, 0.5, true, true, "1", ""}, problem.poisson);
  check_positive("density", problem.density);
  check_finite("velocity", problem.velocity);
  check_mode(problem.mode);
  const Bounded nu(problem.poisson), one(1), apart = one - Bounded(2) * nu;
  twice_mu_ = Bounded(problem.youngs_modulus) / (one + nu);
  lambda_ = twice_mu_ * nu / apart;
  speed_ = sqrt((lambda_ + twice_mu_) / problem.density);
  share_ = apart / (one - nu);
  root_ = surface_root(share_, problem.mode);
  edge_ = bessel_J1(root_);
}

Bounded CylinderVibration::period() const { return Bounded(2) * pi / omega(); }

Bounded CylinderVibration::amplitude() const { return abs(Bounded(problem_.velocity)) / omega(); }

Bounded CylinderVibration::shape(double radius) const {
  check_within("radius", radius, 0, problem_.radius);
  return bessel_J1(wavenumber() * radius) / edge_;
}

// At the axis J_1(k r)/r is k/2.
Bounded CylinderVibration::circling(double radius) const {
  check_within("radius", radius, 0, problem_.radius);
  return radius == 0 ? wavenumber() / 2.0 / edge_ : shape(radius) / radius;
}

// J_1'(z) = J_0(z) - J_1(z)/z.
Bounded CylinderVibration::slope(double radius) const {
  return wavenumber() * bessel_J0(wavenumber() * radius) / edge_ - circling(radius);
}

Bounded CylinderVibration::displacement(double radius, double time) const {
  check_finite("time", time);
  return Bounded(problem_.velocity) / omega() * shape(radius) * sin(omega() * time);  // [Graff 8.2]
}

Bounded CylinderVibration::velocity(double radius, double time) const {
  check_finite("time", time);
  return Bounded(problem_.velocity) * shape(radius) * cos(omega() * time);
}

Bounded CylinderVibration::radial_stress(double radius, double time) const {
  check_finite("time", time);
  const Bounded swing = Bounded(problem_.velocity) / omega() * sin(omega() * time);
  return swing * ((lambda_ + twice_mu_) * slope(radius) + lambda_ * circling(radius));
}

Bounded CylinderVibration::hoop_stress(double radius, double time) const {
  check_finite("time", time);
  const Bounded swing = Bounded(problem_.velocity) / omega() * sin(omega() * time);
  return swing * (lambda_ * slope(radius) + (lambda_ + twice_mu_) * circling(radius));
}

// pi rho V^2 times the integral of r J_1(k r)^2 over that of the edge, R^2/2 (1 + (J_0/J_1)^2 - 2/x J_0/J_1), J_0/J_1 = share/x.
Bounded CylinderVibration::energy() const {
  const Bounded v(problem_.velocity), r(problem_.radius), ratio = share_ / root_;
  return pi * problem_.density * v * v * r * r / 2.0 * (Bounded(1) + ratio * ratio - Bounded(2) * ratio / root_);
}

}  // namespace plumbline::reference
