#include "reference/bar_chain.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <initializer_list>

#include "reference/argument.hpp"
#include "reference/chain_run.hpp"

namespace plumbline::reference {
namespace {

/// The same numbers from the chain, from chains of a half and of a quarter of its elements, from a larger tolerance.
using Family = std::array<std::vector<double>, 4>;

Bounded combined(const Family& family, std::size_t k, double scale) {
  const double value = family[0][k] * scale, own = 16 * rounding::unit * std::abs(value);
  const double last = std::abs(family[1][k] - family[0][k]), before = std::abs(family[2][k] - family[1][k]);
  const double elements = std::max(last, 0.5 * before), tolerance = std::abs(family[3][k] - family[0][k]);
  return {value, (elements + tolerance) * std::abs(scale) + own};
}

/// Numbers that an error moves together: one of them may pass its own change by chance, not all.
void share_bound(std::initializer_list<Bounded*> group) {
  double largest = 0;
  for (const Bounded* number : group) largest = std::max(largest, number->bound);
  for (Bounded* number : group) number->bound = largest;
}

void check_chain(const BarChainProblem& p) {
  for (double place : {p.support_x, p.support_y, p.end_x, p.end_y}) check_finite("end_x", place);
  check_positive("mass", p.mass);
  check_positive("gravity", p.gravity);
  check_positive("youngs_modulus", p.youngs_modulus);
  check_positive("area", p.area);
  check_positive("density", p.density);
  check({"strain", 0, -0.5, 0.1, true, true, "1", ""}, p.strain);
  if (p.end_x == p.support_x && p.end_y == p.support_y) throw ParameterError("end_y", p.end_y, "not at the support");
  if (!(p.youngs_modulus * p.area >= 10 * p.mass * p.gravity)) {
    throw ParameterError("youngs_modulus", p.youngs_modulus, "at least 10 mass gravity/area");
  }
}

}  // namespace

BarChainProblem chain_spring_problem() {
  BarChainProblem p{0, 0, 0, -0.3};
  p.mass = 3.33;
  p.gravity = 250;
  p.one_way = false;
  return p;
}

BarChainProblem chain_slack_problem() {
  BarChainProblem p = chain_spring_problem();
  p.end_y = -0.28;
  p.strain = -0.02 / 0.3;
  p.one_way = true;
  return p;
}

BarChain::BarChain(const BarChainProblem& problem, int elements, double tolerance)
    : problem_(problem),
      elements_(elements),
      tolerance_(tolerance) {
  check_chain(problem);
  check_within("elements", elements, 4, 400);
  if (elements % 4 != 0) throw ParameterError("elements", elements, "a multiple of four");
  check_within("tolerance", tolerance, 1e-12, 1e-4);
  const double length = std::hypot(problem.end_x - problem.support_x, problem.end_y - problem.support_y);
  rest_length_ = length / (1 + problem.strain);
  mass_ratio_ = problem.density * problem.area * rest_length_ / problem.mass;
  if (!(mass_ratio_ < 1)) throw ParameterError("density", problem.density, "a string lighter than its end");
}

namespace {

Family all_runs(const BarChainProblem& p, int elements, double tolerance, double rest_length, double mass_ratio,
                const std::function<std::vector<double>(ChainRun&)>& ask) {
  const double stiffness = p.youngs_modulus * p.area / (p.mass * p.gravity);
  const double x = (p.end_x - p.support_x) / rest_length, y = (p.end_y - p.support_y) / rest_length;
  auto answer = [&](int count, double allowed) {
    ChainRun run({count, stiffness, mass_ratio, p.one_way, x, y, allowed});
    return ask(run);
  };
  return {answer(elements, tolerance), answer(elements / 2, tolerance), answer(elements / 4, tolerance),
          answer(elements, 100 * tolerance)};
}

constexpr std::size_t numbers = 9;  // of a state

void append_state(std::vector<double>& out, const ChainRun& run, double start) {
  for (double value : {run.x(), run.y(), run.velocity_x(), run.velocity_y(), std::hypot(run.x(), run.y()),
                       run.support_tension(), run.kinetic(), run.elastic(), run.potential() - start}) {
    out.push_back(value);
  }
}

}  // namespace

std::vector<BarChainState> BarChain::at(std::span<const double> times) const {
  const double second = std::sqrt(rest_length_ / problem_.gravity), speed = std::sqrt(rest_length_ * problem_.gravity);
  const double weight = problem_.mass * problem_.gravity, length = rest_length_, energy = weight * length;
  for (std::size_t n = 0; n < times.size(); ++n) check_within("time", times[n], n == 0 ? 0 : times[n - 1], 1e300);
  const Family family = all_runs(problem_, elements_, tolerance_, rest_length_, mass_ratio_, [&](ChainRun& run) {
    std::vector<double> out;
    const double start = run.potential();
    for (double time : times) {
      run.advance_to(time / second);
      append_state(out, run, start);
    }
    return out;
  });
  std::vector<BarChainState> states;
  for (std::size_t n = 0; n < times.size(); ++n) {
    auto number = [&](std::size_t k, double scale) { return combined(family, numbers * n + k, scale); };
    BarChainState state{number(0, length), number(1, length), number(2, speed),  number(3, speed), number(4, length),
                        number(5, weight), number(6, energy), number(7, energy), number(8, energy)};
    share_bound({&state.x, &state.y, &state.length});
    share_bound({&state.velocity_x, &state.velocity_y});
    share_bound({&state.kinetic, &state.elastic, &state.potential});
    state.x = state.x + problem_.support_x;
    state.y = state.y + problem_.support_y;
    states.push_back(state);
  }
  return states;
}

BarChainState BarChain::at(double time) const { return at(std::span<const double>(&time, 1)).front(); }

std::vector<BarChainTurn> BarChain::turns(ChainTurn kind, int count) const {
  check_within("count", count, 0, 10000);
  if (kind == ChainTurn::swing && problem_.end_x == problem_.support_x) {
    throw ParameterError("end_x", problem_.end_x, "beside the support");
  }
  const Family family = all_runs(problem_, elements_, tolerance_, rest_length_, mass_ratio_, [&](ChainRun& run) {
    std::vector<double> out;
    for (int n = 0; n < count; ++n) {
      run.advance_to_turn(kind == ChainTurn::swing);
      for (double value : {run.time(), run.x(), run.y()}) out.push_back(value);
    }
    return out;
  });
  const double second = std::sqrt(rest_length_ / problem_.gravity);
  std::vector<BarChainTurn> turns{{0.0, problem_.end_x, problem_.end_y}};
  for (std::size_t n = 0; n < family[0].size(); n += 3) {
    BarChainTurn turn{combined(family, n, second), combined(family, n + 1, rest_length_),
                      combined(family, n + 2, rest_length_)};
    share_bound({&turn.x, &turn.y});
    turn.x = turn.x + problem_.support_x;
    turn.y = turn.y + problem_.support_y;
    turns.push_back(turn);
  }
  return turns;
}

Bounded BarChain::period(ChainTurn kind) const { return turns(kind, 2).back().time; }

}  // namespace plumbline::reference
