#include "reference/converged_gas.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <mutex>
#include <tuple>

#include "reference/parameter.hpp"

namespace plumbline::reference {
namespace {

constexpr std::array<double GasFields::*, 4> fields = {&GasFields::density, &GasFields::velocity, &GasFields::pressure,
                                                       &GasFields::energy};

/// |a - b|, field by field
GasFields distance(const GasFields& a, const GasFields& b) {
  GasFields d;
  for (auto f : fields) d.*f = std::abs(a.*f - b.*f);
  return d;
}

/// Largest value of each field over the two cells of the medium mesh on either side: a front that two meshes place
/// differently is uncertain all around it.
std::vector<GasFields> widened(const std::vector<GasFields>& own) {
  const std::size_t reach = 4;
  std::vector<GasFields> wide(own.size());
  for (std::size_t j = 0; j < own.size(); ++j) {
    for (std::size_t k = j > reach ? j - reach : 0; k < std::min(own.size(), j + reach + 1); ++k) {
      for (auto f : fields) wide[j].*f = std::max(wide[j].*f, own[k].*f);
    }
  }
  return wide;
}

}  // namespace

ConvergedGas::ConvergedGas(const ConvergedGasProblem& problem, int cells) : problem_(problem) {
  auto solve = [&](int parts) {
    const auto mesh = lagrangian_mesh(problem.gas, cells * parts / 4, parts, problem.place);
    return solve_lagrangian(problem.gas, mesh);
  };
  const LagrangianSolution coarse = solve(1), medium = solve(2);
  fine_ = solve(4);
  compare(medium, coarse);
}

bool ConvergedGas::is_vacuum(const LagrangianSolution& solution, double x) const {
  return (x < solution.edges.front() && problem_.gas.left == GasBoundary::vacuum) ||
         (x > solution.edges.back() && problem_.gas.right == GasBoundary::vacuum);
}

GasFields ConvergedGas::value(const LagrangianSolution& solution, double x) const {
  const GasProblem& gas = problem_.gas;
  if (is_vacuum(solution, x)) return {0, solution.at(x).velocity, 0, 0};
  const bool before = x < solution.edges.front() && gas.left == GasBoundary::outflow;
  const bool beyond = x > solution.edges.back() && gas.right == GasBoundary::outflow;
  if (!before && !beyond) return solution.at(x);
  const double speed = gas.initial(before ? gas.low : gas.high).velocity;
  const GasState state = gas.initial(x - speed * gas.end_time);
  return {state.density, state.velocity, state.pressure, state.pressure / ((gas.gamma - 1) * state.density)};
}

void ConvergedGas::compare(const LagrangianSolution& medium, const LagrangianSolution& coarse) {
  const std::size_t cells = fine_.masses.size();
  std::vector<GasFields> finer(cells), coarser(cells);
  GasFields finer_sum, coarser_sum;
  const int points = 5;
  for (std::size_t j = 0; j < cells; ++j) {
    const double a = fine_.edges[j], b = fine_.edges[j + 1], volume = shell_volume(a, b, problem_.gas.dimension);
    for (int i = 0; i < points; ++i) {
      const double x = a + (b - a) * (i + 0.5) / points;
      const GasFields middle = value(medium, x);
      const GasFields near = distance(fine_.at(x), middle), far = distance(middle, value(coarse, x));
      const bool inside = x >= problem_.low && x <= problem_.high;
      for (auto f : fields) {
        finer[j].*f = std::max(finer[j].*f, near.*f);
        coarser[j].*f = std::max(coarser[j].*f, far.*f);
        finer_sum.*f += inside ? volume / points * near.*f : 0;
        coarser_sum.*f += inside ? volume / points * far.*f : 0;
      }
    }
  }
  // Up to the end of the domain it is the last cell's bound that holds beyond a free surface.
  const double whole = shell_volume(problem_.low, problem_.high, problem_.gas.dimension);
  finer = widened(finer);
  coarser = widened(coarser);
  bounds_.resize(cells);
  for (auto f : fields) {
    order_.*f = finer_sum.*f > 0 ? std::log2(coarser_sum.*f / finer_sum.*f) : 2;
    const double order = std::clamp(order_.*f, 0.5, problem_.gas.isentropic ? 2.0 : 1.0);
    const double fall = std::exp2(-order), factor = 1.25 * fall / (1 - fall);
    error_.*f = factor * std::max(finer_sum.*f, fall * coarser_sum.*f) / whole;
    for (std::size_t j = 0; j < cells; ++j) {
      bounds_[j].*f = factor * std::max(finer[j].*f, fall * coarser[j].*f);
    }
    if (problem_.gas.right == GasBoundary::vacuum && fine_.edges.back() < problem_.high) {
      const double beyond = shell_volume(fine_.edges.back(), problem_.high, problem_.gas.dimension);
      error_.*f += beyond_edge().*f * beyond / whole;
    }
  }
}

/// Bound between the last edge and the true front: also what is known of the front must lie within.
GasFields ConvergedGas::beyond_edge() const {
  GasFields bound = bounds_.back();
  if (problem_.front_speed) {
    bound.velocity = std::max(bound.velocity, std::abs(*problem_.front_speed - fine_.velocity.back()));
  }
  return bound;
}

Sample ConvergedGas::sample(double x) const {
  const GasFields at = value(fine_, x);
  GasFields bound;
  if (problem_.front_speed && x >= problem_.high) return {0.0, *problem_.front_speed, 0.0, 0.0};
  if (x >= fine_.edges.front() && x <= fine_.edges.back()) bound = bounds_[fine_.cell_of(x)];
  if (is_vacuum(fine_, x)) bound = x < fine_.edges.front() ? bounds_.front() : beyond_edge();
  auto bounded = [&](double GasFields::*f) { return Bounded(at.*f, bound.*f + 4 * rounding::unit * std::abs(at.*f)); };
  return {bounded(fields[0]), bounded(fields[1]), bounded(fields[2]), bounded(fields[3])};
}

double ConvergedGas::steepest() const {
  std::size_t at = 1;
  double most = 0;
  for (std::size_t j = 1; j < fine_.pressure.size(); ++j) {
    const double jump = std::abs(fine_.pressure[j] - fine_.pressure[j - 1]);
    if (jump > most) {
      most = jump;
      at = j;
    }
  }
  return fine_.edges[at];
}

ConvergedGasProblem shu_osher_reference(double end_time, double amplitude, double wave_number) {
  GasProblem gas = shu_osher_problem();
  const GasState behind = gas.initial(-5);
  gas.initial = [=](double x) { return x < -4 ? behind : GasState{1 + amplitude * std::sin(wave_number * x), 0, 1}; };
  gas.end_time = end_time;
  // Only what the waves reach until then is solved: left with the sound behind the shock, 2 a little, right with the
  // shock, whose speed in the lightest gas is below 4 for amplitudes below 1/4.
  gas.low = -4 - 2.2 * end_time;
  gas.high = -4 + 4 * end_time;
  return {gas, -5, 5, {}, {}};
}

ConvergedGasProblem woodward_colella_reference(double end_time) {
  GasProblem gas = woodward_colella_problem();
  gas.end_time = end_time;
  return {gas, 0, 1, {}, {}};
}

ConvergedGasProblem gas_expansion_reference(double radius, double end_time) {
  // In a fan that ends in vacuum sound speed goes as mass to the power (gamma - 1)/(gamma + 1) = 1/6: towards the
  // surface the cells shrink exponentially, down to what double precision can place, so that it falls by 100.
  auto place = [](double s) { return 1 - (1 - s) * std::exp(-20 * s * s * s * s); };
  const GasProblem gas = gas_expansion_problem(radius, end_time);
  return {gas, 0, gas_expansion_front(radius, end_time).value, place, 5 * std::sqrt(140)};  // 2 c0/(gamma - 1)
}

const ConvergedGas& shu_osher() {
  static const ConvergedGas solution(shu_osher_reference(), shu_osher_cells);
  return solution;
}

const ConvergedGas& woodward_colella() {
  static const ConvergedGas solution(woodward_colella_reference(), woodward_colella_cells);
  return solution;
}

const ConvergedGas& gas_expansion(double radius, double end_time, int cells) {
  check({"radius", 0, 0, rounding::infinity, true, true, "m", ""}, radius);
  const double sound = std::sqrt(1.4 * 100);
  check({"time", 0, 0, 0.8 * radius / sound, true, false, "s", ""}, end_time);
  static std::mutex mutex;
  static std::map<std::tuple<double, double, int>, ConvergedGas> solutions;
  const std::lock_guard lock(mutex);
  const auto known = solutions.find({radius, end_time, cells});
  if (known != solutions.end()) return known->second;
  const auto problem = gas_expansion_reference(radius, end_time);
  return solutions.try_emplace({radius, end_time, cells}, problem, cells).first->second;
}

const ConvergedGas& gas_expansion() { return gas_expansion(0.38, 0.005); }

Bounded gas_expansion_head(double radius, double time) {
  return Bounded(radius) - sqrt(Bounded(140)) * time;  // c0^2 = gamma p/rho = 140
}

Bounded gas_expansion_front(double radius, double time) {
  return Bounded(radius) + Bounded(5) * sqrt(Bounded(140)) * time;  // 2/(gamma - 1) = 5
}

}  // namespace plumbline::reference
