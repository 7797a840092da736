#include "reference/bessel.hpp"

#include <gsl/gsl_sf_bessel.h>

#include "reference/argument.hpp"
#include "reference/circle.hpp"
#include "reference/root.hpp"
#include "reference/widened.hpp"

namespace plumbline::reference {
namespace {

constexpr double largest = 1e4, negligible = 1e-17;
constexpr double steepest_J0 = 0.5819, steepest_J1 = 0.5;  // max |J1|, and |J1'| = |J0 - J2|/2

/// A multiple of 4 of places around the circle. The sum leaves out 2 J_(m N) or J_(m N + 1) + J_(m N - 1), m >= 1, with
/// |J_n(x)| <= (x/2)^n/n! [DLMF 10.14.4].
int places(double x) {
  int n = 8;
  auto left_out = [x](int order) { return order * std::log(0.5 * x + 1e-300) - std::lgamma(order + 1.0); };
  while (n < x || left_out(n - 1) > std::log(negligible / 8)) n += 4;
  return n;
}

/// The mean of f(sin t) around the circle, for an f with f(-u) = f(u).
template <class Function>
Bounded mean_around(int places, const Function& f) {
  Bounded sum = Bounded(2) * f(Bounded(0)) + Bounded(2) * f(Bounded(1));
  for (int k = 1; k < places / 4; ++k) sum = sum + Bounded(4) * f(sin(Bounded(2) * pi * k / places));
  Bounded mean = sum / places;
  mean.bound += negligible;
  return mean;
}

void check_argument(Bounded x) {
  if (!(std::abs(x.value) + x.bound <= largest)) throw ParameterError("x", x.value, "[-1e4, 1e4]");
}

}  // namespace

Bounded bessel_J0(Bounded x) {
  check_argument(x);
  const Bounded at(std::abs(x.value));
  const Bounded integral = mean_around(places(at.value), [at](Bounded s) { return cos(at * s); });  // [DLMF 10.9.2]
  return widened(hull(Bounded(gsl_sf_bessel_J0(at.value)), integral), steepest_J0 * x.bound);
}

Bounded bessel_J1(Bounded x) {
  check_argument(x);
  const Bounded at(x.value);
  auto part = [at](Bounded s) { return s * sin(at * s); };  // [DLMF 10.9.2]
  const Bounded integral = mean_around(places(std::abs(x.value)), part);
  return widened(hull(Bounded(gsl_sf_bessel_J1(at.value)), integral), steepest_J1 * x.bound);
}

Bounded bessel_zero_J0(int n) {
  check({"mode", 0, 1, 1000, false, false, "", ""}, n);
  const double sign = n % 2 == 1 ? -1 : 1, guess = gsl_sf_bessel_zero_J0(static_cast<unsigned>(n));
  auto increasing = [sign](double x) { return Bounded(sign) * bessel_J0(x); };
  return enclose_root(increasing, guess, std::abs(gsl_sf_bessel_J1(guess)), 0, largest);
}

}  // namespace plumbline::reference
