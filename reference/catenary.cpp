#include "reference/catenary.hpp"

#include "reference/argument.hpp"
#include "reference/elementary.hpp"
#include "reference/root.hpp"

namespace plumbline::reference {
namespace {

/// v - asinh v for 0 <= v < 1/2 without cancellation: its alternating series, whose terms fall by 4 or more.
Bounded asinh_deficit(double v) {
  const Bounded square = Bounded(v) * v;
  Bounded power = v, sum = 0.0;
  for (int n = 1; n < 40; ++n) {
    power = -(power * square * (2.0 * n - 1) / (2.0 * n));
    sum = sum - power / (2.0 * n + 1);
    if (std::abs(power.value) < rounding::unit * std::abs(sum.value) / 8) break;
  }
  return {sum.value, (sum.bound + std::abs(power.value)) * rounding::inflate};
}

}  // namespace

// With v = L/(2 a) the supports' equation divided by 2 a is F(v) = v d/L - asinh v - w L/(2 E A) = 0. F is convex,
// F(0) <= 0, and falls until v = sqrt((L/d)^2 - 1) if the chain is longer than the span: its positive root is unique.
Catenary::Catenary(const CatenaryProblem& problem) : problem_(problem) {
  check_positive("span", problem.span);
  check_positive("length", problem.length);
  check_positive("weight", problem.weight);
  check_not_negative("compliance", problem.compliance);
  const double d = problem.span, L = problem.length;
  if (problem.compliance == 0 && L <= d)
    throw ParameterError("length", L, "an inextensible chain longer than the span");
  const Bounded ratio = Bounded(d) / L, spare = (Bounded(d) - L) / L;
  const Bounded half = Bounded(0.5) * problem.weight * L * problem.compliance;
  auto f = [&](double v) {
    const Bounded at(v);
    return v < 0.5 ? at * spare + asinh_deficit(v) - half : at * ratio - asinh(at) - half;
  };
  auto value = [&f](double v) { return f(v).value; };
  const double least = L > d ? std::sqrt((L - d) * (L + d)) / d * (1 - 1e-15) : 0;
  double high = std::max(1.0, 2 * least);
  while (value(high) <= 0 && high < 1e300) high *= 2;
  double low = high;
  while (low > least && value(low) >= 0) low *= 0.5;
  low = std::max(low, least);
  const double v = value(low) >= 0 ? low : brent_root(value, low, high), root = std::sqrt(1 + v * v);
  const double slope = spare.value + v * v / (root * (1 + root));
  a_ = Bounded(0.5) * L / enclose_root(f, v, slope, least, rounding::infinity);
}

Bounded Catenary::from_middle(double along) const {
  check_within("position", along, 0, problem_.length);
  return Bounded(along) - Bounded(0.5) * problem_.length;
}

Bounded Catenary::horizontal_force() const { return a_ * problem_.weight; }

Bounded Catenary::tension(double along) const {
  const Bounded q = from_middle(along);
  return Bounded(problem_.weight) * sqrt(a_ * a_ + q * q);
}

Bounded Catenary::support_tension() const { return tension(0); }

Bounded Catenary::x(double along) const {
  const Bounded q = from_middle(along), stretch = horizontal_force() * problem_.compliance * q;
  return Bounded(0.5) * problem_.span + a_ * asinh(q / a_) + (problem_.compliance == 0 ? Bounded(0) : stretch);
}

// sqrt(a^2 + q^2) - sqrt(a^2 + L^2/4) = (q^2 - L^2/4)/(sum of both), and q^2 - L^2/4 = -along (L - along)
Bounded Catenary::y(double along) const {
  const Bounded q = from_middle(along), half = Bounded(0.5) * problem_.length, square = a_ * a_;
  const Bounded rise = Bounded(1) / (sqrt(square + q * q) + sqrt(square + half * half));
  const Bounded stretch = Bounded(0.5) * problem_.weight * problem_.compliance;
  return -(Bounded(along) * (Bounded(problem_.length) - along) * (rise + stretch));
}

Bounded Catenary::sag() const { return -y(0.5 * problem_.length); }

Bounded Catenary::slope_angle(double along) const { return atan(from_middle(along) / a_); }

Bounded Catenary::stretched_length() const {
  const Bounded half = Bounded(0.5) * problem_.length;
  const Bounded pull = half * sqrt(a_ * a_ + half * half) + a_ * a_ * asinh(half / a_);  // int T/w over the chain
  if (problem_.compliance == 0) return problem_.length;
  return Bounded(problem_.length) + Bounded(problem_.weight) * problem_.compliance * pull;
}

}  // namespace plumbline::reference
