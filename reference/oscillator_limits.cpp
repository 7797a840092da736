#include "reference/oscillator_limits.hpp"

#include "reference/argument.hpp"

namespace plumbline::reference {
namespace {

SquareMatrix rows(std::initializer_list<double> entries, int size) {
  SquareMatrix matrix(size);
  matrix.entries.assign(entries);
  return matrix;
}

// R(z) = 1 + z + z^2/2 + ... up to the order, z = w dt ((0, 1), (-1, 0)): even terms on the diagonal, odd ones beside.
SquareMatrix taylor(double omega_dt, int order) {
  double even = 0, odd = 0, term = 1;
  for (int k = 0; k <= order; ++k, term *= omega_dt / k) {
    const double sign = k / 2 % 2 == 0 ? 1 : -1;
    (k % 2 == 0 ? even : odd) += sign * term;
  }
  return rows({even, odd, -odd, even}, 2);
}

// u' = u + w v - w^2 ((1/2 - beta) u + beta u'), v' = v - w (u + u')/2, v in units of the frequency.
SquareMatrix newmark(double w, double beta) {
  const double share = 1 / (1 + beta * w * w), own = share * (1 - (0.5 - beta) * w * w);
  return rows({own, share * w, -share * w * (1 - (0.25 - beta) * w * w), own}, 2);
}

SquareMatrix generalized_alpha(double w, double r) {
  const double alpha_m = (2 * r - 1) / (1 + r), gamma = 1.5 - alpha_m;
  const double beta = (5 - 3 * r) / ((1 + r) * (1 + r) * (2 - r));
  const double by_d = -w * w / (1 - alpha_m), by_a = -alpha_m / (1 - alpha_m);  // a' = by_d d + by_a a
  return rows({1 + beta * by_d, 1, 0.5 - beta + beta * by_a,                    //
               gamma * by_d, 1, 1 - gamma + gamma * by_a,                       //
               by_d, 0, by_a},
              3);
}

}  // namespace

Bounded oscillator_limit(OscillatorMethod method, double rho_b) {
  switch (method) {  // [Oscillator 1]
    case OscillatorMethod::forward_euler:
    case OscillatorMethod::explicit_midpoint:
      return 0;
    case OscillatorMethod::symplectic_euler:
    case OscillatorMethod::leapfrog:
      return 2;
    case OscillatorMethod::ssp_rk3:
      return sqrt(Bounded(3));
    case OscillatorMethod::rk4:
      return sqrt(Bounded(8));
    case OscillatorMethod::newmark_trapezoid:
      return rounding::infinity;
    case OscillatorMethod::newmark_linear:
      return sqrt(Bounded(12));
    case OscillatorMethod::generalized_alpha:
      break;
  }
  return generalized_alpha_stability_limit(rho_b);
}

int oscillator_order(OscillatorMethod method) {
  switch (method) {
    case OscillatorMethod::forward_euler:
    case OscillatorMethod::symplectic_euler:
      return 1;
    case OscillatorMethod::ssp_rk3:
      return 3;
    case OscillatorMethod::rk4:
      return 4;
    default:
      return 2;
  }
}

SquareMatrix oscillator_amplification(OscillatorMethod method, double omega_dt, double rho_b) {
  check_not_negative("omega_dt", omega_dt);
  const double w = omega_dt;
  switch (method) {
    case OscillatorMethod::forward_euler:
      return taylor(w, 1);
    case OscillatorMethod::explicit_midpoint:
      return taylor(w, 2);
    case OscillatorMethod::symplectic_euler:
      return rows({1 - w * w, w, -w, 1}, 2);
    case OscillatorMethod::leapfrog:
      return newmark(w, 0);
    case OscillatorMethod::ssp_rk3:
      return taylor(w, 3);
    case OscillatorMethod::rk4:
      return taylor(w, 4);
    case OscillatorMethod::newmark_trapezoid:
      return newmark(w, 0.25);
    case OscillatorMethod::newmark_linear:
      return newmark(w, 1.0 / 6);
    case OscillatorMethod::generalized_alpha:
      break;
  }
  check_within("rho_b", rho_b, 0, 1);
  return generalized_alpha(w, rho_b);
}

// No entry is a difference of numbers larger than the largest entry, but of some twenty of its roundings.
Bounded oscillator_growth(OscillatorMethod method, double omega_dt, double rho_b) {
  return spectral_radius(oscillator_amplification(method, omega_dt, rho_b), 40 * rounding::unit);
}

Bounded generalized_alpha_bifurcation_limit(double rho_b) {
  check_within("rho_b", rho_b, 0, 1);
  return (Bounded(1) + rho_b) * sqrt(Bounded(2) - rho_b);  // [Oscillator 2]
}

Bounded generalized_alpha_stability_limit(double rho_b) {
  check_within("rho_b", rho_b, 0, 1);
  const Bounded r(rho_b);
  return sqrt(Bounded(12) * (Bounded(1) + r) * (Bounded(2) - r) /
              (Bounded(10) - Bounded(5) * r + r * r));  // [Oscillator 3]
}

}  // namespace plumbline::reference
