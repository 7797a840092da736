// What is made of final states that other programs hand in: a gas of a few points, thrown in the plane between two walls.
#include <cmath>
#include <memory>

#include "cases/catalog/estimators/answers.hpp"
#include "cases/harness/exchange/balance.hpp"
#include "kernel/materials/ideal_gas.hpp"

namespace plumbline {
namespace {

constexpr double thrown_until = 2;                               // s
constexpr double pull = 0.3, push = 0.4, speed_of_piston = 0.7;  // m/s^2 along y, m/s^2 along y by a load, m/s along x
constexpr int thrown_points = 5;

struct Surroundings {
  bool gravity = false, load = false, piston = false, walls = false;
};

class ThrownGas final : public Problem, public JudgedAtEnd {
 public:
  explicit ThrownGas(const Surroundings& around) : around_(around) {}
  double end_time() const override { return thrown_until; }
  Profile profile(const Simulation&) const override { return {}; }

  Scene scene() const override {
    Scene all;
    all.grid.dim = 2;
    all.grid.h = 0.5;
    all.grid.cells = {8, 8, 1};
    if (around_.walls) all.grid.walls[0] = {Wall::symmetry, Wall::free};
    if (around_.gravity) all.gravity = {0, -pull, 0};
    if (around_.piston) all.pistons.push_back({0, 0, 0.1, speed_of_piston, 0});
    Body gas = make_body("gas", std::make_shared<IdealGas>(), thrown_points, 2);
    for (int p = 0; p < thrown_points; ++p) {
      gas.points(column::position, 0)[p] = 1.1 + 0.4 * p;
      gas.points(column::position, 1)[p] = 2.9 - 0.3 * p;
      gas.points(column::velocity, 0)[p] = 0.1 * p;
      gas.points(column::velocity, 1)[p] = 0.2 - 0.1 * p;
      gas.points(column::volume)[p] = 0.02;
      gas.points(column::mass)[p] = 0.03 + 0.01 * p;
      gas.points(column::density)[p] = gas.points(column::mass)[p] / 0.02;
      gas.points(column::energy)[p] = 0.5 + 0.25 * p;
    }
    if (around_.load) {
      gas.load = [](double, Columns& points, std::span<const int>) {
        for (int p = 0; p < points.points(); ++p) points(column::body_force, 1)[p] = -push;
      };
    }
    all.bodies.push_back(std::move(gas));
    return all;
  }

  // Sums over the points, of what measures look at.
  std::vector<Measure> measures(const Simulation& simulation) const override {
    const Columns& points = simulation.scene().bodies[0].points;
    double place = 0, speed = 0, heat = 0;
    for (int p = 0; p < points.points(); ++p) {
      const double m = points(column::mass)[p];
      place += m * points(column::position, 1)[p];
      speed += m * points(column::velocity, 0)[p];
      heat += m * points(column::energy)[p];
    }
    return {scalar_measure("time", simulation.time(), 0, 0, "s"), scalar_measure("place", place, 0, 0, "kg m"),
            scalar_measure("speed", speed, 0, 0, "kg m/s"), scalar_measure("heat", heat, 0, 0, "J")};
  }

