// Bodies store what their material, transfer and integrator ask for and nothing else: the doubles per point are
// pinned.
#include "kernel/points/body.hpp"

#include <tuple>

#include "kernel/geometry.hpp"
#include "tests/kernel/scenes.hpp"

namespace plumbline::body_test {
namespace {

Scene gas_scene(scenes::Space space, const std::string& transfer, const IdealGas& gas = {}) {
  const GridSpec grid = scenes::box(space, {4, 4, 4}, 0.1);
  return scenes::scene_of(
      grid, {scenes::gas_body(gas, space, scenes::lattice(grid, 2), 1, [](auto&) { return scenes::GasState{}; })},
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

// x, v, mass, volume, density, energy, pressure, and strain rate and stress: 7 + 2 on a line; in the plane, of rings and in
// space 9, 9 and 11, and 2 x 3, 2 x 4, 2 x 6 for a gas with physical viscosity; without it the stress is a pressure
// everywhere. C: 1, 4, 9; loss: 1.
TEST(Body, DoublesPerGasPoint) {
  using scenes::Space;
  const IdealGas thick = scenes::rough_law(), thin = scenes::inviscid_law();
  for (const auto& [space, base, stresses, affine] : {std::tuple{Space::line, 7, 1, 1},
                                                      {Space::plane, 9, 3, 4},
                                                      {Space::axisymmetric, 9, 4, 4},
                                                      {Space::solid, 11, 6, 9}}) {
    SCOPED_TRACE(space);
    for (const IdealGas& gas : {thick, thin}) {
      const int flip = base + 2 * (gas.viscosity > 0 ? stresses : 1);
      EXPECT_EQ(doubles(gas_scene(space, "flip", gas), "musl"), flip);
      EXPECT_EQ(doubles(gas_scene(space, "pic", gas), "usl"), flip);
      EXPECT_EQ(doubles(gas_scene(space, "apic", gas), "musl"), flip + affine);
      EXPECT_EQ(doubles(gas_scene(space, "apic", gas), "energy"), flip + affine + 1);
    }
  }
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
  const Simulation flip(gas_scene(scenes::Space::plane, "flip"), "musl", {}),
      net(membrane_scene(2, "apic"), "energy", {});
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

TEST(Body, HasTheComponentsOfItsGeometry) {
  const auto thick = std::make_shared<IdealGas>(scenes::rough_law());
  for (scenes::Space space : scenes::spaces) {
    const int dim = scenes::dim_of(space);
    const bool rings = space == scenes::Space::axisymmetric;
    const Body body = make_body("air", thick, 3, dim, rings);
    EXPECT_EQ(body.points.components(column::position), dim);
    EXPECT_EQ(body.points.components(column::velocity), dim);
    EXPECT_EQ(body.points.components(column::stress), strain_components(dim, rings));
    EXPECT_EQ(body.points.components(column::strain_rate), strain_components(dim, rings));
    EXPECT_EQ(make_body("thin", std::make_shared<IdealGas>(), 3, dim, rings).points.components(column::stress), 1);
  }
}

}  // namespace
}  // namespace plumbline::body_test
