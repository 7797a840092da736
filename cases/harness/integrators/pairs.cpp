#include "cases/harness/integrators/pairs.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "kernel/simulation.hpp"
#include "kernel/transfers/transfer.hpp"

namespace plumbline {
namespace {

double largest(std::vector<double>::const_iterator first, std::vector<double>::const_iterator last) {
  double found = 0;
  for (; first != last; ++first) found = std::max(found, std::abs(*first));
  return found;
}

bool has_gas(const Scene& scene) {
  return std::any_of(scene.bodies.begin(), scene.bodies.end(),
                     [](const Body& body) { return body.material->takes_heat(); });
}

}  // namespace

std::vector<double> column_by_number(const Scene& scene, const ColumnId& id) {
  std::vector<double> all;
  for (const Body& body : scene.bodies) {
    for (int d = 0; d < scene.grid.dim; ++d) {
      const std::size_t start = all.size();
      all.resize(start + body.id.size());
      const double* from = body.points(id, d);
      for (std::size_t p = 0; p < body.id.size(); ++p) all[start + static_cast<std::size_t>(body.id[p])] = from[p];
    }
  }
  return all;
}

std::vector<double> state_at_end(const SmallScene& small, Scene scene, const IntegratorChoice& integrator, int steps) {
  const std::vector<double> start = column_by_number(scene, column::position);
  StepControl control;
  control.parameters = integrator.parameters;
  control.dt = small.end;
  Simulation run(std::move(scene), integrator.name, control);
  const double dt = small.end / steps;
  for (int k = 0; k < steps; ++k) {
    if (!small.variable_steps) {
      run.step(dt);
    } else {
      run.step(dt / 1.7);
      run.step(0.7 * dt / 1.7);
    }
  }
  std::vector<double> state = column_by_number(run.scene(), column::position);
  for (std::size_t k = 0; k < state.size(); ++k) state[k] -= start[k];
  const std::vector<double> velocities = column_by_number(run.scene(), column::velocity);
  state.insert(state.end(), velocities.begin(), velocities.end());
  return state;
}

IntegratorChoice yardstick(const Subject& subject, const Scene& scene) {
  const auto other_than_itself = [&](const char* first, const char* second) {
    return IntegratorChoice{subject.name() == first ? second : first, {}};
  };
  if (transfer_of(scene.transfer, 1).keep == 1) return other_than_itself("rk4", "ssp-rk3");
  const bool returns_loss = subject.traits().offers.count(Trait::returned_loss) > 0;
  return returns_loss && has_gas(scene) ? other_than_itself("leapfrog", "energy")
                                        : other_than_itself("midpoint", "musl");
}

std::vector<double> difference_at(const Subject& subject, const SmallScene& small, int steps) {
  const Scene scene = workable(small, subject.name());
  const Choice& transfer = transfer_named(scene.transfer);
  const bool points_have_own_velocities = transfer.offers.count(Trait::returnable_loss) == 0;
  if (subject.traits().drifts && points_have_own_velocities) {  // other motions than the grid's, however small the step
    throw CannotWork({{Trait::returnable_loss, "the drift of points in integrator " + subject.name(),
                       "transfer " + scene.transfer}});
  }
  const IntegratorChoice other = yardstick(subject, scene);
  const bool filters = transfer.offers.count(Trait::unfiltered_velocities) == 0;
  std::vector<double> mine = state_at_end(small, scene, subject.choice(), steps);
  const std::vector<double> theirs = state_at_end(small, scene, other,
                                                  filters ? steps * std::max(1, subject.traits().maps) : steps);
  const auto half = static_cast<std::ptrdiff_t>(theirs.size() / 2);
  const double distance = largest(theirs.begin(), theirs.begin() + half),
               speed = largest(theirs.begin() + half, theirs.end());
  for (std::size_t k = 0; k < mine.size(); ++k) {
    mine[k] = (mine[k] - theirs[k]) / (static_cast<std::ptrdiff_t>(k) < half ? distance : speed);
  }
  return mine;
}

}  // namespace plumbline
