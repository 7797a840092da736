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

TEST(SceneContents, EdgesAreFreeWhereNoWallIs) {
  Scene scene = block(5, 5);
  move(scene, -1);  // fills the grid
  EXPECT_TRUE(contents_of(scene).parts[0].free_edge);
  for (auto& walls : scene.grid.walls) walls = {Wall::symmetry, Wall::no_slip};
  EXPECT_FALSE(contents_of(scene).parts[0].free_edge);
  scene.grid.walls[1][1] = Wall::free;
  EXPECT_TRUE(contents_of(scene).parts[0].free_edge);
  scene.grid.walls[1][1] = Wall::symmetry;
  scene.grid.cells[0] = 6;  // a column of cells beside it is empty
  EXPECT_TRUE(contents_of(scene).parts[0].free_edge);
  scene.pistons.push_back({.direction = 0, .side = 1, .position = 5});
  EXPECT_FALSE(contents_of(scene).parts[0].free_edge);
}

// A box of other sides in each direction: every side is a wall or a free edge of its own, and a piston closes it.
TEST(SceneContents, EachSideOfABoxIsLookedAt) {
  constexpr int sides[3] = {4, 2, 3};
  Scene scene;
  scene.grid.dim = 3;
  scene.grid.cells = {4, 2, 3};
  scene.grid.origin = {-1, 5, 0.5};
  scene.grid.h = 0.5;
  Body body = make_body("box", elastic(1), 24, 3);
  for (int p = 0; p < 24; ++p) {
    const int at[3] = {p % 4, p / 4 % 2, p / 8};
    for (int d = 0; d < 3; ++d)
      body.points(column::position, d)[p] = scene.grid.origin[static_cast<std::size_t>(d)] + (at[d] + 0.5) * 0.5;
    body.points(column::mass)[p] = body.points(column::volume)[p] = 0.125;
  }
  scene.bodies.push_back(std::move(body));
  for (auto& walls : scene.grid.walls) walls = {Wall::symmetry, Wall::no_slip};
  EXPECT_FALSE(contents_of(scene).parts[0].free_edge);
  for (std::size_t d = 0; d < 3; ++d) {
    for (const int side : {0, 1}) {
      const auto other = [&](auto&& change) {
        Scene changed = scene;
        change(changed);
        return contents_of(changed).parts[0].free_edge;
      };
      const auto open = [&](Scene& s) { s.grid.walls[d][static_cast<std::size_t>(side)] = Wall::free; };
      EXPECT_TRUE(other(open)) << d << side;
      const double low = scene.grid.origin[d], plane = side == 0 ? low : low + 0.5 * sides[d];
      EXPECT_FALSE(other([&](Scene& s) {
        open(s);
        s.pistons.push_back({.direction = static_cast<int>(d), .side = side, .position = plane});
      })) << d
          << side;
      EXPECT_TRUE(other([&](Scene& s) {  // closes the side across
        open(s);
        s.pistons.push_back({.direction = static_cast<int>(d), .side = 1 - side, .position = side == 0 ? 99.0 : -99.0});
      })) << d
          << side;
    }
  }
}

// One straight on from either end of a chain there is a wall, of whichever direction, or there is not.
TEST(SceneContents, EndsOfAChainLookStraightOn) {
  for (const int direction : {0, 1}) {
    for (const double from : {0.6, 1.95}) {  // of its end from the wall, in cells
      for (const bool forwards : {true, false}) {
        Scene scene;
        scene.grid.dim = 2;
        scene.grid.cells = {9, 9, 1};
        for (auto& walls : scene.grid.walls) walls = {Wall::no_slip, Wall::no_slip};
        auto law = std::make_shared<SegmentMembrane>();
        law->youngs_modulus = law->density = 1;
        Body body = make_body("chain", law, 4, 2);
        for (int p = 0; p < 4; ++p) {
          const double along = forwards ? from + 0.7 * p : from + 0.7 * (3 - p);
          body.points(column::position, direction)[p] = along;
          body.points(column::position, 1 - direction)[p] = 4.5;
          body.points(column::mass)[p] = body.points(column::volume)[p] = body.points(column::rest_length)[p] = 0.7;
        }
        // A block stands one cell straight on from the other end.
        scene.bodies.push_back(std::move(body));
        Body stop = make_body("stop", elastic(1), 1, 2);
        stop.points(column::position, direction)[0] = from + 2.1 + 1;
        stop.points(column::position, 1 - direction)[0] = 4.5;
        stop.points(column::mass)[0] = stop.points(column::volume)[0] = 0.01;
        scene.bodies.push_back(std::move(stop));
        const SceneContents found = contents_of(scene);
        EXPECT_EQ(found.parts[0].free_edge, from > 1) << direction << forwards;
      }
    }
  }
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
