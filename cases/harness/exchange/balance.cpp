#include "cases/harness/exchange/balance.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "cases/harness/judge/gates.hpp"
#include "kernel/points/column_names.hpp"

namespace plumbline {
namespace {

// What points carry in sum.
struct Sums {
  double mass = 0, speed = 0, energy = 0;  // sum m, sum m |v|, sum m (v^2 / 2 + e)
  std::array<double, 3> momentum{0, 0, 0};

  void add(const Columns& points, int dim) {
    const bool heats = points.has(column::energy);
    for (int p = 0; p < points.points(); ++p) {
      const double m = points(column::mass)[p];
      double square = 0;
      for (int d = 0; d < dim; ++d) {
        const double v = points(column::velocity, d)[p];
        momentum[static_cast<std::size_t>(d)] += m * v;
        square += v * v;
      }
      mass += m;
      speed += m * std::sqrt(square);
      energy += m * (square / 2 + (heats ? points(column::energy)[p] : 0));
    }
  }
};

// Directions along which nothing outside the bodies pushes.
std::vector<int> free_directions(const Scene& scene) {
  std::vector<int> directions;
  const bool loaded = std::any_of(scene.bodies.begin(), scene.bodies.end(), [](const Body& b) { return bool(b.load); });
  for (int d = 0; d < scene.grid.dim; ++d) {
    const auto k = static_cast<std::size_t>(d);
    const auto& walls = scene.grid.walls[k];
    bool pushed = loaded || scene.gravity[k] != 0 || walls[0] != Wall::free || walls[1] != Wall::free ||
                  (scene.grid.axisymmetric && d == 0);
    for (const Piston& piston : scene.pistons) pushed = pushed || piston.direction == d;
    if (!pushed) directions.push_back(d);
  }
  return directions;
}

// sqrt(sum m |b|^2 / 2) of gravity and the loads at `time`: as dE/dt = sum m b . v is at most twice this times sqrt(E), the
// root of the energy grows no faster.
double growth_of_root(Scene& scene, double time) {
  double sum = 0;
  for (Body& body : scene.bodies) {
    std::vector<int> ids(static_cast<std::size_t>(body.points.points()));
    for (std::size_t p = 0; p < ids.size(); ++p) ids[p] = static_cast<int>(p);
    body.points.add(column::body_force, scene.grid.dim);
    if (body.load) body.load(time, body.points, ids);
    for (int p = 0; p < body.points.points(); ++p) {
      for (int d = 0; d < scene.grid.dim; ++d) {
        const double b = body.points(column::body_force, d)[p] + scene.gravity[static_cast<std::size_t>(d)];
        sum += body.points(column::mass)[p] * b * b / 2;
      }
    }
  }
  return std::sqrt(sum);
}

// The most that the points can have at `end`, s. Gas that a piston of speed u sets in motion gets u^2 a mass, half as motion and
// half as heat, and the work against the pressure ahead of the shock, which is no more than the heat there was.
// `begun`: kinetic, internal and elastic, J.
double most_energy(Scene scene, double mass, double begun, double end) {
  constexpr int times = 64;
  double root = 0;
  for (int k = 0; k < times; ++k) root += growth_of_root(scene, (k + 0.5) * end / times) * end / times;
  for (const Piston& piston : scene.pistons) begun += mass * piston.velocity * piston.velocity;
  return std::pow(std::sqrt(begun) + root, 2);
}

}  // namespace

void Balance::take_worse(const Balance& other) {
  mass = larger(mass, other.mass);
  if (other.momentum) momentum = larger(momentum.value_or(0), *other.momentum);
  energy = larger(energy, other.energy);
}

Balanced balance_of(const Problem& problem, const Settings& settings, const std::vector<HandedIn>& bodies) {
  const Scene scene = problem.scene();
  Sums start, end;
  for (const Body& body : scene.bodies) start.add(body.points, scene.grid.dim);
  for (const HandedIn& body : bodies) end.add(body.columns, scene.grid.dim);
  Balanced found;
  found.mass_at_start = start.mass;
  found.mass_at_end = end.mass;
  found.balance.mass = std::abs(end.mass / start.mass - 1);
  for (const int d : free_directions(scene)) {
    const auto k = static_cast<std::size_t>(d);
    const double scale = std::max(start.speed, end.speed);
    const double off = scale > 0 ? std::abs(end.momentum[k] - start.momentum[k]) / scale : 0;
    found.balance.momentum = larger(found.balance.momentum.value_or(0), off);
  }
  const Simulation begun(problem.scene(), settings.text("integrator"), step_control(settings));
  found.balance.energy = end.energy /
                         most_energy(scene, start.mass, begun.ledger().initial_stores.total(), problem.end_time());
  return found;
}

}  // namespace plumbline
