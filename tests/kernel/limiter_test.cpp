// What of a flow is linear along an axis, and how much of the sharpening stays, on flows whose answers are known.
#include "kernel/limiter.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kernel/walls.hpp"
#include "tests/kernel/scenes.hpp"

namespace plumbline::limiter_test {
namespace {

// A line of nodes 1/2 m apart with a velocity and a density by the index of the node, ghosts left out.
struct Line {
  using Vec = Eigen::Matrix<double, 1, 1>;
  Grid<1> grid;
  VelocityField<1> field;
  std::vector<double> inverse_volumes;
  std::vector<Vec> u, slopes, kept;

  template <class Velocity, class Density>
  Line(Velocity velocity, Density density, Wall wall = Wall::free)
      : grid(scenes::box(scenes::Space::line, {20, 20, 20}, 0.5, scenes::walls_everywhere(wall))),
        field(grid),
        inverse_volumes(field.mass.size(), 2.0),
        u(field.mass.size()),
        slopes(field.mass.size(), Vec::Zero()),
        kept(field.mass.size(), Vec::Constant(7)) {
    field.touched[0] = {0, grid.row_length()};
    for (int i = 0; i < grid.node_count(); ++i) {
      const auto at = static_cast<std::size_t>(i);
      const int k = i - Grid<1>::ghosts;
      const bool half = wall != Wall::free && (k == 0 || k == 20);
      u[at][0] = velocity(k);
      field.mass[at] = 0.5 * density(k) * (half ? 0.5 : 1);
      if (half) inverse_volumes[at] *= 2;
    }
  }
  double kept_at(int k, double least) {
    Limiter<1>(grid).find_kept(field, inverse_volumes, least, u, slopes, kept, 1);
    return kept[static_cast<std::size_t>(k + Grid<1>::ghosts)][0];
  }
};

// Densities fall by the factor 1.1 from node to node, so that each node has 11/21 of its slope from below, the rest from above,
// and x = 21/221.
double falling(int k) { return std::pow(1.1, -k); }

// At the head of an expansion the slopes are 0, 10 s / 21, s: of the node in the middle r- = 0, so nothing is linear; of the next
// one r- = 10/21 and r+ = 1, so more than half is. [Limiter 2]
TEST(Limiter, KeepsLessWhereAnExpansionBegins) {
  Line head([](int k) { return k < 10 ? 0.0 : 0.1 * (k - 10); }, falling);
  EXPECT_EQ(head.kept_at(8, 0.25), 1);
  EXPECT_DOUBLE_EQ(head.kept_at(10, 0.25), 0.25);
  EXPECT_DOUBLE_EQ(head.kept_at(10, 0.5), 0.5);
  EXPECT_EQ(head.kept_at(11, 0.25), 1);
  EXPECT_EQ(head.kept_at(15, 0.25), 1);
}

// The same flow the other way round closes. [Limiter 2]
TEST(Limiter, KeepsAllWhereAGasCloses) {
  Line foot([](int k) { return k < 10 ? 0.0 : -0.1 * (k - 10); }, falling);
  for (int k = 0; k <= 20; ++k) EXPECT_EQ(foot.kept_at(k, 0.25), 1) << k;
}

// Slopes of 1, (11 + 100) / 21 and 10: psi = 2 r- = 42/111. [Limiter 2]
TEST(Limiter, KeepsMoreWhereSomeOfTheFlowIsLinear) {
  Line bend([](int k) { return k < 11 ? 0.01 * k : 0.1 + 0.1 * (k - 10); }, falling);
  EXPECT_NEAR(bend.kept_at(10, 0.25), 1 - 0.75 * (1 - 2 * (200.0 / 221) * (42.0 / 111)), 1e-14);
}

// Densities r and 1/r beside a node, their difference over their sum x: of the limit 32 x counts, up to 1, and of slopes of 0, s r/(1 + r)
// and s the share 1/r. An even gas, as one that carries a small wave to first order, keeps all. [Limiter 2]
TEST(Limiter, CountsByTheChangeOfDensity) {
  for (const double x : {0.0, 1e-6, 0.01, 1.0 / 32, 0.1}) {
    const double ratio = std::sqrt((1 + x) / (1 - x));
    Line head([](int k) { return k < 10 ? 0.0 : 0.1 * (k - 10); }, [&](int k) { return std::pow(ratio, k); });
    EXPECT_NEAR(head.kept_at(10, 0.25), 1 - 0.75 * std::min(1.0, 32 * x) / ratio, 1e-13) << x;  // of some 32 roundings
  }
}

// Slopes of 0, 1 and 1 + b: nothing is linear, and |1 + b| - 1 of the limit counts, up to 1. One that stands out is noise. [Limiter 2]
TEST(Limiter, CountsByTheSlopesBesideOne) {
  for (const double b : {-4.0, -2.75, -1.0, 0.0, 0.25, 1.0, 3.0}) {
    const auto velocity = [=](int k) {  // from the differences of neighbours, of which a slope has 11/21 and 10/21
      return 0.01 * (k <= 8 ? -10.0 / 11 * (k - 9) - 1 : k < 12 ? k - 10 : 2 + (1 + 2.1 * b) * (k - 11) - 1);
    };
    Line line(velocity, falling);
    EXPECT_NEAR(line.kept_at(10, 0.25), 1 - 0.75 * std::clamp(std::abs(1 + b) - 1, 0.0, 1.0), 1e-13) << b;
  }
}

// At a free edge density falls to nothing and no slope is known beyond: one as within keeps all, one of a third of that beside it, as
// r- - 1 = 2, the least. At a wall the images have the density that is there, for all that the
// wall's cell is half. [Limiter 2]
TEST(Limiter, KnowsEdgesAndWalls) {
  const auto expanding = [](int k) { return 0.1 * k; };
  const auto gas = [](int k) { return k > 14 ? 0.0 : 1.0; };
  Line edge(expanding, gas);
  EXPECT_NEAR(edge.kept_at(14, 0.25), 1, 1e-14);
  EXPECT_EQ(edge.kept_at(12, 0.25), 1);
  Line slack([](int k) { return k < 14 ? 0.1 * k : 1.3 + 0.02; }, gas);
  EXPECT_DOUBLE_EQ(slack.kept_at(14, 0.25), 0.25);
  Line wall([](int k) { return 0.01 * k * k * k; }, [](int) { return 1.0; }, Wall::symmetry);  // linear nowhere
  for (const int k : {0, 1, 2}) EXPECT_EQ(wall.kept_at(k, 0.25), 1) << k;
}

// What a node has of its mass in 1e-15 of its neighbours' says nothing, whatever its velocity. [Limiter 2]
TEST(Limiter, DoesNotAskNodesThatCarryNextToNothing) {
  const auto line = [](double velocity_at_edge) {
    return Line([=](int k) { return k == 15 ? velocity_at_edge : 0.01 * k * k; },
                [](int k) { return k > 15    ? 0.0
                                   : k == 15 ? 1e-15
                                             : falling(k); });
  };
  Line slow = line(2), fast = line(1e3);
  for (int k = 5; k < 15; ++k) EXPECT_NEAR(slow.kept_at(k, 0.25), fast.kept_at(k, 0.25), 1e-10) << k;
}

}  // namespace
}  // namespace plumbline::limiter_test
