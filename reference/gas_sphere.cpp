#include "reference/gas_sphere.hpp"

#include <algorithm>
#include <cmath>

#include "reference/argument.hpp"
#include "reference/circle.hpp"
#include "reference/interlacing.hpp"
#include "reference/root.hpp"

namespace plumbline::reference {
namespace {

/// z^2 j1(z), without its pole of rounding at 0.
Bounded turning(Bounded z) { return sin(z) - z * cos(z); }

/// j1(z) for z >= 0: by its series below 1, where sin z/z - cos z loses digits; the terms left out are below 1e-20.
Bounded spherical_j1(Bounded z) {
  if (highest(z) > 1) return turning(z) / (z * z);
  Bounded term = z / 3.0, sum = term;
  const Bounded square = z * z;
  for (int k = 1; k <= 9; ++k) {
    term = -(term * square / (2.0 * k * (2 * k + 3)));  // [DLMF 10.53.1]
    sum = sum + term;
  }
  sum.bound += 1e-20 * std::abs(z.value);
  return sum;
}

/// The n-th positive zero of j1, tan z = z; 0 for n = 0.
Bounded zero_of_j1(int n) {
  if (n == 0) return 0;
  const double asymptote = (n + 0.5) * pi.value, sign = n % 2 == 1 ? -1 : 1;
  // From n pi to the asymptote z sin z keeps its sign, and with it the slope of sin z - z cos z.
  auto increasing = [sign](double z) { return Bounded(sign) * turning(z); };
  const double guess = brent_root([&](double z) { return increasing(z).value; }, n * pi.value, asymptote);
  return enclose_root(increasing, guess, guess, n * pi.value, asymptote);
}

}  // namespace

GasSphere::GasSphere(const GasSphereProblem& problem) : problem_(problem), sheet_(problem.sheet) {
  const PressurisedSphereProblem& s = problem.sheet;
  check({"stretch", 0, 1, rounding::infinity, true, true, "", ""}, s.stretch);
  check_positive("gas_density", problem.gas_density);
  check({"gamma", 0, 1, rounding::infinity, true, true, "", ""}, problem.gamma);
  check_finite("velocity", problem.velocity);
  const EqualStretches law{s.youngs_modulus, s.poisson_ratio, s.neo_hookean};
  const Bounded l(s.stretch);
  radius_ = l * s.radius;
  pressure_ = sheet_.pressure();
  mass_per_area_ = Bounded(s.density) * s.thickness / (l * l);
  stiffness_ = Bounded(2) * s.thickness * (l * law.slope(l) - law.stress(l)) / (radius_ * radius_);
  speed_ = sqrt(Bounded(problem.gamma) * pressure_ / problem.gas_density);
  mass_ = mass_per_area_ / (Bounded(problem.gas_density) * radius_);
  spring_ = stiffness_ * radius_ / (Bounded(problem.gamma) * pressure_);
}

Bounded GasSphere::quasi_static_omega() const {
  return sqrt((stiffness_ + Bounded(3) * problem_.gamma * pressure_ / radius_) / mass_per_area_);
}

// ((mu z^2 - kappa) j1 - z j0) z^2 has no poles; times the sign of j1 it goes from negative to positive at the root.
// kappa > -3 wherever the gas holds the sheet, so that the lowest root is real: k_s R/(gamma p) = (l S'/S - 1)/gamma > -3.
Bounded GasSphere::wavenumber(int n) const {
  check({"mode", 0, 1, most_mode, false, false, "", ""}, n);
  const Bounded sign = n % 2 == 1 ? 1.0 : -1.0;
  auto f = [&](double at) {
    const Bounded z = at;
    return sign * ((mass_ * z * z - spring_) * turning(z) - z * z * sin(z));  // [Surface 17]
  };
  auto slope = [&](double z) {  // (sin z - z cos z)' = z sin z
    const double m = mass_.value, k = spring_.value;
    return sign.value *
           ((m * z * z - k - 2) * z * std::sin(z) + 2 * m * z * (std::sin(z) - z * std::cos(z)) - z * z * std::cos(z));
  };
  // The zeros' sum of 1/j^2 is 1/10, so up to z = 0.1 z j0/j1 > 3 - 0.21 z^2: the first root lies above twice this.
  const double first = 0.05 * std::min(1.0, std::sqrt((spring_.value + 3) / (mass_.value + 0.21)));
  return root_between(f, slope, n == 1 ? Bounded(first, first) : zero_of_j1(n - 1), zero_of_j1(n));
}

Bounded GasSphere::omega(int n) const { return wavenumber(n) * speed_ / radius_; }

Bounded GasSphere::shape(double r, int n) const {
  check_within("radius", r, 0, highest(radius_));
  const Bounded z = wavenumber(n);
  return spherical_j1(z * r / radius_) / spherical_j1(z);
}

Bounded GasSphere::pressure_shape(double r, int n) const {
  check_within("radius", r, 0, highest(radius_));
  const Bounded z = wavenumber(n), at = z * r / radius_;
  const Bounded j0 = r == 0 ? Bounded(1) : sin(at) / at;
  return -(Bounded(problem_.gamma) * pressure_ / radius_ * z * j0 / spherical_j1(z));
}

Bounded GasSphere::velocity(double time, int n) const {
  check_not_negative("time", time);
  return Bounded(problem_.velocity) * cos(omega(n) * time);
}

}  // namespace plumbline::reference
