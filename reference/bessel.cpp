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
constexpr double steepest = 0.7072;                        // |J_n'| = |J_(n-1) - J_(n+1)|/2, |J_n| <= 1/sqrt(2), n >= 1
constexpr int highest_order = 100;

/// A multiple of 4 of places around the circle. The sum leaves out 2 J_(m N) or J_(m N + n) + J_(m N - n) of order n,
/// m >= 1, with |J_k(x)| <= (x/2)^k/k! [DLMF 10.14.4].
int places(double x, int order = 1) {
  int n = 8;
  auto left_out = [x](int k) { return k * std::log(0.5 * x + 1e-300) - std::lgamma(k + 1.0); };
  while (n < x + order || left_out(n - order) > std::log(negligible / 8)) n += 4;
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

void check_order(int order) { check({"order", 0, 0, highest_order, false, false, "", ""}, order); }

void check_zero(int n) { check({"mode", 0, 1, 1000, false, false, "", ""}, n); }

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

Bounded bessel_J(int order, Bounded x) {
  check_order(order);
  check_argument(x);
  const int count = places(std::abs(x.value), order);
  Bounded sum(0);
  for (int k = 0; k < count; ++k) {
    const Bounded turn = Bounded(2) * pi / count;
    sum = sum + cos(Bounded(x.value) * sin(turn * k) - turn * (order * k % count));  // [DLMF 10.9.2]
  }
  const Bounded integral = widened(sum / count, negligible);
  return widened(hull(Bounded(gsl_sf_bessel_Jn(order, x.value)), integral), steepest * x.bound);
}

Bounded bessel_zero_J(int order, int n) {
  check_order(order);
  check_zero(n);
  double zero = gsl_sf_bessel_zero_Jnu(order, static_cast<unsigned>(n));
  double slope = 0;
  for (int i = 0; i < 2; ++i) {  // Newton's steps: GSL's zeros of higher orders keep half of the digits
    slope = 0.5 * (gsl_sf_bessel_Jn(order - 1, zero) - gsl_sf_bessel_Jn(order + 1, zero));
    zero -= gsl_sf_bessel_Jn(order, zero) / slope;
  }
  const double sign = slope > 0 ? 1 : -1;
  auto increasing = [=](double x) { return Bounded(sign) * bessel_J(order, x); };
  return enclose_root(increasing, zero, std::abs(slope), 0, largest);
}

Bounded bessel_zero_J0(int n) {
  check_zero(n);
  const double sign = n % 2 == 1 ? -1 : 1, guess = gsl_sf_bessel_zero_J0(static_cast<unsigned>(n));
  auto increasing = [sign](double x) { return Bounded(sign) * bessel_J0(x); };
  return enclose_root(increasing, guess, std::abs(gsl_sf_bessel_J1(guess)), 0, largest);
}

}  // namespace plumbline::reference
