// The two schemes for gas flows where second computations do not reach: walls of fixed cells, cells that move in the sphere, free
// surfaces on either side, cold gases, means over shells.
#include <cmath>
#include <numeric>

#include "cases/catalog/estimators/answers.hpp"
#include "reference/finite_volume.hpp"
#include "reference/lagrangian_gas.hpp"

namespace plumbline::reference::gas_scheme_trial {
namespace {

void add_state(const std::string& name, const GasState& found, const GasState& exact, KnownAnswers& all) {
  all.push_back({name + ".density", found.density, exact.density, std::max(1.0, std::abs(exact.density))});
  all.push_back({name + ".velocity", found.velocity, exact.velocity, std::max(1.0, std::abs(exact.velocity))});
  all.push_back({name + ".pressure", found.pressure, exact.pressure, std::max(1.0, std::abs(exact.pressure))});
}

// Of polynomials, which a rule of three points integrates; at 2.5 two of them meet. gamma = 1.5: energy 2 p + rho u^2/2.
void add_means(KnownAnswers& all) {
  all.push_back({"volume.plane", shell_volume(1.5, 4, 1), 2.5});
  all.push_back({"volume.cylinder", shell_volume(1.5, 4, 2), (16 - 2.25) / 2});
  all.push_back({"volume.sphere", shell_volume(1.5, 4, 3), (64 - 3.375) / 3, 20});
  for (const int d : {1, 2, 3}) {
    GasProblem problem;
    problem.gamma = 1.5;
    problem.dimension = d;
    problem.jumps = {9, 2.5};
    problem.initial = [](double x) { return x < 2.5 ? GasState{x, 3, x * x} : GasState{2, x, 0.7}; };
    // Of x^n over the shell from a to b.
    const auto moment = [d](int n, double a, double b) { return (std::pow(b, n + d) - std::pow(a, n + d)) / (n + d); };
    const auto low = [&](int n) { return moment(n, 1.5, 2.5); };
    const auto high = [&](int n) { return moment(n, 2.5, 4); };
    const double volume = low(0) + high(0), mass = low(1) + 2 * high(0), momentum = 3 * low(1) + 2 * high(1);
    const double energy = 2 * low(2) + 4.5 * low(1) + 1.4 * high(0) + high(2), velocity = momentum / mass;
    add_state("mean." + std::to_string(d), mean_state(problem, 1.5, 4),
              {mass / volume, velocity, 0.5 * (energy - momentum * velocity / 2) / volume}, all);
  }
}

GasState mirrored(const GasState& gas) { return {gas.density, -gas.velocity, gas.pressure}; }

// Two gases and a wave: nothing of it is symmetric.
GasState uneven(double x) {
  if (x < 0.4) return {1, 0.3, 1};
  return {0.5 + 0.2 * std::sin(7 * x), -0.6, 0.4 + 0.1 * x};
}

// A wall is the middle of a tube of twice the length that holds the image, too; all of it may be turned.
void add_walls(KnownAnswers& all) {
  constexpr int cells = 12;
  GasProblem walled;
  walled.left = GasBoundary::reflecting;
  walled.end_time = 0.25;
  walled.initial = uneven;
  walled.jumps = {0.4};
  GasProblem doubled = walled, turned = walled;
  doubled.low = -1;
  doubled.left = GasBoundary::outflow;
  doubled.initial = [](double x) { return x < 0 ? mirrored(uneven(-x)) : uneven(x); };
  doubled.jumps = {-0.4, 0, 0.4};
  turned.left = GasBoundary::outflow;
  turned.right = GasBoundary::reflecting;
  turned.initial = [](double x) { return mirrored(uneven(1 - x)); };
  turned.jumps = {0.6};
  const FiniteVolumeSolution a = solve_finite_volume(walled, cells), b = solve_finite_volume(doubled, 2 * cells),
                             c = solve_finite_volume(turned, cells);
  all.push_back({"walls.width", b.width(), a.width()});
  for (std::size_t i = 0; i < cells; ++i) {
    const std::string name = std::to_string(i);
    add_state("walled." + name, a.cells[i], b.cells[cells + i], all);
    add_state("turned." + name, mirrored(c.cells[cells - 1 - i]), a.cells[i], all);
  }
  const LagrangianSolution m = solve_lagrangian(walled, lagrangian_mesh(walled, cells)),
                           n = solve_lagrangian(turned, lagrangian_mesh(turned, cells));
  const std::size_t count = m.masses.size();
  for (std::size_t j = 0; j < count; ++j) {
    const std::size_t k = count - 1 - j;
    add_state("moving." + std::to_string(j), {n.density[k], -n.velocity[k], n.pressure[k]},
              {m.density[j], m.velocity[j], m.pressure[j]}, all);
    all.push_back({"moving.energy", n.energy[k], m.pressure[j] / (0.4 * m.density[j])});
    all.push_back({"moving.edge", 1 - n.edges[k], m.edges[j + 1]});
  }
}

double total(const LagrangianSolution& s, const std::vector<double>& of) {
  return std::inner_product(s.masses.begin(), s.masses.end(), of.begin(), 0.0);
}

// Between walls mass, volume and energy stay, however strong the shocks.
void add_totals(KnownAnswers& all) {
  for (const int d : {1, 2, 3}) {
    GasProblem blast;
    blast.dimension = d;
    blast.low = 0.5;
    blast.high = 2;
    blast.left = blast.right = GasBoundary::reflecting;
    blast.end_time = 0.2;
    blast.initial = [](double x) { return x < 1.25 ? GasState{1, 0.5, 30} : GasState{0.6, -1, 0.4}; };
    blast.jumps = {1.25};
    const LagrangianSolution s = solve_lagrangian(blast, lagrangian_mesh(blast, 24));
    const std::string name = "blast" + std::to_string(d);
    const auto shell = [d](double a, double b) { return (std::pow(b, d) - std::pow(a, d)) / d; };
    const double inner = shell(0.5, 1.25), outer = shell(1.25, 2);
    all.push_back(
        {name + ".mass", std::accumulate(s.masses.begin(), s.masses.end(), 0.0), inner + 0.6 * outer, inner + outer});
    std::vector<double> volumes, kinetic;
    for (const double density : s.density) volumes.push_back(1 / density);
    for (const double velocity : s.velocity) kinetic.push_back(velocity * velocity / 2);
    all.push_back({name + ".volume", total(s, volumes), inner + outer, inner + outer});
    const double energy = inner * (30 / 0.4 + 0.125) + outer * (0.4 / 0.4 + 0.3);
    all.push_back({name + ".energy", total(s, s.energy) + total(s, kinetic), energy, energy});
    all.push_back({name + ".wall", s.edges.back(), 2});
  }
}

// One step of a gas at rest: only the cell at the free surface feels it. Its edge leaves with 2 a/(gamma - 1), without pressure.
void add_free_surface(KnownAnswers& all) {
  for (const int d : {1, 2, 3}) {
    GasProblem gas;
    gas.dimension = d;
    gas.low = 0.7;
    gas.high = 1.3;
    gas.left = GasBoundary::reflecting;
    gas.right = GasBoundary::vacuum;
    gas.gamma = 1.5;
    gas.end_time = 1e-3;
    gas.initial = [](double) { return GasState{0.8, 0, 0.3}; };
    const LagrangianSolution s = solve_lagrangian(gas, lagrangian_mesh(gas, 3));
    const std::string name = "free" + std::to_string(d);
    all.push_back({name + ".steps", static_cast<double>(s.steps), 1});
    const double edge = 1.3 + 1e-3 * 4 * std::sqrt(1.5 * 0.3 / 0.8);
    const auto shell = [d](double a, double b) { return (std::pow(b, d) - std::pow(a, d)) / d; };
    const double mass = 0.8 * shell(1.1, 1.3), swept = shell(1.3, edge) / (edge - 1.3);
    const double density = mass / shell(1.1, edge);
    const double velocity = 1e-3 / mass * (std::pow(1.1, d - 1) + swept) / 2 * 0.3;
    all.push_back({name + ".edge", s.edges.back(), edge});
    add_state(name + ".last", {s.density[2], s.velocity[2], s.pressure[2]},
              {density, velocity, 0.3 * std::pow(density / 0.8, 1.5)}, all);
    add_state(name + ".middle", {s.density[1], s.velocity[1], s.pressure[1]}, {0.8, 0, 0.3}, all);
  }
}

// Cold gases that meet without pressure: both are stopped by strong shocks, p = (gamma + 1)/2 rho v^2 with the speed v that each
// loses; of densities as 4 to 1 they lose it as 1 to 2. Of one speed they leave each other alone.
void add_cold_gases(KnownAnswers& all) {
  GasProblem cold;
  cold.gamma = 1.6;
  cold.end_time = 1e-4;
  cold.jumps = {0.5};
  cold.initial = [](double x) { return x < 0.5 ? GasState{4, 2, 0} : GasState{1, -1, 0}; };
  const LagrangianSolution met = solve_lagrangian(cold, lagrangian_mesh(cold, 2));
  all.push_back({"cold.steps", static_cast<double>(met.steps), 1});
  const double pressure = 1.3 * 4 * 1, speed = 1, step = 1e-4;
  all.push_back({"cold.contact", met.edges[1], 0.5 + step * speed});
  all.push_back({"cold.left", met.velocity[0], 2 - step / 2 * pressure});
  all.push_back({"cold.right", met.velocity[1], -1 + step / 0.5 * pressure});
  cold.initial = [](double x) { return x < 0.5 ? GasState{4, -1, 0} : GasState{1, -1, 0}; };
  const LagrangianSolution together = solve_lagrangian(cold, lagrangian_mesh(cold, 2));
  all.push_back({"cold.together", together.edges[1], 0.5 - step});
}

// Pieces of 0.2, 0.3 and 0.5 of ten cells, in pairs: four, two and four, or with three to each place.
void add_mesh(KnownAnswers& all) {
  GasProblem gas;
  gas.low = 1;
  gas.high = 2;
  gas.end_time = 1;
  gas.jumps = {1.5, 1.2, 3, 1, 2};
  const std::vector<double> even = lagrangian_mesh(gas, 10), paired = lagrangian_mesh(gas, 10, 2),
                            placed = lagrangian_mesh(gas, 2, 2, [](double s) { return s * s; });
  const auto same = [&](const std::string& name, const std::vector<double>& found, const std::vector<double>& exact) {
    all.push_back({name + ".size", static_cast<double>(found.size()), static_cast<double>(exact.size())});
    for (std::size_t k = 0; k < std::min(found.size(), exact.size()); ++k) {
      all.push_back({name + "." + std::to_string(k), found[k], exact[k]});
    }
  };
  same("even", even, {1, 1.1, 1.2, 1.3, 1.4, 1.5, 1.6, 1.7, 1.8, 1.9, 2});
  same("paired", paired,
       {1, 1.1, 1.2, 1.275, 1.35, 1.425, 1.5, 1.5 + 0.5 / 6, 1.5 + 1.0 / 6, 1.75, 1.5 + 2.0 / 6, 1.5 + 2.5 / 6, 2});
  same("placed", placed, {1, 1.05, 1.2, 1.275, 1.5, 1.625, 2});
}

}  // namespace
}  // namespace plumbline::reference::gas_scheme_trial

namespace plumbline {

KnownAnswers gas_scheme_answers() {
  using namespace reference::gas_scheme_trial;
  KnownAnswers all;
  add_means(all);
  add_walls(all);
  add_totals(all);
  add_free_surface(all);
  add_cold_gases(all);
  add_mesh(all);
  return all;
}

}  // namespace plumbline
