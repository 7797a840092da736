// York's airbag before the probe comes.
#include "cases/catalog/coupled/airbag_start.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cases/harness/description/schemes.hpp"
#include "kernel/materials/segment_membrane.hpp"
#include "kernel/simulation.hpp"

namespace plumbline::airbag_start_test {
namespace {

constexpr double crown = 0.318;
constexpr int cells = 16, ppc = 8;

Bag flat_bag(const BagPressures& pressures) {
  auto gas = std::make_shared<IdealGas>();
  gas->viscosity_quadratic = 0.5;
  return unstretched_bag(airbag_grid(cells), ppc, 4, crown, pressures, gas);
}

const Bag& blown_bag() {
  static const Bag bag = inflate(flat_bag(bag_pressures("physical")), airbag_grid(cells), bag_pressures("physical"));
  return bag;
}

double total(const Body& body, const ColumnId& column) {
  double sum = 0;
  for (int p = 0; p < body.points.points(); ++p) sum += body.points(column)[p];
  return sum;
}

int outside(const Bag& bag) {
  const Curve polygon = outline(bag.skin, {});
  int count = 0;
  for (int p = 0; p < bag.gas.points.points(); ++p) {
    count += !inside(polygon, bag.gas.points(column::position)[p], bag.gas.points(column::position, 1)[p]);
  }
  return count;
}

// York's numbers: the bag weighs 0.3672 kg, i = 8226.39 J/kg of his gas, 216.6 kJ/kg of air at its true pressure.
TEST(AirbagStart, MassesAndEnergies) {
  const Bag york = flat_bag(bag_pressures("york"));
  EXPECT_NEAR(2 * std::numbers::pi * total(york.skin, column::mass), 0.3672, 1e-12);
  EXPECT_NEAR(york.gas.points(column::energy)[0], 8226.39, 0.005);
  const Bag physical = flat_bag(bag_pressures("physical"));
  EXPECT_NEAR(physical.gas.points(column::energy)[0], 216.6e3, 50);
  EXPECT_NEAR(total(york.gas, column::mass), 1.2156 * enclosed_volume(york.skin), 1e-12);
  EXPECT_EQ(outside(york), 0);
}

TEST(AirbagStart, GridHasPlateAndRoom) {
  const GridSpec grid = airbag_grid(25);
  EXPECT_DOUBLE_EQ(grid.h, 0.02);
  EXPECT_EQ(grid.cells[0], 18);
  EXPECT_EQ(grid.origin[1], 0);
  EXPECT_EQ(grid.walls[1][0], Wall::symmetry);
}

// The tether is as long as it is in York's outline, and its ring where that has it.
TEST(AirbagStart, TetherHoldsTheRing) {
  const Bag flat = flat_bag(bag_pressures("york"));
  EXPECT_NEAR(flat.tether.length, std::hypot(0.08, 0.299), 1e-15);
  const auto ring = [](const Bag& bag, int d) {
    const double* x = bag.skin.points(column::position, d) + bag.tether.after;
    return (1 - bag.tether.share) * x[0] + bag.tether.share * x[1];
  };
  EXPECT_NEAR(ring(flat, 0), 0.08, 1e-12);
  EXPECT_NEAR(ring(flat, 1), 0.299, 1e-3);  // points stand at even distances, not at the kink itself
  // taut, and stretched by about a thousandth of what the bag would swell
  EXPECT_GT(tension(blown_bag().skin.points, blown_bag().tether), 0);
  EXPECT_NEAR(std::hypot(ring(blown_bag(), 0), ring(blown_bag(), 1)), blown_bag().tether.length, 2e-3);
}

TEST(AirbagStart, BlownUpItHasItsPressureAndDensity) {
  const Bag& bag = blown_bag();
  const double volume = enclosed_volume(bag.skin);
  const double inside_pressure = (bag_gamma - 1) * bag.gas.points(column::energy)[0] * total(bag.gas, column::mass) /
                                 volume;
  EXPECT_NEAR(inside_pressure, 105325, 1e-6);
  EXPECT_NEAR(total(bag.gas, column::mass) / volume, 1.2156, 1e-12);
  EXPECT_EQ(outside(bag), 0);
  for (int p = 0; p < bag.gas.points.points(); ++p) ASSERT_EQ(bag.gas.points(column::velocity)[p], 0);
  // The skin is stretched by its own pressure: a sphere of that size by p R (1 - nu)/(2 E t) = 0.01
  EXPECT_GT(volume, enclosed_volume(flat_bag(bag_pressures("physical")).skin));
  EXPECT_LT(volume, 1.1 * enclosed_volume(flat_bag(bag_pressures("physical")).skin));
}

// With the tether it stays. A probe would make 39 mm in that time; what the bag creeps by, for gas is never quite at
// rest, is to be less than a fiftieth of that, so that no displacement depends on it by more. Its volume rests far
// better.
TEST(AirbagStart, BlownUpItRests) {
  const Bag& bag = blown_bag();
  Scene scene;
  scene.grid = airbag_grid(cells);
  scene.bodies = {bag.gas, bag.skin};
  apply_choices(Settings(kind_keys(Kind::coupled)), scene);
  scene.bodies[1].load = [&](double, Columns& points, std::span<const int>) {
    for (int d = 0; d < 2; ++d) std::fill_n(points(column::body_force, d), points.points(), 0.0);
    add_outside_pressure(points, bag_pressures("physical").outside);
    add_tether(points, bag.tether);
  };
  StepControl control;
  control.cfl = 0.9;
  Simulation simulation(scene, "leapfrog", control);
  simulation.run_until(0.01);
  double most = 0;
  for (int p = 0; p < bag.skin.points.points(); ++p) {
    const Columns &now = simulation.scene().bodies[1].points, &then = bag.skin.points;
    most = std::max(most, std::hypot(now(column::position)[p] - then(column::position)[p],
                                     now(column::position, 1)[p] - then(column::position, 1)[p]));
  }
  EXPECT_LT(most, 0.039 / 50);
  EXPECT_NEAR(enclosed_volume(simulation.scene().bodies[1]), enclosed_volume(bag.skin),
              1e-3 * enclosed_volume(bag.skin));
}

}  // namespace
}  // namespace plumbline::airbag_start_test
