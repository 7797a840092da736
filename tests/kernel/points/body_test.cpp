// Bodies store what their material, transfer and integrator ask for and nothing else: the doubles per point are
// pinned.
#include "kernel/points/body.hpp"

#include "tests/kernel/scenes.hpp"

namespace plumbline {
namespace {

Scene gas_scene(int dim, const std::string& transfer) {
  const GridSpec grid = dim == 1 ? scenes::line(4, 0.1) : scenes::plane(4, 4, 0.1);
  return scenes::scene_of(
      grid, {scenes::gas_body({}, dim, scenes::lattice(grid, 2), 1, [](auto&) { return scenes::GasState{}; })},
      "quadratic", transfer);
}

Scene membrane_scene(int dim, const std::string& transfer) {
  UniaxialMembrane law;
  law.youngs_modulus = law.density = 1;
  const GridSpec grid = dim == 1 ? scenes::line(4, 0.1) : scenes::plane(4, 4, 0.1);
  return scenes::scene_of(grid, {scenes::membrane_body(law, dim, {{0.11, 0.2}, {0.15, 0.2}, {0.19, 0.2}}, 1)},
                          "quadratic", transfer);
}

int doubles(Scene scene, const std::string& integrator) {
  const Simulation run(std::move(scene), integrator, {});
  return run.scene().bodies[0].points.doubles_per_point();
}

// x, v, mass, volume, strain rate, stress, density, energy, pressure: 9 on a line, 15 in the plane; C: 1 and 4;
// loss: 1.
TEST(Body, DoublesPerGasPoint) {
  EXPECT_EQ(doubles(gas_scene(1, "flip"), "musl"), 9);
  EXPECT_EQ(doubles(gas_scene(1, "pic"), "usl"), 9);
  EXPECT_EQ(doubles(gas_scene(1, "apic"), "musl"), 10);
  EXPECT_EQ(doubles(gas_scene(1, "apic"), "energy"), 11);
  EXPECT_EQ(doubles(gas_scene(2, "flip"), "musl"), 15);
  EXPECT_EQ(doubles(gas_scene(2, "apic"), "musl"), 19);
  EXPECT_EQ(doubles(gas_scene(2, "apic"), "energy"), 20);
}

// x, v, mass, volume, strain rate, stress, strain: 7 on a line; 13 and a tangent in the plane. No heat, no loss
// column.
TEST(Body, DoublesPerMembranePoint) {
  EXPECT_EQ(doubles(membrane_scene(1, "flip"), "musl"), 7);
  EXPECT_EQ(doubles(membrane_scene(1, "apic"), "energy"), 8);
  EXPECT_EQ(doubles(membrane_scene(2, "flip"), "musl"), 15);
  EXPECT_EQ(doubles(membrane_scene(2, "apic"), "energy"), 19);
}

TEST(Body, FlipHasNoAffineColumnAndMembranesNoEnergy) {
  const Simulation flip(gas_scene(2, "flip"), "musl", {}), net(membrane_scene(2, "apic"), "energy", {});
  EXPECT_FALSE(flip.scene().bodies[0].points.has(column::affine));
  EXPECT_FALSE(flip.scene().bodies[0].points.has(column::transfer_loss));
  EXPECT_TRUE(net.scene().bodies[0].points.has(column::affine));
  EXPECT_FALSE(net.scene().bodies[0].points.has(column::energy));
  EXPECT_FALSE(net.scene().bodies[0].points.has(column::density));
  EXPECT_FALSE(net.scene().bodies[0].points.has(column::transfer_loss));
}

TEST(Body, NumbersItsPointsAndKnowsChains) {
  const Body gas = make_body("air", std::make_shared<IdealGas>(), 3, 1);
  EXPECT_EQ(gas.id, (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(gas.field, "common");
  EXPECT_FALSE(gas.chain);
  EXPECT_TRUE(make_body("net", std::make_shared<UniaxialMembrane>(), 3, 2).chain);
}

}  // namespace
}  // namespace plumbline
