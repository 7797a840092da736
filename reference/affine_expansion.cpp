// With y = R/R0, n = d (gamma - 1) and the speed w of the edge at last, the energy gives (R'/w)^2 = 1 - y^-n. What is
// left is a quadrature, t w/R0 = integral from 1 to y of (1 - y^-n)^(-1/2) dy, here as two series of positive terms
// with geometric tails, so that its error is bounded and not estimated. The unknown is q = sqrt(n log y), in which time
// is regular and nearly linear at the start.
#include "reference/affine_expansion.hpp"

#include <gsl/gsl_sf_gamma.h>

#include <limits>

#include "reference/exponential.hpp"
#include "reference/root.hpp"

namespace plumbline::reference {
namespace {

constexpr int most_terms = 100000;  // a hundred are usual

/// Integral from 0 to s of (1 - x^2)^-b dx for s^2 up to about 1/2, b > 1.
Bounded early_series(Bounded s, Bounded b) {
  const Bounded square = s * s;
  Bounded term = s, sum = s;
  for (int k = 0; k < most_terms; ++k) {
    const Bounded ratio = square * (b + k) / (k + 1.0);  // of successive terms; falls with k
    const double next = highest(square) * (highest(b) + k + 1) / (k + 2);
    term = term * ratio;
    const Bounded part = term / (2.0 * k + 3);
    sum = sum + part;
    if (next < 0.9 && part.value <= 0.01 * rounding::unit * sum.value) {
      return {sum.value, sum.bound + highest(part) * next / (1 - next) * rounding::inflate};
    }
  }
  throw std::domain_error("affine_expansion: the series does not converge");
}

/// Integral from 1 to e^growth of (1 - y^-n / 2)^(-1/2) dy.
Bounded late_series(Bounded growth, Bounded n) {
  Bounded coefficient(1), sum(0);
  for (int k = 0; k < most_terms; ++k) {
    const Bounded part = coefficient * growth * expm1_over((Bounded(1) - n * k) * growth);
    sum = sum + part;
    coefficient = coefficient * (k + 0.5) / (2.0 * (k + 1));  // binomial coefficient of (1 - x)^(-1/2), times 2^-k
    if (k > 0 && part.value < 0.01 * rounding::unit * sum.value) {
      return {sum.value, sum.bound + highest(part) * rounding::inflate};  // each further term is at most half the last
    }
  }
  throw std::domain_error("affine_expansion: the series does not converge");
}

}  // namespace

AffineExpansion::AffineExpansion(const AffineExpansionProblem& problem) : problem_(problem), gamma_(problem.gamma) {
  check_dimension(problem.dimension);
  check_positive("radius", problem.radius);
  check_positive("density", problem.density);
  check_positive("pressure", problem.pressure);
  check_gamma(problem.gamma);
  n_ = (gamma_ - 1.0) * problem.dimension;
  final_speed_ = sqrt(Bounded(4) * gamma_ * problem.pressure / (Bounded(problem.dimension) * problem.density)) /
                 (gamma_ - 1.0);
}

/// Time in units of R0 over the speed at last, for q = `root`.
Bounded AffineExpansion::elapsed(double root) const {
  const Bounded z = Bounded(root) * root, half = log(Bounded(2));  // z = n log y
  const Bounded b = Bounded(1) + Bounded(1) / n_;
  if (z.value <= half.value) return Bounded(2) / n_ * early_series(sqrt(-expm1(-z)), b);
  const Bounded until_half = Bounded(2) / n_ * early_series(sqrt(Bounded(0.5)), b);
  return until_half + exp(half / n_) * late_series((z - half) / n_, n_);
}

/// q^2 = n log(R/R0)
Bounded AffineExpansion::log_growth(double time) const {
  if (time == 0) return 0.0;
  const Bounded goal = final_speed_ * time / problem_.radius;
  auto f = [&](double root) { return elapsed(root) - goal; };
  // The edge never moves faster than at last: y <= 1 + goal.
  const double high = std::sqrt(n_.value * std::log1p(goal.value)) * (1 + 1e-9);
  const double root = brent_root([&f](double at) { return f(at).value; }, 0, high);
  const double z = root * root, slope = 2 / n_.value * std::exp(z / n_.value) * root / std::sqrt(-std::expm1(-z));
  const Bounded certain = enclose_root(f, root, slope, 0, rounding::infinity);
  return certain * certain;
}

AffineGas AffineExpansion::at(double time) const {
  check_not_negative("time", time);
  const Bounded z = log_growth(time), log_y = z / n_, d(problem_.dimension);
  AffineGas gas;
  gas.gamma_ = gamma_;
  gas.radius_ = Bounded(problem_.radius) * exp(log_y);
  gas.edge_speed_ = final_speed_ * sqrt(-expm1(-z));
  gas.centre_.density = Bounded(problem_.density) * exp(-(d * log_y));  // the same mass in y^d times the volume
  gas.centre_.pressure = Bounded(problem_.pressure) * exp(-(d * gamma_ * log_y));  // without change of entropy
  gas.centre_.energy = Bounded(problem_.pressure) / ((gamma_ - 1.0) * problem_.density) * exp(-z);
  if (time == 0) {
    gas.radius_ = problem_.radius;
    gas.centre_.density = problem_.density;
    gas.centre_.pressure = problem_.pressure;
  }
  return gas;
}

Sample AffineGas::sample(double r) const {
  check_not_negative("radius", r);
  auto inside = [&]() -> Sample {
    const Bounded xi = Bounded(r) / radius_, exponent = Bounded(1) / (gamma_ - 1.0);
    Bounded profile = (radius_ - r) / radius_ * (Bounded(1) + xi);  // 1 - xi^2
    profile = {std::max(profile.value, 0.0), profile.bound};
    const Bounded thinning = pow(profile, exponent);
    return {centre_.density * thinning, edge_speed_ * xi, centre_.pressure * thinning * profile,
            centre_.energy * profile};
  };
  return beside_front(r, radius_, inside, [this] { return Sample{0.0, edge_speed_, 0.0, 0.0}; });
}

namespace {

/// Integral from 0 to 1 of xi^(d - 1) (1 - xi^2)^a dxi, half the beta function of d/2 and a + 1.
Bounded moment(int dimension, Bounded a) {
  if (dimension == 2) return Bounded(0.5) / (a + 1.0);
  gsl_sf_result beta;
  gsl_sf_lnbeta_e(0.5 * dimension, a.value + 1, &beta);
  // d log B/da lies between -digamma differences of at most d/(2 a)
  const Bounded logarithm{beta.val, 2 * beta.err + 0.5 * dimension * a.bound / a.value};
  return Bounded(0.5) * exp(logarithm);
}

}  // namespace

Bounded AffineExpansion::mass() const {
  const Bounded size = sphere_measure(problem_.dimension) * power(problem_.radius, problem_.dimension);
  return size * problem_.density * moment(problem_.dimension, Bounded(1) / (gamma_ - 1.0));
}

Bounded AffineExpansion::energy() const {  // all of it internal at t = 0
  const Bounded size = sphere_measure(problem_.dimension) * power(problem_.radius, problem_.dimension);
  return size * problem_.pressure / (gamma_ - 1.0) * moment(problem_.dimension, gamma_ / (gamma_ - 1.0));
}

}  // namespace plumbline::reference
