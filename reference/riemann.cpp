#include "reference/riemann.hpp"

#include <algorithm>
#include <string>

#include "reference/parameter.hpp"
#include "reference/root.hpp"

namespace plumbline::reference {
namespace {

void check_state(const GasState& gas, const std::string& side) {
  const double infinity = rounding::infinity;
  check({side + ".density", 0, 0, infinity, false, false, "", ""}, gas.density);
  check({side + ".velocity", 0, -infinity, infinity, false, false, "", ""}, gas.velocity);
  check({side + ".pressure", 0, 0, infinity, false, false, "", ""}, gas.pressure);
  if (gas.density == 0 && gas.pressure != 0) {
    throw ParameterError(side + ".pressure", gas.pressure, "0 where the density is 0 (a vacuum)");
  }
}

void check_problem(const RiemannProblem& problem) {
  check({"gamma", 0, 1, rounding::infinity, true, false, "1", ""}, problem.gamma);
  check_state(problem.left, "left");
  check_state(problem.right, "right");
  if (is_vacuum(problem.left) && is_vacuum(problem.right)) {
    throw ParameterError("left.density", 0, "> 0 on at least one side");
  }
}

/// Same value, the smallest bound: all three are enclosures of one number.
Bounded tightest(Bounded a, Bounded b, Bounded c) {
  Bounded best = a;
  if (b.bound < best.bound) best = b;
  if (c.bound < best.bound) best = c;
  return best;
}

}  // namespace

RiemannSolution::RiemannSolution(const RiemannProblem& problem) : problem_(problem) {
  check_problem(problem);
  if (!is_vacuum(problem.left)) left_.emplace(problem.left, problem.gamma, -1);
  if (!is_vacuum(problem.right)) right_.emplace(problem.right, problem.gamma, +1);
  if (left_ && right_) {
    solve_star();
  } else {
    solve_into_vacuum();
  }
  place_waves();
}

// One gas expands freely: its edge moves with u +- 2 a / (gamma - 1) (Toro, section 4.6).
void RiemannSolution::solve_into_vacuum() {
  vacuum_ = true;
  const WaveCurve& gas = left_ ? *left_ : *right_;
  star_.velocity = gas.velocity_behind(0.0);
  Wave& wave = left_ ? left_wave_ : right_wave_;
  wave = {WaveKind::rarefaction, gas.head(0.0), gas.tail(0.0, star_.velocity)};
  Wave& other = left_ ? right_wave_ : left_wave_;
  other = {WaveKind::none, wave.tail, wave.tail};
}

Bounded RiemannSolution::difference(double p) const {
  const Bounded closing = Bounded(problem_.right.velocity) - problem_.left.velocity;
  return left_->velocity_change(p) + right_->velocity_change(p) + closing;  // [Toro 4.5]
}

Bounded RiemannSolution::star_pressure() const {
  auto f = [this](double p) { return difference(p); };
  const Bounded at_zero = f(0);
  if (lowest(at_zero) >= 0) return 0.0;  // the gases part faster than they can expand [Toro 4.40]
  // The pressure may be any number of decades away from the given ones: the search runs in log p.
  const double closing = problem_.left.velocity - problem_.right.velocity;
  const double ram = std::max(problem_.left.density, problem_.right.density) * closing * closing;
  const double guess = std::log(std::max({problem_.left.pressure, problem_.right.pressure, ram}));
  const double least = -700, greatest = 700;
  double low = std::clamp(guess, least, greatest), high = low;
  for (double step = 1; high < greatest && !(f(std::exp(high)).value > 0); step *= 2)
    high = std::min(high + step, greatest);
  for (double step = 1; low > least && !(f(std::exp(low)).value < 0); step *= 2) low = std::max(low - step, least);
  double p = 0;
  if (f(std::exp(low)).value < 0) {
    p = std::exp(brent_root([&f](double q) { return f(std::exp(q)).value; }, low, high));
    const double slope = left_->slope(p) + right_->slope(p), polished = p - f(p).value / slope;
    if (polished > 0 && std::abs(f(polished).value) <= std::abs(f(p).value)) p = polished;
  }
  const double at = p > 0 ? p : std::exp(least), slope = left_->slope(at) + right_->slope(at);
  const Bounded root = enclose_root(f, p, slope, 0, rounding::infinity);
  // Rounding leaves open whether there is a vacuum: say so with a bound that covers both answers.
  const bool may_be_vacuum = lowest(root) <= 0 && !certainly_below(at_zero, 0.0);
  return may_be_vacuum ? Bounded(0, highest(root) * rounding::inflate) : root;
}

void RiemannSolution::solve_star() {
  const bool both_cold = problem_.left.pressure == 0 && problem_.right.pressure == 0;
  const Bounded p = star_pressure();
  vacuum_ = p.value == 0 && !(both_cold && problem_.left.velocity == problem_.right.velocity);
  const Bounded left_edge = left_->velocity_behind(p), right_edge = right_->velocity_behind(p);
  const Bounded middle = Bounded(0.5) * (left_edge + right_edge);  // [Toro 4.9]
  star_.pressure = p;
  star_.velocity = vacuum_ ? hull(hull(middle, p.bound > 0 ? left_edge : middle), p.bound > 0 ? right_edge : middle)
                           : tightest(middle, left_edge, right_edge);
  auto behind = [&p](const WaveCurve& curve, auto function) {
    return over_interval([&](double q) { return (curve.*function)(q); }, p);
  };
  star_.density_left = behind(*left_, &WaveCurve::density);
  star_.density_right = behind(*right_, &WaveCurve::density);
  star_.energy_left = behind(*left_, &WaveCurve::energy);
  star_.energy_right = behind(*right_, &WaveCurve::energy);
  if (both_cold && !vacuum_ && p.value == 0) {  // two cold gases side by side: nothing happens
    star_.density_left = problem_.left.density;
    star_.density_right = problem_.right.density;
  }
  auto wave = [&](const WaveCurve& curve, Bounded edge) {
    const WaveKind kind = curve.is_shock(p.value) ? WaveKind::shock : WaveKind::rarefaction;
    return Wave{kind, curve.head(p), curve.tail(p, vacuum_ ? edge : star_.velocity)};
  };
  left_wave_ = wave(*left_, left_edge);
  right_wave_ = wave(*right_, right_edge);
}

bool RiemannSolution::has_fan(const std::optional<WaveCurve>& curve, const Wave& wave) const {
  return curve && wave.kind == WaveKind::rarefaction && curve->gas().pressure > 0;
}

void RiemannSolution::place_waves() {
  edges_[0] = left_wave_.head;
  edges_[1] = left_wave_.tail;
  edges_[2] = star_.velocity;
  edges_[3] = right_wave_.tail;
  edges_[4] = right_wave_.head;
  auto given = [this](const std::optional<WaveCurve>& curve) {
    if (!curve) return Sample{0.0, star_.velocity, 0.0, 0.0};
    return Sample{curve->gas().density, curve->gas().velocity, curve->gas().pressure, curve->own_energy()};
  };
  constant_[0] = given(left_);
  constant_[2] = {star_.density_left, star_.velocity, star_.pressure, star_.energy_left};
  constant_[3] = {star_.density_right, star_.velocity, star_.pressure, star_.energy_right};
  constant_[5] = given(right_);
  fan_[1] = has_fan(left_, left_wave_);
  fan_[4] = has_fan(right_, right_wave_);
}

Sample RiemannSolution::in_region(int region, double xi) const {
  if (fan_[region]) {
    const WaveCurve::Ray ray = (region == 1 ? *left_ : *right_).ray(xi);
    return {ray.density, ray.velocity, ray.pressure, ray.energy};
  }
  Sample state = constant_[region];
  if (vacuum_ && (region == 2 || region == 3)) {
    const Bounded left = edges_[1], right = edges_[3];
    const double inside = std::clamp(xi, std::min(left.value, right.value), std::max(left.value, right.value));
    state.velocity = {inside, std::abs(inside - xi)};
    // Whether there is a vacuum at all is not certain: the gas then fills it with a speed between its edges.
    if (star_.pressure.bound > 0) state.velocity = hull(hull({inside, 0}, left), right);
  }
  return state;
}

Sample RiemannSolution::sample(double xi) const {
  int here = 0;
  while (here < 5 && xi >= edges_[here].value) ++here;
  Sample result = in_region(here, xi);
  for (int region = 0; region < 6; ++region) {
    if (region == here || ((region == 1 || region == 4) && !fan_[region])) continue;
    if (region > 0 && certainly_below(xi, edges_[region - 1])) break;
    if (region < 5 && certainly_below(edges_[region], xi)) continue;
    const Sample other = in_region(region, xi);
    result = {hull(result.density, other.density), hull(result.velocity, other.velocity),
              hull(result.pressure, other.pressure), hull(result.energy, other.energy)};
  }
  return result;
}

std::vector<double> RiemannSolution::jumps() const {
  std::vector<double> positions;
  for (int i = 0; i < 5; ++i) {
    if (i == 2 && vacuum_) continue;
    positions.push_back(edges_[i].value);
  }
  std::sort(positions.begin(), positions.end());
  positions.erase(std::unique(positions.begin(), positions.end()), positions.end());
  return positions;
}

}  // namespace plumbline::reference