 private:
  Surroundings around_;
};

// Of the points above, by hand.
constexpr double thrown_mass = 0.25, thrown_heat = 0.275,
                 thrown_square = 0.019 + 0.005;  // kg, J, sum m v_x^2 and v_y^2

struct HandedSums {
  double mass = 0, energy = 0, speed = 0, along_x = 0, along_y = 0, place = 0;
};
HandedSums sums_of(const Columns& points) {
  HandedSums sums;
  for (int p = 0; p < points.points(); ++p) {
    const double m = points(column::mass)[p], x = points(column::velocity, 0)[p], y = points(column::velocity, 1)[p];
    sums.mass += m;
    sums.energy += m * (points(column::energy)[p] + (x * x + y * y) / 2);
    sums.speed += m * std::hypot(x, y);
    sums.along_x += m * x;
    sums.along_y += m * y;
    sums.place += m * points(column::position, 1)[p];
  }
  return sums;
}

}  // namespace

KnownAnswers handed_in_answers() {
  KnownAnswers all;
  const Settings settings = find_case("sod").settings("default", {});  // integrator and step alone are read
  const HandedSums start = sums_of(ThrownGas({}).scene().bodies[0].points);
  const auto handed = [&](const std::string& name, const Surroundings& around, double heavier, double faster) {
    const ThrownGas problem(around);
    Columns points = problem.scene().bodies[0].points;
    for (double& m : points.values(column::mass)) m *= heavier;
    for (int p = 0; p < points.points(); ++p) points(column::velocity, 0)[p] += faster;
    for (int p = 0; p < points.points(); ++p) points(column::velocity, 1)[p] += 2 * faster;
    const HandedSums end = sums_of(points);
    const std::vector<HandedIn> bodies{{points.points(), points}};
    const Balanced found = balance_of(problem, settings, bodies);
    all.push_back({name + ".mass", found.balance.mass, std::abs(heavier - 1)});
    all.push_back({name + ".mass_at_start", found.mass_at_start, start.mass});
    all.push_back({name + ".mass_at_end", found.mass_at_end, end.mass});
    // With an acceleration b of all the root of the energy grows by no more than sqrt(M/2) b t; what a piston of speed u moves gets
    // u^2 a mass.
    const double acceleration = (around.gravity ? pull : 0) + (around.load ? push : 0);
    const double begun = start.energy + (around.piston ? start.mass * speed_of_piston * speed_of_piston : 0);
    const double root = std::sqrt(begun) + std::sqrt(start.mass / 2) * acceleration * thrown_until;
    all.push_back({name + ".energy", found.balance.energy, end.energy / (root * root)});
    // Along directions in which nothing pushes.
    const bool along_x = !around.load && !around.piston && !around.walls, along_y = !around.load && !around.gravity;
    const double x = along_x ? std::abs(end.along_x - start.along_x) : 0,
                 y = along_y ? std::abs(end.along_y - start.along_y) : 0;
    all.push_back({name + ".momentum_known", static_cast<double>(found.balance.momentum.has_value()),
                   along_x || along_y ? 1.0 : 0.0});
    all.push_back(
        {name + ".momentum", found.balance.momentum.value_or(0), std::max(x, y) / std::max(start.speed, end.speed)});

    const auto simulation = simulation_of(problem, settings, bodies, thrown_until);
    const std::vector<Measure> measures = measures_at_end(problem, *simulation);
    const double heat = thrown_heat * heavier;
    const double exact[] = {thrown_until, end.place, end.along_x, heat};
    for (std::size_t k = 0; k < measures.size(); ++k) {
      all.push_back({name + "." + measures[k].name, measures[k].value.value_or(NAN), exact[k]});
    }
  };
  all.push_back({"start.mass", start.mass, thrown_mass});
  all.push_back({"start.energy", start.energy, thrown_heat + thrown_square / 2});
  handed("same", {}, 1, 0);
  handed("heavier", {}, 1.02, 0);
  handed("lighter", {}, 0.98, 0);
  handed("faster", {}, 1, 0.5);
  handed("falls", {.gravity = true}, 1, 0.5);
  handed("pushed", {.load = true}, 1, 0.5);
  handed("falls_and_pushed", {.gravity = true, .load = true}, 1.02, -0.2);
  handed("driven", {.piston = true}, 1, -0.5);
  handed("walls", {.walls = true}, 1, 0.5);
  Balance worst{.mass = 0.1, .momentum = {}, .energy = 0.7};
  worst.take_worse({.mass = 0.3, .momentum = 0.2, .energy = 0.5});
  worst.take_worse({.mass = 0.2, .momentum = 0.1, .energy = 0.6});
  all.push_back({"worst.mass", worst.mass, 0.3});
  all.push_back({"worst.momentum", worst.momentum.value_or(NAN), 0.2});
  all.push_back({"worst.energy", worst.energy, 0.7});
  return all;
}

}  // namespace plumbline
