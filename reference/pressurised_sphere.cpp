#include "reference/pressurised_sphere.hpp"

#include "reference/argument.hpp"
#include "reference/circle.hpp"
#include "reference/exponential.hpp"
#include "reference/root.hpp"

namespace plumbline::reference {
namespace {

constexpr double infinity = rounding::infinity;

void check_stretch(double stretch) { check_positive("stretch", stretch); }

[[noreturn]] void refuse(double amplitude) {
  throw ParameterError("amplitude", amplitude, "less: the sphere does not turn on both sides of its equilibrium");
}

/// The sum of a^-i b^-j c^-k with i + j + k = 6 and all at least 1: l^-4[a, b, c].
Bounded inverse_powers(Bounded a, Bounded b, Bounded c) {
  const Bounded x = Bounded(1) / a, y = Bounded(1) / b, z = Bounded(1) / c;
  Bounded sum(0);
  for (int i = 1; i <= 4; ++i) {
    for (int j = 1; i + j <= 5; ++j) sum = sum + power(x, i) * power(y, j) * power(z, 6 - i - j);
  }
  return sum;
}

/// -l^-4[a, b].
Bounded inverse_powers(Bounded a, Bounded b) {
  const Bounded x = Bounded(1) / a, y = Bounded(1) / b;
  Bounded sum(0);
  for (int i = 1; i <= 4; ++i) sum = sum + power(x, i) * power(y, 5 - i);
  return sum;
}

}  // namespace

PressurisedSphere::PressurisedSphere(const PressurisedSphereProblem& problem)
    : problem_(problem),
      law_{problem.youngs_modulus, problem.poisson_ratio, problem.neo_hookean} {
  check_law(law_);
  check_positive("thickness", problem.thickness);
  check_positive("density", problem.density);
  check_positive("radius", problem.radius);
  check_stretch(problem.stretch);
  push_ = Bounded(2) * law_.stress(problem.stretch) / problem.stretch;
}

Bounded PressurisedSphere::stress(double stretch) const {
  check_stretch(stretch);
  return law_.stress(stretch);
}

Bounded PressurisedSphere::resultant(double stretch) const { return Bounded(problem_.thickness) * stress(stretch); }

Bounded PressurisedSphere::pressure(double stretch) const {
  return Bounded(2) * resultant(stretch) / (Bounded(stretch) * problem_.radius);  // [Surface 6]
}

Bounded PressurisedSphere::omega() const {
  const Bounded l(problem_.stretch), rise = l * law_.slope(l) - law_.stress(l);
  return sqrt(Bounded(2) * rise / problem_.density) / problem_.radius;  // [Surface 7]
}

Bounded PressurisedSphere::first_difference(Bounded a, Bounded b) const {
  const Bounded volume = push_ / 3.0 * (a * a + a * b + b * b);
  if (law_.neo_hookean) {
    return Bounded(0.5) * law_.modulus() * (Bounded(2) * (a + b) - inverse_powers(a, b)) - volume;
  }
  const Bounded strains = Bounded(0.5) * ((a - 1.0) * (a + 1.0) + (b - 1.0) * (b + 1.0));
  return Bounded(0.5) * law_.modulus() * strains * (a + b) - volume;
}

Bounded PressurisedSphere::second_difference(Bounded a, Bounded b, Bounded c) const {
  const Bounded volume = push_ / 3.0 * (a + b + c);
  if (law_.neo_hookean) return Bounded(0.5) * law_.modulus() * (inverse_powers(a, b, c) + 2.0) - volume;
  const Bounded squares = a * a + b * b + c * c + a * b + b * c + c * a;
  return Bounded(0.25) * law_.modulus() * (squares - 2.0) - volume;
}

/// The stretch beyond which pressure outweighs the neo-Hookean sheet, infinite where it never does: S/l rises up to
/// 7^(1/6) and falls to 0 from there.
double PressurisedSphere::furthest(double amplitude) const {
  if (!law_.neo_hookean || push_.value <= 0) return infinity;
  const double top = std::pow(7.0, 1.0 / 6);
  if (problem_.stretch >= top) refuse(amplitude);
  auto excess = [this](double l) { return push_.value - 2 * law_.stress(l).value / l; };
  double high = 2 * top;
  while (!(excess(high) > 0)) high *= 2;
  return brent_root(excess, top, high);
}

Bounded PressurisedSphere::turning_stretch(double amplitude) const {
  check_finite("amplitude", amplitude);
  const double rest = problem_.stretch, end = furthest(amplitude);
  const Bounded a = Bounded(rest) + amplitude;
  if (!(lowest(a) > 0) || !(a.value < end)) refuse(amplitude);
  if (amplitude == 0) return rest;
  // Phi(b) - Phi(a) changes sign once on the other side of rest, and Phi[a, b] from - to +
  auto f = [&](double b) { return first_difference(a, b); };
  auto value = [&](double b) { return f(b).value; };
  double low = rest, high = rest;
  if (amplitude > 0) {
    for (int i = 0; i < 60 && !(value(low) < 0); ++i) low *= 0.5;
  } else {
    for (int i = 0; i < 60 && high < end && !(value(high) > 0); ++i) high = std::min(2 * high, end);
  }
  if (!(value(low) < 0) || !(value(high) > 0)) refuse(amplitude);
  const double b = brent_root(value, low, high);
  return enclose_root(f, b, second_difference(a, b, b).value, 0, infinity);
}

Bounded PressurisedSphere::period(double amplitude) const {
  const Bounded a = Bounded(problem_.stretch) + amplitude, b = turning_stretch(amplitude);
  if (amplitude == 0) return Bounded(2) * pi / omega();
  const Bounded middle = Bounded(0.5) * (a + b), half = Bounded(0.5) * (a - b);
  auto rule = [&](int places) {
    Bounded sum(0);
    for (int k = 0; k < places; ++k) {
      const Bounded angle = pi * (2 * k + 1) / (2 * places);
      sum = sum + Bounded(1) / sqrt(second_difference(a, b, middle + half * cos(angle)));  // [Surface 8]
    }
    return pi * problem_.radius * sqrt(Bounded(2) * problem_.density) * sum / places;
  };
  constexpr int most_places = 1 << 14;
  Bounded coarse = rule(8);
  for (int places = 16;; places *= 2) {
    const Bounded fine = rule(places);
    if (std::abs(fine.value - coarse.value) <= fine.bound || places == most_places) return hull(fine, coarse.value);
    coarse = fine;
  }
}

}  // namespace plumbline::reference
