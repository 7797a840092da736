#include "reference/hanging_chain.hpp"

#include "reference/argument.hpp"
#include "reference/bessel.hpp"
#include "reference/circle.hpp"

namespace plumbline::reference {
namespace {

/// J1(z)/z from its series 1/2 sum (-z^2/4)^m/(m! (m + 1)!) [DLMF 10.2.2] where the quotient would lose digits; for
/// z <= 1 the terms alternate and fall by 8 or more, the tenth is below 1e-18.
Bounded J1_over(Bounded z) {
  if (z.value > 1) return bessel_J1(z) / z;
  const Bounded x = Bounded(-0.25) * z * z;
  Bounded term = 0.5, sum = term;
  for (int m = 1; m < 10; ++m) {
    term = term * x / (m * (m + 1.0));
    sum = sum + term;
  }
  return {sum.value, sum.bound + 1e-18};
}

}  // namespace

Bounded hanging_chain_omega(double length, double gravity, int mode) {
  return Bounded(0.5) * bessel_zero_J0(mode) * sqrt(Bounded(gravity) / length);
}

HangingChain::HangingChain(const HangingChainProblem& problem) : problem_(problem) {
  check_positive("length", problem.length);
  check_positive("gravity", problem.gravity);
  check_positive("line_density", problem.line_density);
  check_finite("amplitude", problem.amplitude);
  zero_ = bessel_zero_J0(problem.mode);
  omega_ = hanging_chain_omega(problem.length, problem.gravity, problem.mode);
}

Bounded HangingChain::period() const { return Bounded(2) * pi / omega_; }

Bounded HangingChain::shape(double s) const {
  check_within("position", s, 0, problem_.length);
  return s == 0 ? Bounded(1) : bessel_J0(zero_ * sqrt(Bounded(s) / problem_.length));
}

Bounded HangingChain::displacement(double s, double time) const {
  check_finite("time", time);
  return Bounded(problem_.amplitude) * shape(s) * cos(omega_ * time);
}

Bounded HangingChain::velocity(double s, double time) const {
  check_finite("time", time);
  return -(Bounded(problem_.amplitude) * omega_ * shape(s) * sin(omega_ * time));
}

// d J0(z)/ds = -J1(z) dz/ds, and dz/ds = z/(2 s) = j^2/(2 L z)
Bounded HangingChain::slope(double s, double time) const {
  check_within("position", s, 0, problem_.length);
  check_finite("time", time);
  const Bounded z = s == 0 ? Bounded(0) : zero_ * sqrt(Bounded(s) / problem_.length);
  const Bounded steepness = zero_ * zero_ / (Bounded(2) * problem_.length) * J1_over(z);
  return -(Bounded(problem_.amplitude) * steepness * cos(omega_ * time));
}

Bounded HangingChain::tension(double s) const {
  check_within("position", s, 0, problem_.length);
  return Bounded(problem_.line_density) * problem_.gravity * s;
}

// 1/2 rho w^2 A^2 int_0^L J0(z)^2 ds, and the integral is L J1(j)^2 [DLMF 10.22.37]
Bounded HangingChain::energy() const {
  const Bounded size = omega_ * problem_.amplitude * bessel_J1(zero_);
  return Bounded(0.5) * problem_.line_density * problem_.length * size * size;
}

Bounded HangingChain::kinetic_energy(double time) const {
  const Bounded s = sin(omega_ * time);
  return energy() * s * s;
}

Bounded HangingChain::potential_energy(double time) const {
  const Bounded c = cos(omega_ * time);
  return energy() * c * c;
}

}  // namespace plumbline::reference
