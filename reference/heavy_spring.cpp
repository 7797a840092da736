#include "reference/heavy_spring.hpp"

#include <algorithm>
#include <stdexcept>

#include "reference/circle.hpp"
#include "reference/root.hpp"

namespace plumbline::reference {
namespace {

// Displacements are wanted to `wanted` of the static one. A spring much heavier than its mass would need many more
// modes than `most_modes` for that; it gets a wider bound instead.
constexpr double wanted = 1e-15;
constexpr int most_modes = 1024;

}  // namespace

// h(x) = x sin x - mu cos x has the same roots as x tan x = mu, no poles, and (-1)^(n-1) h increases between the two
// bounds below, since h' = (1 + mu) sin x + x cos x.
Bounded tip_mass_root(Bounded mu, int n) {
  if (n < 1) throw std::invalid_argument("tip_mass_root: n must be at least 1");
  const double sign = n % 2 == 1 ? 1 : -1;
  auto h = [mu, sign](double x) {
    return Bounded(sign) * (Bounded(x) * sin(Bounded(x)) - mu * cos(Bounded(x)));  // [Rao 8.3]
  };
  const double least = (n - 1) * pi.value, greatest = (n - 0.5) * pi.value;
  double low = least, high = greatest;
  if (n == 1) {  // x^2 < x tan x < x^2/(1 - (2x/pi)^2): keeps the bracket small where x is
    low = 0.999 * std::sqrt(mu.value / (1 + 4 * mu.value / (pi.value * pi.value)));
    high = std::min(greatest, 1.001 * std::sqrt(mu.value));
  }
  auto value = [&h](double at) { return h(at).value; };
  // For extreme mu the root falls on an end of its interval within rounding; the bound below still encloses it.
  const double x = value(low) >= 0 ? low : value(high) <= 0 ? high : brent_root(value, low, high);
  const double slope = sign * ((1 + mu.value) * std::sin(x) + x * std::cos(x));
  return enclose_root(h, x, slope, least, greatest);
}

HeavySpring::HeavySpring(const SpringProblem& problem) : problem_(problem), massless_(problem) {
  const Bounded bar = Bounded(problem.density) * problem.area * problem.length;
  mu_ = bar / problem.mass;
  if (problem.density == 0) mu_ = 0.0;
  rest_ = massless_.static_displacement() * (Bounded(1) + mu_ / 2.0);
  if (mu_.value > 0) {
    wave_rate_ = sqrt(Bounded(problem.youngs_modulus) / problem.density) / problem.length;
    choose_modes();
  }
}

void HeavySpring::choose_modes() {
  for (int n = 1; n <= most_modes; ++n) {
    const Bounded x = tip_mass_root(mu_, n);
    // b_n with its factors grouped so that none overflows or vanishes for extreme mass ratios
    const Bounded ratio = mu_ / x, share = mu_ / (x * x + mu_ * mu_ + mu_);
    const Bounded size = Bounded(2) * massless_.static_displacement() * (ratio / x) * share *
                         sqrt(Bounded(1) + ratio * ratio);
    modes_.push_back({n % 2 == 1 ? size : -size, x * wave_rate_});
    if (left_out(0) <= wanted * std::abs(rest_.value)) break;
  }
}

double HeavySpring::left_out(int power) const {
  // x_n > (n - 1) pi; a sum of k^-s over k >= N is below the integral from N - 1/2, and from N - 1/2 >= 1/2 on.
  const double first = modes_.size() - 0.5, mu = highest(mu_), p = pi.value;
  const double fourth = std::pow(first, power - 3) / ((3 - power) * std::pow(p, 4 - power));
  const double third = power < 2 ? std::pow(first, power - 2) / ((2 - power) * std::pow(p, 3 - power)) / lowest(mu_)
                                 : rounding::infinity;
  const double rest = std::abs(massless_.static_displacement().value) + massless_.static_displacement().bound;
  return 2 * rest * mu * mu * std::min(fourth, third) * std::pow(highest(wave_rate_), power) * (1 + 1e-12);
}

Bounded HeavySpring::omega(int n) const {
  if (mu_.value > 0) return tip_mass_root(mu_, n) * wave_rate_;  // [Rao 8.3]
  if (n != 1) throw std::invalid_argument("HeavySpring: a massless spring has one frequency");
  return massless_.omega();
}

Bounded HeavySpring::period() const { return Bounded(2) * pi / omega(); }

Bounded HeavySpring::displacement(double time) const {
  if (modes_.empty()) return massless_.displacement(time);
  Bounded sum = rest_;
  for (const Mode& mode : modes_) sum = sum - mode.amplitude * cos(mode.omega * time);
  sum.bound = (sum.bound + left_out(0)) * rounding::inflate;
  return sum;
}

Bounded HeavySpring::velocity(double time) const {
  if (modes_.empty()) return massless_.velocity(time);
  Bounded sum = 0.0;
  for (const Mode& mode : modes_) sum = sum + mode.amplitude * mode.omega * sin(mode.omega * time);
  sum.bound = (sum.bound + left_out(1)) * rounding::inflate;
  return sum;
}

// At a time t near the extremum at t*, d(t*) differs from d(t) by at most |t* - t|^2 times the largest acceleration.
Bounded HeavySpring::max_displacement() const {
  if (modes_.empty() || rest_.value == 0) return massless_.max_displacement();
  const double down = rest_.value > 0 ? 1 : -1;
  const double half = period().value / 2;
  auto speed = [this, down](double t) { return Bounded(down) * velocity(t); };
  double low = half / 16, high = low;
  while (speed(high).value > 0 && high < 4 * half) {
    low = high;
    high += half / 16;
  }
  const double time = brent_root([&speed](double t) { return -speed(t).value; }, low, high);
  double acceleration = left_out(2);
  for (const Mode& mode : modes_)
    acceleration += highest(mode.omega) * highest(mode.omega) * std::abs(mode.amplitude.value);
  auto falling = [&speed](double t) { return -speed(t); };
  const Bounded at = enclose_root(falling, time, acceleration, low, high);
  Bounded answer = displacement(time);
  answer.bound = (answer.bound + at.bound * at.bound * acceleration) * (1 + 1e-9);
  return answer;
}

}  // namespace plumbline::reference
