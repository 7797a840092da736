// Balanced weights: a uniform tension is at rest, and what least squares make exact stays exact. [Surface 14, 18]
#include "kernel/surface_balance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "kernel/materials/surface_law.hpp"
#include "kernel/surface_neighbours.hpp"
#include "tests/kernel/scenes.hpp"

namespace plumbline::surface_balance_test {
namespace {

constexpr int along = 12, across = 8;
constexpr double spacing = 0.1, reach = 0.28;

struct Sheet {
  Columns points{along * across};
  std::vector<std::array<double, 3>> outward;
};

// Irregular points with four free edges, of unequal areas; corners lie out of both of theirs, along the diagonal.
Sheet sheet() {
  Sheet all;
  scenes::Random random(5);
  all.points.add(column::position, 3);
  all.points.add(column::tangents, 6);
  all.points.add(column::volume);
  for (int p = 0; p < along * across; ++p) {
    const double x = spacing * (p % along) + random(-0.03, 0.03), y = spacing * (p / along) + random(-0.03, 0.03);
    all.points(column::position, 0)[p] = x;
    all.points(column::position, 1)[p] = y;
    all.points(column::tangents, 0)[p] = all.points(column::tangents, 4)[p] = 1;
    all.points(column::volume)[p] = 1 + random(-0.2, 0.2);
    std::array<double, 3> out{0, 0, 0};
    if (x < 0.3 || x > spacing * along - 0.4) out[0] = x < 0.3 ? -1 : 1;
    if (y < 0.3 || y > spacing * across - 0.4) out[1] = y < 0.3 ? -1 : 1;
    const double size = std::hypot(out[0], out[1]);
    for (double& o : out) o /= size > 0 ? size : 1;
    all.outward.push_back(out);
  }
  return all;
}

// g_k of a uniform tension, over the mean area and the spacing.
std::vector<std::array<double, 2>> pulls(const Sheet& of, const SurfaceNeighbours& all) {
  std::vector<std::array<double, 2>> g;
  for (std::size_t k = 0; k + 1 < all.on.first.size(); ++k) {
    std::array<double, 2> sum{0, 0};
    for (int n = all.on.first[k]; n < all.on.first[k + 1]; ++n) {
      const double area = of.points(column::volume)[all.on.other[static_cast<std::size_t>(n)]];
      sum[0] += spacing * area * all.on.along[static_cast<std::size_t>(n)];
      sum[1] += spacing * area * all.on.across[static_cast<std::size_t>(n)];
    }
    g.push_back(sum);
  }
  return g;
}

// The largest pull in the surface but out of an edge.
double largest_pull(const Sheet& of, const SurfaceNeighbours& all) {
  const auto g = pulls(of, all);
  double most = 0;
  for (std::size_t k = 0; k < g.size(); ++k) {
    const auto& out = of.outward[k];
    most = std::max(most, out[0] == 0 && out[1] == 0 ? std::hypot(g[k][0], g[k][1])
                                                     : std::abs(out[0] * g[k][1] - out[1] * g[k][0]));
  }
  return most;
}

TEST(SurfaceBalance, UniformTensionIsAtRest) {  // [Surface 14]
  const Sheet of = sheet();
  EXPECT_GT(largest_pull(of, surface_neighbours(of.points, reach)), 1e-2);
  EXPECT_LT(largest_pull(of, surface_neighbours(of.points, reach, {}, {}, of.outward)), 1e-9);
}

TEST(SurfaceBalance, QuadraticMotionsStayExact) {  // [Surface 1, 14]
  const Sheet of = sheet();
  const SurfaceNeighbours all = surface_neighbours(of.points, reach, {}, {}, of.outward);
  const double *x = of.points(column::position, 0), *y = of.points(column::position, 1);
  for (int p = 0; p < along * across; ++p) {
    double first = 0, second = 0;
    for (int n = all.of.first[static_cast<std::size_t>(p)]; n < all.of.first[static_cast<std::size_t>(p) + 1]; ++n) {
      const int q = all.of.other[static_cast<std::size_t>(n)];
      const double moved = 3 + 0.7 * x[q] - 0.4 * x[q] * x[q] + 1.1 * x[q] * y[q] + 0.6 * y[q] * y[q];
      first += all.of.along[static_cast<std::size_t>(n)] * moved;
      second += all.of.across[static_cast<std::size_t>(n)] * moved;
    }
    EXPECT_NEAR(first, 0.7 - 0.8 * x[p] + 1.1 * y[p], 1e-9) << p;
    EXPECT_NEAR(second, 1.1 * x[p] + 1.2 * y[p], 1e-9) << p;
  }
}

// A cylinder with two free edges: rows pull by A/R whether they stand at an edge or not. The circle lies (r/R)^2/4 of the parabola's height
// off it at most, r the reach; twice that for what least squares make of it. Weights of least squares leave a tenth and more at the edges.
TEST(SurfaceBalance, RowsAtAnEdgePullAsTheirCurvatureAsks) {  // [Surface 18]
  constexpr int around = 80, rows = 9;
  const double radius = around * spacing / (2 * std::numbers::pi), within = reach * reach / (2 * radius * radius);
  Columns points(around * rows);
  points.add(column::position, 3);
  points.add(column::tangents, 6);
  points.add(column::volume);
  std::vector<std::array<double, 3>> outward;
  for (int p = 0; p < around * rows; ++p) {
    const double angle = 2 * std::numbers::pi * (p % around) / around, z = spacing * (p / around);
    points(column::position, 0)[p] = radius * std::cos(angle);
    points(column::position, 1)[p] = radius * std::sin(angle);
    points(column::position, 2)[p] = z;
    points(column::tangents, 0)[p] = -std::sin(angle);
    points(column::tangents, 1)[p] = std::cos(angle);
    points(column::tangents, 5)[p] = 1;
    points(column::volume)[p] = 1;
    const bool low = z<reach, high = z> spacing * (rows - 1) - reach;
    outward.push_back({0, 0, low ? -1.0 : high ? 1.0 : 0.0});
  }
  const auto largest_miss = [&](const SurfaceNeighbours& all) {
    double most = 0;
    for (int k = 0; k < around * rows; ++k) {
      double pull = 0;  // along the normal
      for (int n = all.on.first[static_cast<std::size_t>(k)]; n < all.on.first[static_cast<std::size_t>(k) + 1]; ++n) {
        const int p = all.on.other[static_cast<std::size_t>(n)];
        for (int d = 0; d < 2; ++d)
          pull += all.on.along[static_cast<std::size_t>(n)] * points(column::tangents, d)[p] *
                  points(column::position, d)[k] / radius;
      }
      most = std::max(most, std::abs(pull * radius - 1));
    }
    return most;
  };
  EXPECT_GT(largest_miss(surface_neighbours(points, reach)), 0.1);
  EXPECT_LT(largest_miss(surface_neighbours(points, reach, {}, {}, outward)), within);
}

TEST(SurfaceBalance, EachPointSaysWhereItsEdgeIs) {
  Sheet of = sheet();
  of.outward.pop_back();
  EXPECT_THROW(surface_neighbours(of.points, reach, {}, {}, of.outward), std::invalid_argument);
}

// Next to a rim of odd images a curved surface does not pull as its curvature asks.
TEST(SurfaceBalance, ImagesAreOfFlatSheets) {
  Sheet of = sheet();
  std::vector<OddImage> images;
  for (int p = 0; p < along * across; ++p) {
    const double x = of.points(column::position, 0)[p], y = of.points(column::position, 1)[p];
    of.points(column::position, 2)[p] = 0.3 * x * x;
    if (y < 0.25) images.push_back({p, {x, -0.1 - y, 0.3 * x * x}});
  }
  try {
    surface_neighbours(of.points, reach, images, {}, of.outward);
    FAIL() << "weights of a curved surface with images";
  } catch (const std::invalid_argument& refusal) {
    EXPECT_NE(std::string(refusal.what()).find("curved surface has images"), std::string::npos) << refusal.what();
  }
}

// Without free edges a sheet that ends cannot hold a tension: of all pulls the moment is that of the tension.
TEST(SurfaceBalance, NoWeightsWithoutTheEdges) {
  Sheet of = sheet();
  for (auto& out : of.outward) out = {0, 0, 0};
  EXPECT_THROW(surface_neighbours(of.points, reach, {}, {}, of.outward), std::invalid_argument);
}

}  // namespace
}  // namespace plumbline::surface_balance_test
