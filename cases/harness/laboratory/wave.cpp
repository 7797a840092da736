#include "cases/harness/laboratory/wave.hpp"

#include <Eigen/Core>
#include <cmath>
#include <memory>
#include <numbers>

#include "cases/harness/laboratory/matrices.hpp"
#include "kernel/simulation.hpp"

namespace plumbline {
namespace {

// So small that points stay where they are, to the last digit of their places.
constexpr double amplitude = 1e-17;
// Where the wave is in its period at first: neither velocities nor strains are at an extreme, for which the first error of
// some integrators vanishes.
constexpr double velocity_share = 0.8, strain_share = 0.6;

// Velocities and strains of a body's points, by number.
std::vector<double*> numbers_of(Body& body) {
  const std::size_t n = body.id.size();
  std::vector<double*> numbers(2 * n);
  for (std::size_t p = 0; p < n; ++p) {
    const auto id = static_cast<std::size_t>(body.id[p]);
    numbers[id] = body.points(column::velocity) + p;
    numbers[n + id] = body.points(column::strain) + p;
  }
  return numbers;
}

}  // namespace

StandingWave::StandingWave(const MapChoice& maps, int cells, int ppc) : maps_(maps), cells_(cells), ppc_(ppc) {}

Scene StandingWave::scene() const {
  Scene scene = bar_patch(maps_, ppc_, 0.5, {cells_, 0}).scene;
  scene.grid.walls[0] = {Wall::symmetry, Wall::symmetry};
  Columns& points = scene.bodies[0].points;
  for (int p = 0; p < points.points(); ++p) {
    const double phase = std::numbers::pi * points(column::position)[p] / cells_;
    points(column::velocity)[p] = amplitude * velocity_share * std::sin(phase);
    points(column::strain)[p] = amplitude * strain_share * std::cos(phase);
  }
  return scene;
}

auto StandingWave::stepped(const IntegratorChoice& integrator, double t, int steps) const -> Amplitudes {
  StepControl control;
  control.dt = t / steps;
  control.parameters = integrator.parameters;
  Simulation run(scene(), integrator.name, control);
  for (int k = 0; k < steps; ++k) run.step(2 * t);
  Body body = run.scene().bodies[0];
  Amplitudes found;
  for (const double* number : numbers_of(body)) found.push_back(*number / amplitude);
  return found;
}

auto StandingWave::rates() const -> std::vector<Amplitudes> {
  Scene now = scene();
  Ledger ledger;
  const auto engine = make_engine(now, ledger, {.evaluates_stress_first = true});
  engine->initialise();
  ledger.open(engine->totals());
  const std::vector<double*> numbers = numbers_of(now.bodies[0]);
  const std::vector<int>& id = now.bodies[0].id;
  const std::size_t n = id.size();
  std::vector<Amplitudes> rows(2 * n, Amplitudes(2 * n));
  for (std::size_t k = 0; k < 2 * n; ++k) {
    for (double* number : numbers) *number = 0;
    *numbers[k] = 1;
    engine->points_changed(0);
    const State rate = engine->rate();  // positions, velocities, strains, in the order in which the points stand
    for (std::size_t p = 0; p < n; ++p) {
      const auto own = static_cast<std::size_t>(id[p]);
      rows[own][k] = rate.values[n + p];
      rows[n + own][k] = rate.values[2 * n + p];
    }
  }
  return rows;
}

auto StandingWave::exact(double t) const -> Amplitudes {
  const std::vector<Amplitudes> rows = rates();
  const auto size = static_cast<Eigen::Index>(rows.size());
  Eigen::MatrixXd matrix(size, size);
  for (Eigen::Index i = 0; i < size; ++i) {
    for (Eigen::Index j = 0; j < size; ++j)
      matrix(i, j) = rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  }
  Scene at_start = scene();
  Eigen::VectorXd start(size);
  Eigen::Index k = 0;
  for (const double* number : numbers_of(at_start.bodies[0])) start[k++] = *number / amplitude;
  const Eigen::VectorXd end = exponential(t * matrix) * start;
  return {end.begin(), end.end()};
}

}  // namespace plumbline
