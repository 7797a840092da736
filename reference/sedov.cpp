#include "reference/sedov.hpp"

#include <cmath>

#include "reference/exponential.hpp"
#include "reference/quadrature.hpp"
#include "reference/root.hpp"

namespace plumbline::reference {
namespace {

const SedovProblem& checked(const SedovProblem& problem) {
  check_dimension(problem.dimension);
  check_gamma(problem.gamma);
  if (problem.dimension == 3 && problem.gamma >= 7) {
    throw ParameterError("gamma", problem.gamma, "(1, 7) for dimension 3: beyond it the centre is empty");
  }
  check_positive("density", problem.density);
  check_positive("energy", problem.energy);
  return problem;
}

}  // namespace

// With d = j of Kamm and Timmes, uniform density, N = 2 + d (gamma - 1), M = 2 (gamma - 1) + d and
// D = d (3 - gamma) + 2 (gamma - 1) > 0:
//   x1 = 1 - (gamma - 1)/(2 gamma) (1 - theta)     x2 = theta
//   x3 = 1 + N (gamma - 1)/(gamma D) (1 - theta)   x4 = 1 + (1 - theta)/gamma
//   radius = x1^-a0 theta^kappa x3^-a1,  a0 = 2/(d + 2),  a3 = d/M
// The density theta^a3 x3^a4 x4^a5 has exponents that go as 1/(2 - gamma) with a finite limit; it is taken apart into
// x3^power3 and a logarithm of x3/x4 over 2 - gamma, both regular at gamma = 2.
SedovProfile::SedovProfile(int dimension, double gamma) : d_(dimension), gamma_(gamma) {
  const Bounded d(dimension), less = gamma_ - 1.0;
  const Bounded N = Bounded(2) + d * less, M = Bounded(2) * less + d, D = d * (Bounded(3) - gamma_) + Bounded(2) * less;
  two_minus_gamma_ = Bounded(2) - gamma_;
  a0_ = Bounded(2) / (d + 2.0);
  kappa_ = less / M;
  a3_ = d / M;
  const Bounded two = d + 2.0;
  a1_ = two * gamma_ / N * (Bounded(2) * two_minus_gamma_ * d / (gamma_ * two * two) + kappa_);
  slope1_ = less / (Bounded(2) * gamma_);
  slope3_ = N * less / (gamma_ * D);
  slope4_ = Bounded(1) / gamma_;
  power3_ = Bounded(2) * d / N - ((d * d + 4.0) * less + Bounded(4) * d) / (N * M);
  gap_ = d * (gamma_ + 1.0) / (gamma_ * D);
}

SedovProfile::Factors SedovProfile::factors(Bounded start) const {
  const Bounded theta = pow(start, Bounded(1) / kappa_), rest = Bounded(1) - theta;
  return {theta, Bounded(1) - slope1_ * rest, Bounded(1) + slope3_ * rest, Bounded(1) + slope4_ * rest};
}

Bounded SedovProfile::radius(Bounded start) const {
  const Factors x = factors(start);
  return start * pow(x.x1, -a0_) * pow(x.x3, -a1_);
}

Bounded SedovProfile::stretch(Bounded start) const {
  const Factors x = factors(start);
  return Bounded(1) + x.theta / kappa_ * (a1_ * slope3_ / x.x3 - a0_ * slope1_ / x.x1);
}

SedovProfile::State SedovProfile::at(Bounded start) const {
  const Factors x = factors(start);
  const Bounded q = gap_ * (Bounded(1) - x.theta) / x.x4;  // x3/x4 = 1 - (2 - gamma) q
  const Bounded core = pow(x.x3, power3_) * exp(Bounded(-2) * q * log1m_over(two_minus_gamma_ * q));
  const Bounded warm = pow(x.x1, a0_ * d_) * pow(x.x3, Bounded(-2) * a1_) * x.x4;
  const Bounded thin = pow(x.theta, a3_);
  return {start * pow(x.x1, -a0_) * pow(x.x3, -a1_), x.x1, thin * core, core * warm, warm / thin};
}

Bounded SedovProfile::start_of(Bounded goal) const {
  auto f = [&](double start) { return radius(start) - goal; };
  double guess = goal.value >= 1 ? 1 : 0;
  if (f(0).value < 0 && f(1).value > 0) guess = brent_root([&f](double at) { return f(at).value; }, 0, 1);
  const double slope = guess > 0 ? radius(guess).value * stretch(guess).value / guess : 1;
  return enclose_root(f, guess, slope, 0, 1);
}

Sedov::Sedov(const SedovProblem& problem) : problem_(checked(problem)), profile_(problem.dimension, problem.gamma) {
  const int d = problem.dimension;
  const Bounded gamma(problem.gamma), kinetic_scale = Bounded(2) / (d + 2.0);
  // Kinetic and internal energy have the same scale behind a strong shock: both are u^2/2 there.
  auto density_of_energy = [&](double start) {
    const SedovProfile::State s = profile_.at(start);
    const Bounded velocity = s.x1 * s.radius;
    return (s.density * velocity * velocity + s.pressure) * power(s.radius, d) / start * profile_.stretch(start);
  };
  const Bounded integral = integrate(density_of_energy, 0, 1);
  alpha_ = sphere_measure(d) * kinetic_scale * kinetic_scale * Bounded(2) / ((gamma - 1.0) * (gamma + 1.0)) * integral;
}

Bounded Sedov::shock_radius(double time) const {
  check_positive("time", time);
  const Bounded t(time);
  return pow(Bounded(problem_.energy) * t * t / (alpha_ * problem_.density), Bounded(1) / (problem_.dimension + 2.0));
}

Bounded Sedov::shock_speed(double time) const {
  return Bounded(2) * shock_radius(time) / (Bounded(problem_.dimension + 2.0) * time);
}

double Sedov::time_of_radius(double radius) const {
  check_positive("radius", radius);
  return std::sqrt(alpha_.value * problem_.density * std::pow(radius, problem_.dimension + 2) / problem_.energy);
}

Sample Sedov::behind(double time) const {
  const Bounded gamma(problem_.gamma), speed = shock_speed(time), u = Bounded(2) * speed / (gamma + 1.0);
  return {(gamma + 1.0) / (gamma - 1.0) * problem_.density, u, Bounded(problem_.density) * speed * u,
          Bounded(0.5) * u * u};  // Rankine-Hugoniot in a cold gas (Toro, section 3.1.3)
}

Sample Sedov::sample(double radius, double time) const {
  check_not_negative("radius", radius);
  const Bounded shock = shock_radius(time);
  auto inside = [&]() -> Sample {
    const Sample scale = behind(time);
    const Bounded share = Bounded(radius) / shock;
    const SedovProfile::State s = profile_.at(profile_.start_of(share));
    return {scale.density * s.density, scale.velocity * s.x1 * share, scale.pressure * s.pressure,
            scale.energy * s.energy};
  };
  return beside_front(radius, shock, inside, [this] { return Sample{problem_.density, 0.0, 0.0, 0.0}; });
}

}  // namespace plumbline::reference
