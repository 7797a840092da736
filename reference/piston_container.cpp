#include "reference/piston_container.hpp"

#include "reference/argument.hpp"
#include "reference/circle.hpp"
#include "reference/interlacing.hpp"

namespace plumbline::reference {
namespace {

constexpr int kept_modes = 2048;  // leaves out 5e-11 of York's amplitude

void check_problem(const PistonContainerProblem& p) {
  check_positive("spring_modulus", p.spring_modulus);
  check_positive("spring_length", p.spring_length);
  check_not_negative("spring_density", p.spring_density);
  check_positive("area", p.area);
  check_positive("mass", p.mass);
  check_positive("gas_density", p.gas_density);
  check_positive("bulk_modulus", p.bulk_modulus);
  check_positive("gas_length", p.gas_length);
  check_finite("velocity", p.velocity);
}

void check_number(int n) { check({"mode", 0, 1, PistonContainer::most_mode, false, false, "", ""}, n); }

struct Range {
  double low, high;
};

/// 1/sin(x)^2; the upper end is infinite where x may be a zero.
Range inverse_square_sine(Bounded x) {
  const Bounded s = sin(x);
  const double low = std::max(0.0, std::abs(s.value) - s.bound), high = std::min(1.0, std::abs(s.value) + s.bound);
  return {1 / (high * high), 1 / (low * low)};
}

}  // namespace

PistonContainer::PistonContainer(const PistonContainerProblem& problem) : problem_(problem) {
  check_problem(problem);
  const PistonContainerProblem& p = problem_;
  spring_ = Bounded(p.spring_modulus) * p.area / p.spring_length;
  gas_ = Bounded(p.bulk_modulus) * p.area / p.gas_length;
  spring_mass_ = heavy() ? Bounded(p.spring_density) * p.area * p.spring_length : Bounded(0);
  gas_mass_ = Bounded(p.gas_density) * p.area * p.gas_length;
  if (heavy()) spring_time_ = sqrt(spring_mass_ / spring_);
  gas_time_ = sqrt(gas_mass_ / gas_);
  const std::vector<Bounded> poles = poles_up_to(kept_modes);
  for (std::size_t n = 1; n <= poles.size(); ++n) {
    const Bounded w = root(static_cast<int>(n), n == 1 ? below_first() : poles[n - 2], poles[n - 1]);
    modes_.push_back({w, share(w)});
  }
  Bounded rest = 1;
  for (const Mode& mode : modes_) rest = rest - mode.share;
  rest_ = std::max(0.0, highest(rest)) * rounding::inflate;
}

std::vector<Bounded> PistonContainer::poles_up_to(int n) const {
  return merged_multiples(pi / gas_time_, heavy() ? pi / spring_time_ : Bounded(rounding::infinity), n);
}

// [0, w] with w surely below the first frequency: the sum of all 1/w_n^2 is the integral of mass times displacement under
// a unit force at its own place (Dunkerley), which is at most y/(E A) at the distance y from a wall.
Bounded PistonContainer::below_first() const {
  const double squares = problem_.mass / (spring_.value + gas_.value) +
                         0.5 * (spring_time_.value * spring_time_.value + gas_time_.value * gas_time_.value);
  const double half = 0.4999 / std::sqrt(squares);
  return {half, half};
}

// The equation times sin(w L/c) sin(w L_s/c_s)/m has no poles. Between the poles n - 1 and n the product of sines has the
// sign (-1)^(n-1), which makes the function below go from negative to positive. Impedances are stiffness times time.
Bounded PistonContainer::root(int n, Bounded below, Bounded above) const {
  const Bounded sign = n % 2 == 1 ? 1.0 : -1.0, m = problem_.mass, z = gas_ * gas_time_ / m;
  if (!heavy()) {
    const Bounded k = spring_ / m;
    auto f = [&](double at) {
      const Bounded w = at, b = w * gas_time_;
      return sign * ((w * w - k) * sin(b) - z * w * cos(b));  // [York 6.2]
    };
    auto slope = [&](double w) {
      const double tau = gas_time_.value, s = std::sin(w * tau), c = std::cos(w * tau);
      return sign.value * (2 * w * s + (w * w - k.value) * tau * c - z.value * (c - w * tau * s));
    };
    return root_between(f, slope, below, above);
  }
  const Bounded z_s = spring_ * spring_time_ / m;
  auto f = [&](double at) {
    const Bounded w = at, a = w * spring_time_, b = w * gas_time_;
    return sign * (w * sin(a) * sin(b) - z_s * cos(a) * sin(b) - z * sin(a) * cos(b));
  };
  auto slope = [&](double w) {
    const double tau_s = spring_time_.value, tau = gas_time_.value;
    const double sa = std::sin(w * tau_s), ca = std::cos(w * tau_s), sb = std::sin(w * tau), cb = std::cos(w * tau);
    return sign.value * (sa * sb + w * (tau_s * ca * sb + tau * sa * cb) -
                         z_s.value * (tau * ca * cb - tau_s * sa * sb) - z.value * (tau_s * ca * cb - tau * sa * sb));
  };
  return root_between(f, slope, below, above);
}

// m/M_n; an interval, because both ends of 1/sin^2 are wanted where the sine may vanish.
Bounded PistonContainer::share(Bounded w) const {
  const double m = problem_.mass, margin = 64 * rounding::unit;
  const Range gas = inverse_square_sine(w * gas_time_);
  const double r = gas_mass_.value / m;
  Range sum{1 + r * gas.low, 1 + r * gas.high};
  if (heavy()) {
    const Range spring = inverse_square_sine(w * spring_time_);
    sum.low += spring_mass_.value / m * spring.low;
    sum.high += spring_mass_.value / m * spring.high;
  } else {
    const Bounded ratio = spring_ / (Bounded(m) * w * w);
    sum.low += lowest(ratio);
    sum.high += highest(ratio);
  }
  const double low = 2 / sum.high * (1 - margin), high = 2 / sum.low * (1 + margin);
  return {0.5 * (low + high), 0.5 * (high - low) * rounding::inflate};
}

double PistonContainer::left_out(int power) const {
  const double v = std::abs(problem_.velocity) * rest_;
  return power == 0 ? v / lowest(modes_.back().omega) * rounding::inflate : v;
}

Bounded PistonContainer::omega(int n) const {
  check_number(n);
  const auto i = static_cast<std::size_t>(n);
  if (i <= modes_.size()) return modes_[i - 1].omega;
  const std::vector<Bounded> poles = poles_up_to(n);
  return root(n, poles[i - 2], poles[i - 1]);
}

Bounded PistonContainer::period(int n) const { return Bounded(2) * pi / omega(n); }

Bounded PistonContainer::modal_mass(int n) const { return Bounded(problem_.mass) / share(omega(n)); }

Bounded PistonContainer::participation(int n) const {
  const Bounded w = omega(n);
  return Bounded(problem_.velocity) * share(w) / w;
}

Bounded PistonContainer::shape(double y, int n) const {
  const double gas = problem_.gas_length, spring = problem_.spring_length;
  check_within("position", y, 0, gas + spring);
  const Bounded w = omega(n);
  if (y == gas) return 1;
  if (y < gas) return sin(w * gas_time_ * y / gas) / sin(w * gas_time_);
  const Bounded share = (Bounded(gas) + spring - y) / spring;
  return heavy() ? sin(w * spring_time_ * share) / sin(w * spring_time_) : share;
}

Bounded PistonContainer::slope(double y, int n) const {
  const double gas = problem_.gas_length, spring = problem_.spring_length;
  check_within("position", y, 0, gas + spring);
  const Bounded b = omega(n) * gas_time_, a = omega(n) * spring_time_;
  if (y <= gas) return b / gas * cos(b * y / gas) / sin(b);
  if (!heavy()) return Bounded(-1) / spring;
  return -(a / spring * cos(a * (Bounded(gas) + spring - y) / spring) / sin(a));
}

Bounded PistonContainer::displacement(double time) const {
  check_not_negative("time", time);
  Bounded sum = 0;
  for (const Mode& mode : modes_) sum = sum + mode.share / mode.omega * sin(mode.omega * time);
  sum = sum * problem_.velocity;
  sum.bound = (sum.bound + left_out(0)) * rounding::inflate;
  return sum;
}

Bounded PistonContainer::velocity(double time) const {
  check_not_negative("time", time);
  Bounded sum = 0;
  for (const Mode& mode : modes_) sum = sum + mode.share * cos(mode.omega * time);
  sum = sum * problem_.velocity;
  sum.bound = (sum.bound + left_out(1)) * rounding::inflate;
  return sum;
}

Bounded PistonContainer::mode_displacement(double time, int n) const {
  check_not_negative("time", time);
  const Bounded w = omega(n);
  return Bounded(problem_.velocity) / w * sin(w * time);
}

Bounded PistonContainer::mode_velocity(double time, int n) const {
  check_not_negative("time", time);
  return Bounded(problem_.velocity) * cos(omega(n) * time);
}

Bounded PistonContainer::mode_energy(int n) const {
  return Bounded(0.5) * modal_mass(n) * problem_.velocity * problem_.velocity;
}

}  // namespace plumbline::reference
