#include "cases/catalog/membrane/mass_watch.hpp"

#include <cmath>

#include "cases/harness/description/archive.hpp"
#include "cases/harness/files/whole.hpp"
#include "kernel/points/column_names.hpp"

namespace plumbline {
namespace {

double height_of_last(const Body& body) { return body.points(column::position)[body.points.points() - 1]; }

}  // namespace

Scene scene_below_support(double h, double gravity) {
  Scene scene;
  scene.grid.dim = 1;
  scene.grid.h = h;
  scene.grid.cells[0] = whole(std::round(support / h));
  scene.grid.walls[0] = {Wall::free, Wall::symmetry};
  scene.gravity[0] = -gravity;
  return scene;
}

MassWatch::MassWatch(const Body& body) : start(height_of_last(body)) {}

void MassWatch::observe(const Simulation& simulation) {
  times.push_back(simulation.time());
  displacement.push_back(start - height_of_last(simulation.scene().bodies.front()));
  kinetic.push_back(simulation.ledger().stores.kinetic);
  elastic.push_back(simulation.ledger().stores.elastic);
}

void MassWatch::history(Archive& archive) {
  archive("times", times);
  archive("displacement", displacement);
  archive("kinetic", kinetic);
  archive("elastic", elastic);
}

double largest_maximum(std::span<const Extreme> extremes) {
  double largest = std::nan("");
  for (const Extreme& extreme : extremes) {
    if (extreme.maximum && !(extreme.value <= largest)) largest = extreme.value;
  }
  return largest;
}

}  // namespace plumbline
