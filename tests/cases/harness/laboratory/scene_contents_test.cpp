// What of real cases and of a holed body is read; sides, ends and couplings known by hand are in case estimators.
#include "cases/harness/laboratory/scene_contents.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "cases/harness/description/case.hpp"
#include "kernel/materials/ideal_gas.hpp"
#include "kernel/materials/linear_elastic.hpp"
#include "kernel/materials/segment_membrane.hpp"

namespace plumbline::scene_contents_test {
namespace {

using Matter = SceneContents::Matter;

SceneContents contents_of_case(const std::string& name, const std::vector<Override>& overrides,
                               const std::string& scheme = "default") {
  const Case& entry = find_case(name);
  return contents_of(entry.problem(entry.settings(scheme, overrides))->scene());
}

std::shared_ptr<LinearElastic> elastic(double modulus) {
  auto law = std::make_shared<LinearElastic>();
  law->youngs_modulus = modulus;
  law->density = 1;
  return law;
}

// A square of cells 1 ... 1 + filled of a grid of `cells` in each direction, 2 points a cell and direction.
Scene block(int cells, int filled) {
  Scene scene;
  scene.grid.dim = 2;
  scene.grid.cells = {cells, cells, 1};
  const int side = 2 * filled;
  Body body = make_body("block", elastic(4), side * side, 2);
  for (int p = 0; p < side * side; ++p) {
    const auto k = static_cast<std::size_t>(p);
    body.points(column::position, 0)[k] = 1 + (p % side + 0.5) / 2;
    body.points(column::position, 1)[k] = 1 + (p / side + 0.5) / 2;
    body.points(column::mass)[k] = body.points(column::volume)[k] = 0.25;
  }
  scene.bodies.push_back(std::move(body));
  return scene;
}

void move(Scene& scene, double distance) {
  for (int d = 0; d < 2; ++d) {
    double* x = scene.bodies[0].points(column::position, d);
    for (int p = 0; p < scene.bodies[0].points.points(); ++p) x[p] += distance;
  }
}

TEST(SceneContents, ABlockIsSolidWithItsSpeedAndPoints) {
  Scene scene = block(6, 3);
  std::fill_n(scene.bodies[0].points(column::velocity), 36, 7.0);  // motion is no part of a wave's speed
  const SceneContents found = contents_of(scene);
  EXPECT_EQ(found.dim, 2);
  EXPECT_FALSE(found.contact || found.axisymmetric);
  ASSERT_EQ(found.parts.size(), 1U);
  EXPECT_EQ(found.parts[0].matter, Matter::solid);
  EXPECT_EQ(found.parts[0].per_cell, 2);
  EXPECT_NEAR(found.parts[0].speed, 2, 1e-12);
  EXPECT_TRUE(found.couplings.empty());
}

TEST(SceneContents, DensePointsAreSampledAsFew) {
  const auto per_cell = [](double ppc) {
    return contents_of_case("bar-vibration", {{"ppc", ppc}}).parts.at(0).per_cell;
  };
  EXPECT_EQ(per_cell(1), 1);
  EXPECT_EQ(per_cell(2), 2);
  EXPECT_EQ(per_cell(7), SceneContents::most_per_cell);
}

TEST(SceneContents, AHoleHasEdgesAndAnotherBodyOfTheFieldClosesThem) {
  Scene scene = block(5, 5);
  move(scene, -1);
  for (auto& walls : scene.grid.walls) walls = {Wall::symmetry, Wall::symmetry};
  Body& body = scene.bodies[0];
  Body plug = make_body("plug", elastic(1), 4, 2);
  int plugged = 0;
  for (int p = 0; p < 100; ++p) {  // the points of the middle cell go to the plug; their doubles go elsewhere
    double &x = body.points(column::position, 0)[p], &y = body.points(column::position, 1)[p];
    if (std::floor(x) != 2 || std::floor(y) != 2) continue;
    plug.points(column::position, 0)[plugged] = x;
    plug.points(column::position, 1)[plugged] = y;
    plug.points(column::mass)[plugged] = plug.points(column::volume)[plugged] = 0.25;
    ++plugged;
    x -= 2;
  }
  ASSERT_EQ(plugged, 4);
  EXPECT_TRUE(contents_of(scene).parts[0].free_edge);
  scene.bodies.push_back(plug);
  for (const auto& part : contents_of(scene).parts) EXPECT_FALSE(part.free_edge) << part.body;
  scene.bodies[1].field = "own";
  for (const auto& part : contents_of(scene).parts) EXPECT_TRUE(part.free_edge) << part.body;
  EXPECT_FALSE(contents_of(scene).contact);
  scene.contact = "touching";
  EXPECT_TRUE(contents_of(scene).contact);
}

// Fewer points in the thin gas: least one a cell.
TEST(SceneContents, ATubeIsGasBetweenWalls) {
  const SceneContents sod = contents_of_case("sod", {{"cells", 50.0}, {"ppc", 8.0}});
  ASSERT_EQ(sod.parts.size(), 1U);
  EXPECT_EQ(sod.parts[0].matter, Matter::gas);
  EXPECT_EQ(sod.parts[0].per_cell, 1);
  EXPECT_FALSE(sod.parts[0].free_edge);
  EXPECT_EQ(sod.parts[0].diffusivity, 0);
  EXPECT_NEAR(sod.parts[0].speed, std::sqrt(1.4), 1e-9);
  EXPECT_FALSE(contents_of_case("piston-shock", {{"cells", 50.0}}).parts[0].free_edge);
  EXPECT_TRUE(contents_of_case("gas-expansion", {{"cells", 20.0}}).parts[0].free_edge);
  EXPECT_GT(contents_of_case("shear-decay", {}).parts[0].diffusivity, 0);
}

TEST(SceneContents, StringsHaveEndsWhereNothingHoldsThem) {
  const SceneContents hung = contents_of_case("spring-mass", {});
  ASSERT_EQ(hung.of(Matter::chain).size(), 1U);
  EXPECT_TRUE(hung.parts[0].free_edge);
  EXPECT_FALSE(hung.parts[0].segments);
  EXPECT_FALSE(contents_of_case("string-vibration", {}).parts[0].free_edge);
}

TEST(SceneContents, BodiesInContactHaveEdgesOfTheirOwn) {
  const SceneContents bars = contents_of_case("two-bar", {});
  EXPECT_TRUE(bars.contact);
  ASSERT_EQ(bars.of(Matter::solid).size(), 2U);
  for (const auto& part : bars.parts) EXPECT_TRUE(part.free_edge);
  EXPECT_FALSE(contents_of_case("two-bar", {{"contact", "none"}}).contact);
}

// Per length the membrane of one cell weighs what a cell of gas does; its waves are faster by their stiffness. The gas of
// York's scheme is viscous, and gas all the same.
TEST(SceneContents, AMembraneInGasIsCoupledToIt) {
  for (const char* scheme : {"default", "york1997"}) {
    const SceneContents bag = contents_of_case("membrane-expansion", {{"cells", 32.0}}, scheme);
    ASSERT_EQ(bag.couplings.size(), 1U) << scheme;
    EXPECT_NEAR(bag.couplings[0].density_ratio, 1, 0.05) << scheme;
    EXPECT_NEAR(bag.couplings[0].stiffness_ratio, 1.6e4, 0.05e4) << scheme;
    EXPECT_EQ(bag.couplings[0].chain.segments, scheme == std::string("default"));
  }
}

}  // namespace
}  // namespace plumbline::scene_contents_test
