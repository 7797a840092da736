// What the string's own mass does beyond the rigid rod, to first order in mu = rho A L0/m, for a string that starts
// straight and unstretched (relative to the period, T0 = 2 pi sqrt(L/g) for the estimates):
// - The string sags by its inertia and weight, w = mu sin(p) (x^2/2 - x^3/6 - x/3) L; the energy of the sag changes the
//   period by mu^2/90.
// - As it starts straight, it swings about that sag: the slope at the bob, up to mu sin(p)/6, swings with the frequency
//   pi sqrt(g/(mu L)), which shifts a turning point by up to mu^1.5/(12 pi^2), at the start and at the end.
// - It makes the axial swing slower by mu/6; the axial swing, of amplitude 1/kappa, shifts a turning point by up to
//   1/(kappa w T) with w its frequency, and its phase there changes by mu w T/6, or is unknown. The stretch itself
//   changes the period by half of it, of which the string's mass is a share mu.
// The tension at a turning point is m g cos p: a sag, and what follows from it, is larger by 1/cos(p), squared for the
// energy. Each is taken twice.
#include "reference/elastic_pendulum.hpp"

#include <functional>

#include "reference/argument.hpp"
#include "reference/circle.hpp"
#include "reference/elementary.hpp"
#include "reference/elliptic.hpp"
#include "reference/swing.hpp"

