// Points that outgrow the kernel are split: nothing but the spin about them changes, and that is booked.
#include "kernel/splitting.hpp"

#include <gmock/gmock.h>

#include <set>

#include "tests/kernel/scenes.hpp"

namespace plumbline::splitting_test {
namespace {

using scenes::Space;

constexpr double h = 0.1;

// One point of gas well inside an empty grid, in everything different from zero, twice as large as a cell.
Scene lone_point(Space space, const std::string& shape = "cubic", scenes::Place at = {0.53, 0.47, 0.51}) {
  const GridSpec grid = scenes::box(space, {10, 10, 10}, h, scenes::walls_everywhere(Wall::symmetry));
  const int dim = grid.dim;
  Scene scene = scenes::scene_of(grid,
                                 {scenes::gas_body(scenes::inviscid_law(), space, {at}, 2 * std::pow(h, dim),
                                                   [](const scenes::Place&) {
                                                     return scenes::GasState{1.5, 2, {0.3, -0.2, 0.7}};
                                                   })},
                                 shape, "apic");
  scene.split = 1.3;
  Columns& points = scene.bodies[0].points;
  points.add(column::affine, dim * dim);
  for (int k = 0; k < dim * dim; ++k) points(column::affine, k)[0] = 1 + 0.7 * k - 0.05 * k * k;
  return scene;
}

double inertia(const std::string& shape) { return shape == "cubic" ? h * h / 3 : h * h / 4; }

// Sums over the points, from the definitions.
struct Sums {
  double mass = 0, volume = 0, heat = 0, kinetic = 0, centre[3]{}, momentum[3]{}, turn[3]{};
};
Sums sums_of(const Scene& scene) {
  const Columns& points = scene.bodies[0].points;
  const int dim = scene.grid.dim;
  const double d2 = inertia(scene.shape);
  Sums s;
  for (int p = 0; p < points.points(); ++p) {
    const double m = points(column::mass)[p];
    double x[3]{}, v[3]{}, c[3][3]{};
    for (int i = 0; i < dim; ++i) {
      x[i] = points(column::position, i)[p];
      v[i] = points(column::velocity, i)[p];
      for (int j = 0; j < dim; ++j) c[i][j] = points(column::affine, i * dim + j)[p];
    }
    s.mass += m;
    s.volume += points(column::volume)[p];
    s.heat += m * points(column::energy)[p];
    for (int i = 0; i < 3; ++i) {
      s.centre[i] += m * x[i];
      s.momentum[i] += m * v[i];
      s.kinetic += m * v[i] * v[i] / 2;
      for (int j = 0; j < 3; ++j) s.kinetic += m * d2 * c[i][j] * c[i][j] / 2;
      const int a = (i + 1) % 3, b = (i + 2) % 3;
      s.turn[i] += m * (x[a] * v[b] - x[b] * v[a] + d2 * (c[b][a] - c[a][b]));
    }
  }
  return s;
}

// [Splitting 1, 2] The sums over the halves are the point's, in every geometry; energy is conserved.
TEST(Splitting, KeepsMassMomentumCentreAndEnergy) {
  for (const char* shape : {"quadratic", "cubic"}) {
    for (const Space space : scenes::spaces) {
      Scene scene = lone_point(space, shape);
      Ledger ledger;
      const Sums before = sums_of(scene);
      ASSERT_EQ(split_points(scene, 0, 1, ledger), 1) << space;
      ASSERT_EQ(scene.bodies[0].points.points(), 2);
      const Sums after = sums_of(scene);
      EXPECT_DOUBLE_EQ(after.mass, before.mass) << space;
      EXPECT_DOUBLE_EQ(after.volume, before.volume) << space;
      EXPECT_DOUBLE_EQ(after.heat, before.heat) << space;
      EXPECT_NEAR(after.kinetic, before.kinetic, 1e-14 * before.kinetic) << space << ' ' << shape;
      for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(after.centre[i], before.centre[i], 1e-16) << space;
        EXPECT_NEAR(after.momentum[i], before.momentum[i], 1e-16) << space;
      }
    }
  }
}

// [Splitting 3] What the spin about the point gains is booked, about each axis.
TEST(Splitting, BooksTheSpin) {
  for (const char* shape : {"quadratic", "cubic"}) {
    for (const Space space : {Space::plane, Space::solid}) {
      Scene scene = lone_point(space, shape);
      Ledger ledger;
      const Sums before = sums_of(scene);
      split_points(scene, 0, 1, ledger);
      const Sums after = sums_of(scene);
      double largest = 0;
      for (int i = 0; i < 3; ++i) {
        const double booked = ledger.angular_momentum[static_cast<std::size_t>(i)].flow(Flow::integration);
        EXPECT_NEAR(after.turn[i] - before.turn[i], booked, 1e-16) << space << " about " << i;
        largest = std::max(largest, std::abs(booked));
      }
      EXPECT_GT(largest, 1e-6) << space << ": nothing was there to book";
    }
  }
}

// [Splitting 1, 2] Along the axis that stretches most, by a quarter of the length; the halves share what C said.
TEST(Splitting, HalvesStandAlongTheAxisThatStretchesMost) {
  Scene scene = lone_point(Space::plane);
  Columns& points = scene.bodies[0].points;
  const double c[4] = {1, -2, 3, 4};
  for (int k = 0; k < 4; ++k) points(column::affine, k)[0] = c[k];
  Ledger ledger;
  split_points(scene, 0, 1, ledger);
  const double d = std::sqrt(2 * h * h) / 4, s = std::sqrt(1 - d * d / inertia("cubic"));
  for (const int half : {0, 1}) {
    const double way = half == 0 ? -1 : 1;
    EXPECT_DOUBLE_EQ(points(column::position, 0)[half], 0.53);
    EXPECT_DOUBLE_EQ(points(column::position, 1)[half], 0.47 + way * d);
    EXPECT_DOUBLE_EQ(points(column::velocity, 0)[half], 0.3 + way * -2 * d);
    EXPECT_DOUBLE_EQ(points(column::velocity, 1)[half], -0.2 + way * 4 * d);
    EXPECT_DOUBLE_EQ(points(column::affine, 0)[half], 1);
    EXPECT_DOUBLE_EQ(points(column::affine, 1)[half], -2 * s);
    EXPECT_DOUBLE_EQ(points(column::affine, 3)[half], 4 * s);
    EXPECT_DOUBLE_EQ(points(column::energy)[half], 2);
    EXPECT_DOUBLE_EQ(points(column::density)[half], 1.5);
  }
  EXPECT_EQ(scene.bodies[0].id, (std::vector<int>{0, 1}));
  EXPECT_EQ(scene.bodies[0].split_from, (std::vector<int>{0}));
}

TEST(Splitting, OnlyPointsLargerThanAsked) {
  for (const Space space : scenes::spaces) {
    Scene scene = lone_point(space);
    Ledger ledger;
    scene.split = 0;
    EXPECT_EQ(split_points(scene, 0, 1, ledger), 0) << space;
    // Rings are measured by their section: the lone point's is 2 h^2.
    scene.split = 2.001;
    EXPECT_EQ(split_points(scene, 0, 1, ledger), 0) << space;
    scene.split = 1.999;
    EXPECT_EQ(split_points(scene, 0, 1, ledger), 1) << space;
    EXPECT_EQ(split_points(scene, 0, 1, ledger), 0) << space << ": halves are smaller";
  }
}

// Gas that is squeezed does not split, however thin a kernel at its surface finds it.
TEST(Splitting, OnlyPointsThatGrow) {
  for (const Space space : scenes::spaces) {
    Scene scene = lone_point(space);
    const int dim = scene.grid.dim;
    for (int d = 0; d < dim; ++d) scene.bodies[0].points(column::affine, d * dim + d)[0] = -1 - d;
    Ledger ledger;
    EXPECT_EQ(split_points(scene, 0, 1, ledger), 0) << space;
  }
}

// A ring that comes nearer to the axis than it is stretched is squeezed; one of a gas that only moves does not grow.
TEST(Splitting, RingsGrowAroundToo) {
  Scene scene = lone_point(Space::axisymmetric);
  Columns& points = scene.bodies[0].points;
  for (int k = 0; k < 4; ++k) points(column::affine, k)[0] = k == 0 ? 2 : 0;
  points(column::velocity)[0] = -2.01 * 0.53;
  Ledger ledger;
  EXPECT_EQ(split_points(scene, 0, 1, ledger), 0);
  points(column::velocity)[0] = -1.99 * 0.53;
  EXPECT_EQ(split_points(scene, 0, 1, ledger), 1);
  // Halves stand along a stretch in the plane: without one there is no split, however the ring grows around.
  Scene outward = lone_point(Space::axisymmetric);
  outward.bodies[0].points(column::velocity)[0] = 1;
  for (int k = 0; k < 4; ++k) outward.bodies[0].points(column::affine, k)[0] = 0;
  EXPECT_EQ(split_points(outward, 0, 1, ledger), 0);
  Scene moving = lone_point(Space::line);
  moving.bodies[0].points(column::affine)[0] = 1e-12;
  EXPECT_EQ(split_points(moving, 0, 1, ledger), 0);
}

// Where no signal crosses a cell while it is stretched to twice its length, halves would fly apart as one point does.
TEST(Splitting, NotInGasTooColdToFeelIt) {
  Scene scene = lone_point(Space::line);
  scene.bodies[0].points(column::affine)[0] = 2;
  const double felt = 0.2 * 0.2 / (1.4 * 0.4);  // c = 2 h
  Ledger ledger;
  scene.bodies[0].points(column::energy)[0] = 0.98 * felt;
  EXPECT_EQ(split_points(scene, 0, 1, ledger), 0);
  scene.bodies[0].points(column::energy)[0] = 1.02 * felt;
  EXPECT_EQ(split_points(scene, 0, 1, ledger), 1);
}

// An eighth is not split again; points are known by their numbers, wherever they stand among the others.
TEST(Splitting, ThriceAtMost) {
  for (const Space space : scenes::spaces) {
    Scene scene = lone_point(space);
    Body& body = scene.bodies[0];
    const double whole = body.points(column::mass)[0];
    Ledger ledger;
    const auto split_large = [&](const std::set<int>& large) {
      for (int p = 0; p < body.points.points(); ++p) {
        const double per_radian = space == Space::axisymmetric ? body.points(column::position)[p] : 1;
        const bool grown = large.contains(body.id[static_cast<std::size_t>(p)]);
        body.points(column::volume)[p] = (grown ? 2 : 1) * std::pow(h, scene.grid.dim) * per_radian;
      }
      return split_points(scene, 0, 1, ledger);
    };
    for (int k = 0; k < 3; ++k) EXPECT_EQ(split_large({0}), 1) << space;
    EXPECT_EQ(split_large({0}), 0) << space;
    body.points.reorder(std::vector<int>{1, 0, 2, 3}, {}, 1);  // once, thrice, twice and thrice halved
    std::swap(body.id[0], body.id[1]);
    EXPECT_EQ(split_large({0, 1, 2, 3}), 2) << space;
    const auto mass = body.points.values(column::mass).first(6);
    EXPECT_DOUBLE_EQ(*std::min_element(mass.begin(), mass.end()), whole / 8) << space;
  }
}

// No half is put beyond a wall, the axis or a piston; the centre of mass stays where it was all the same.
TEST(Splitting, NothingIsPutBeyondAWallOrPiston) {
  for (const double x : {0.001, 0.999, 0.0}) {
    Scene scene = lone_point(Space::line, "cubic", {x, 0, 0});
    Ledger ledger;
    split_points(scene, 0, 1, ledger);
    const double* position = scene.bodies[0].points(column::position);
    for (const int half : {0, 1}) {
      EXPECT_GE(position[half], 0) << x;
      EXPECT_LE(position[half], 1) << x;
    }
    EXPECT_NEAR((position[0] + position[1]) / 2, x, 1e-16);
  }
  Scene scene = lone_point(Space::line, "cubic", {0.53, 0, 0});
  scene.pistons.push_back({.direction = 0, .side = 0, .position = 0.4, .velocity = 0.1});
  Ledger ledger;
  split_points(scene, 1.2, 1, ledger);  // the piston is at 0.52
  EXPECT_NEAR(scene.bodies[0].points(column::position)[0], 0.52, 1e-15);
  EXPECT_NEAR(scene.bodies[0].points(column::position)[1], 0.54, 1e-15);
}

// Without an affine transfer the halves have the point's velocity; linear shapes have no inertia that stays.
TEST(Splitting, WithoutAnAffineVelocityHalvesMoveAlike) {
  Scene scene = lone_point(Space::line);
  Scene flip = scenes::scene_of(scene.grid,
                                {scenes::gas_body(scenes::inviscid_law(), 1, {{0.53, 0, 0}}, 2 * h,
                                                  [](const scenes::Place&) {
                                                    return scenes::GasState{1, 1, {0.5, 0, 0}};
                                                  })},
                                "linear", "flip");
  flip.split = 1.3;
  Ledger ledger;
  EXPECT_EQ(split_points(flip, 0, 1, ledger), 1);
  for (const int half : {0, 1}) EXPECT_EQ(flip.bodies[0].points(column::velocity)[half], 0.5);
  EXPECT_EQ(splitting_refusal("linear", "flip"), "");
  EXPECT_EQ(splitting_refusal("quadratic", "apic"), "");
  EXPECT_NE(splitting_refusal("linear", "apic"), "");
  EXPECT_NE(splitting_refusal("gimp", "apic"), "");
  EXPECT_NE(splitting_refusal("contiguous-gimp", "apic"), "");
  EXPECT_EQ(splitting_refusal("gimp", "flip"), "");
  scene.shape = "linear";
  EXPECT_THROW(Simulation(scene, "musl", {}), std::invalid_argument);
}

// --- in a run -------------------------------------------------------------------------------------------------------

// Gas that flies apart from the middle of a long grid, until points stand further apart than a cell.
Scene parting(Space space) {
  const int dim = scenes::dim_of(space);
  const std::array<int, 3> cells{24, dim == 3 ? 5 : 24, dim == 3 ? 5 : 24};
  const GridSpec grid = scenes::box(space, cells, h, scenes::walls_everywhere(Wall::symmetry));
  std::array<int, 3> first{8, 8, 8}, last{16, 16, 16};
  if (dim == 3) first[1] = first[2] = 0, last[1] = last[2] = 5;
  const auto places = scenes::jittered(scenes::lattice(grid, 1, first, last), 0.01, dim);
  Scene scene = scenes::scene_of(
      grid,
      {scenes::gas_body(scenes::inviscid_law(), space, places, scenes::lattice_volume(grid, 1),
                        [](const scenes::Place& x) {
                          return scenes::GasState{1, 2, {8 * (x[0] - 1.2), 2 * (x[0] - 1.2), 0}};
                        })},
      "cubic", "apic");
  scene.split = 1.3;
  return scene;
}

TEST(SplittingRun, ClosesTheLedgerAndNumbersNewPoints) {
  for (const Space space : scenes::spaces) {
    const Scene scene = parting(space);
    const int made = scene.bodies[0].points.points();
    Simulation run(scene, "leapfrog", {0.5, {}});
    run.run_until(0.1);
    const Body& body = run.scene().bodies[0];
    ASSERT_GT(run.points(), made) << space;
    scenes::expect_ledger_closes(run.ledger(), 1e-12);
    EXPECT_EQ(std::set<int>(body.id.begin(), body.id.end()).size(), body.id.size());
    EXPECT_EQ(*std::max_element(body.id.begin(), body.id.end()), run.points() - 1);
    ASSERT_EQ(static_cast<long>(body.split_from.size()), run.points() - made);
    for (std::size_t k = 0; k < body.split_from.size(); ++k) {
      EXPECT_LT(body.split_from[k], made + static_cast<int>(k)) << "a point comes from one that was there";
    }
  }
}

TEST(SplittingRun, DoesNotDependOnThreads) {
  for (const Space space : {Space::line, Space::plane, Space::solid}) {
    Simulation one(parting(space), "leapfrog", {0.5, {}, 1}), two(parting(space), "leapfrog", {0.5, {}, 2});
    one.run_until(0.1);
    two.run_until(0.1);
    EXPECT_TRUE(scenes::same_bits(one.scene().bodies[0], two.scene().bodies[0])) << space;
    scenes::expect_same_ledger(one.ledger(), two.ledger());
  }
}

TEST(SplittingRun, GoesOnFromACheckpointAsIfNeverStopped) {
  Simulation run(parting(Space::plane), "leapfrog", {0.5, {}});
  run.run_until(0.1);
  const Checkpoint end = run.save();
  Simulation other(parting(Space::plane), "leapfrog", {0.5, {}});
  while (other.time() < 0.1 && other.scene().bodies[0].split_from.empty()) other.step(0.1 - other.time());
  ASSERT_LT(other.points(), run.points()) << "more are to come";
  const Checkpoint middle = other.save();
  Simulation third(parting(Space::plane), "leapfrog", {0.5, {}});
  third.restore(middle);
  third.run_until(0.1);
  EXPECT_TRUE(scenes::same_bits(third.scene().bodies[0], run.scene().bodies[0]));
  scenes::expect_same_ledger(third.ledger(), run.ledger());
  third.restore(middle);  // back to fewer points
  third.run_until(0.1);
  EXPECT_TRUE(scenes::same_bits(third.scene().bodies[0], run.scene().bodies[0]));
  EXPECT_EQ(end.split_from[0], third.scene().bodies[0].split_from);
}

}  // namespace
}  // namespace plumbline::splitting_test