namespace plumbline::reference {
namespace {

constexpr double softest = 10, stiffest = 1e9, most_radians = 1e6;

/// Numbers that an integration with some step gives, and the size of what their rounding is relative to.
struct Outcome {
  std::vector<double> values, scales;
  double steps = 0;
};

/// Halves the step until the answer stays within its rounding. The method is of eighth order: where halving still
/// changes the answer, the finer one is better than the change by far. Rounding: a unit of the scale for each step.
std::vector<Bounded> refined(double first_step, const std::function<Outcome(double)>& run) {
  constexpr int most_halvings = 6;
  Outcome coarse = run(first_step);
  std::vector<Bounded> answer(coarse.values.size());
  for (int level = 1; level <= most_halvings; ++level) {
    const Outcome fine = run(std::ldexp(first_step, -level));
    bool settled = true;
    for (std::size_t i = 0; i < answer.size(); ++i) {
      const double change = 2 * std::abs(fine.values[i] - coarse.values[i]);
      const double own = 4 * rounding::unit * (fine.steps + 16) * fine.scales[i];
      settled = settled && change <= own;
      answer[i] = {fine.values[i], change + own};
    }
    if (settled) break;
    coarse = fine;
  }
  return answer;
}

}  // namespace

ElasticPendulumProblem pendulum_at(double length, double angle, ElasticPendulumProblem like) {
  like.pivot_x = like.pivot_y = 0;
  like.bob_x = length * std::sin(angle);
  like.bob_y = -length * std::cos(angle);
  return like;
}

Bounded rigid_pendulum_period(Bounded length, Bounded gravity, Bounded angle) {
  const Bounded half = angle / 2.0;
  return Bounded(4) * sqrt(length / gravity) * elliptic_K(abs(sin(half)), cos(half));  // [Landau 11.1]
}

ElasticPendulum::ElasticPendulum(const ElasticPendulumProblem& problem) : problem_(problem) {
  check_finite("pivot_x", problem.pivot_x);
  check_finite("pivot_y", problem.pivot_y);
  check_finite("bob_x", problem.bob_x);
  check_finite("bob_y", problem.bob_y);
  check_positive("mass", problem.mass);
  check_positive("gravity", problem.gravity);
  check_positive("youngs_modulus", problem.youngs_modulus);
  check_positive("area", problem.area);
  check_not_negative("density", problem.density);
  check({"strain", 0, -0.1, 0.1, true, true, "", ""}, problem.strain);
  const Bounded across = Bounded(problem.bob_x) - problem.pivot_x, down = Bounded(problem.pivot_y) - problem.bob_y;
  if (!(down.value > 0)) throw ParameterError("bob_y", problem.bob_y, "below pivot_y");
  if (across.value == 0) throw ParameterError("bob_x", problem.bob_x, "not straight below the pivot");
  angle_ = atan2(across, down);
  length_ = sqrt(across * across + down * down);
  rest_ = length_ / (Bounded(1) + problem.strain);
  kappa_ = Bounded(problem.youngs_modulus) * problem.area / (Bounded(problem.mass) * problem.gravity);
  unit_time_ = sqrt(rest_ / problem.gravity);
  if (!(kappa_.value >= softest && kappa_.value <= stiffest)) {
    throw ParameterError("youngs_modulus", problem.youngs_modulus, "10 to 1e9 times m g/A");
  }
}

Bounded ElasticPendulum::stiffness() const { return Bounded(problem_.youngs_modulus) * problem_.area / rest_; }

Bounded ElasticPendulum::axial_omega() const { return sqrt(stiffness() / problem_.mass); }

Bounded ElasticPendulum::rigid_period() const { return rigid_pendulum_period(rest_, problem_.gravity, angle_); }

SwingState ElasticPendulum::begin() const { return {kappa_.value * problem_.strain, 0, angle_.value, 0}; }

double ElasticPendulum::first_step() const { return 0.5 / std::sqrt(kappa_.value); }

/// A half swing takes at most pi^2/2 sqrt(L0/g) or so (K at 90 degrees is 1.18 pi/2).
void ElasticPendulum::check_count(int n) const {
  const double most = std::floor(most_radians / (4 * std::sqrt(kappa_.value)));
  check({"n", 0, 0, most, false, false, "", ""}, n);
}

std::vector<PendulumExtreme> ElasticPendulum::extremes(int n) const {
  check_count(n);
  const double size = std::abs(angle_.value);
  auto run = [&](double step) {
    Outcome outcome;
    Swing swing(kappa_.value, problem_.one_way, begin(), step);
    for (int i = 0; i < n; ++i) {
      swing.advance_to_change(3);
      outcome.values.insert(outcome.values.end(), {swing.time(), swing.state()[2]});
      outcome.scales.insert(outcome.scales.end(), {1 + swing.time(), size * (1 + swing.time())});
    }
    outcome.steps = swing.steps();
    return outcome;
  };
  std::vector<PendulumExtreme> all = {{0.0, angle_}};
  const std::vector<Bounded> numbers = n > 0 ? refined(first_step(), run) : std::vector<Bounded>();
  for (std::size_t i = 0; i < numbers.size(); i += 2) all.push_back({numbers[i] * unit_time_, numbers[i + 1]});
  return all;
}

PendulumExtreme ElasticPendulum::extreme(int n) const { return extremes(n).back(); }

std::vector<Bounded> ElasticPendulum::crossings(int n) const {
  check_count(n);
  auto run = [&](double step) {
    Outcome outcome;
    Swing swing(kappa_.value, problem_.one_way, begin(), step);
    for (int i = 0; i < n; ++i) {
      swing.advance_to_change(2);
      outcome.values.push_back(swing.time());
      outcome.scales.push_back(1 + swing.time());
    }
    outcome.steps = swing.steps();
    return outcome;
  };
  std::vector<Bounded> times = n > 0 ? refined(first_step(), run) : std::vector<Bounded>();
  for (Bounded& time : times) time = time * unit_time_;
  return times;
}

Bounded ElasticPendulum::crossing(int n) const {
  if (n < 1) throw ParameterError("n", n, "[1, inf)");
  return crossings(n).back();
}

Bounded ElasticPendulum::period() const { return extreme(2).time; }

Bounded ElasticPendulum::amplitude_ratio() const { return abs(extreme(1).angle) / abs(angle_); }

std::vector<PendulumState> ElasticPendulum::at(std::span<const double> times) const {
  for (std::size_t i = 0; i < times.size(); ++i) {
    check_not_negative("time", times[i]);
    if (i > 0 && times[i] < times[i - 1]) throw ParameterError("time", times[i], "times that do not decrease");
    if (times[i] * axial_omega().value > most_radians) throw ParameterError("time", times[i], "1e6 over axial_omega");
  }
  const double size = std::abs(angle_.value), root = std::sqrt(kappa_.value);
  const double pull = 3 + std::abs(kappa_.value * problem_.strain);  // tension over m g
  auto run = [&](double step) {
    Outcome outcome;
    Swing swing(kappa_.value, problem_.one_way, begin(), step);
    for (double time : times) {
      swing.advance_to(time / unit_time_.value);
      const SwingState& y = swing.state();
      const double later = 1 + swing.time();
      outcome.values.insert(outcome.values.end(), y.begin(), y.end());
      outcome.scales.insert(outcome.scales.end(), {pull, pull * root, size * later, size * later});
    }
    outcome.steps = swing.steps();
    return outcome;
  };
  const std::vector<Bounded> numbers = times.empty() ? std::vector<Bounded>() : refined(first_step(), run);
  std::vector<PendulumState> states;
  for (std::size_t i = 0; i < numbers.size(); i += 4) {
    states.push_back(place(numbers[i], numbers[i + 1], numbers[i + 2], numbers[i + 3]));
  }
  return states;
}

PendulumState ElasticPendulum::at(double time) const { return at(std::span<const double>(&time, 1)).front(); }

PendulumState ElasticPendulum::place(Bounded s, Bounded s_rate, Bounded angle, Bounded angle_rate) const {
  const Bounded r = Bounded(1) + s / kappa_, across = sin(angle), down = cos(angle);
  const Bounded outward = s_rate / kappa_, around = r * angle_rate, speed = rest_ / unit_time_;
  PendulumState state;
  state.length = rest_ * r;
  state.angle = angle;
  state.x = Bounded(problem_.pivot_x) + state.length * across;
  state.y = Bounded(problem_.pivot_y) - state.length * down;
  state.velocity_x = speed * (outward * across + around * down);
  state.velocity_y = speed * (around * across - outward * down);
  if (problem_.one_way) s.value = std::max(s.value, 0.0);
  state.tension = Bounded(problem_.mass) * problem_.gravity * s;
  return state;
}

Bounded ElasticPendulum::string_mass_ratio() const {
  return Bounded(problem_.density) * problem_.area * rest_ / problem_.mass;
}

Bounded ElasticPendulum::string_factor() const {
  if (problem_.density == 0) return 1.0;
  const Bounded mu = string_mass_ratio();
  const double m = highest(mu), stretch = 1 / kappa_.value + std::abs(problem_.strain), p = pi.value;
  const double steepness = 1 / std::cos(angle_.value), turns = 2 * p * std::sqrt(kappa_.value);  // w T
  const double sag = m * m / 90 * steepness * steepness + 2 * m * std::sqrt(m) / (12 * p * p) * steepness;
  const double axial = 0.5 * m * stretch + std::min(2.0, m * turns / 6) * stretch / turns;
  Bounded factor = sqrt((Bounded(1) + mu / 3.0) / (Bounded(1) + mu / 2.0));
  factor.bound += 2 * (sag + axial);
  return factor;
}

Bounded ElasticPendulum::heavy_period() const { return period() * string_factor(); }

}  // namespace plumbline::reference
