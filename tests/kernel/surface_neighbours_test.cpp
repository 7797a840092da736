// Tangents from places: what moving least squares of the start must give, whatever the points. [Surface 1, 4]
#include "kernel/surface_neighbours.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <vector>

#include "tests/kernel/scenes.hpp"

namespace plumbline::surface_neighbours_test {
namespace {

using Vec = Eigen::Vector3d;
using Frame = Eigen::Matrix<double, 3, 2>;
constexpr double reach = 0.28;
constexpr double rounding = 1e-12;  // sums of some twenty places of order one, weighted by up to 1 / 0.1

// An irregular sheet of points a tenth apart, at x = X(u, v) with tangents of the frame.
template <class At>
Columns sheet(int along, int across, const Frame& tangents, At&& at, double jitter = 0.03) {
  scenes::Random random(3);
  Columns points(along * across);
  points.add(column::position, 3);
  points.add(column::tangents, 6);
  for (int p = 0; p < points.points(); ++p) {
    const double u = 0.1 * (p % along) + random(-jitter, jitter), v = 0.1 * (p / along) + random(-jitter, jitter);
    const Vec x = at(u, v);
    for (int d = 0; d < 3; ++d) {
      points(column::position, d)[p] = x[d];
      for (int a = 0; a < 2; ++a) points(column::tangents, 3 * a + d)[p] = tangents(d, a);
    }
  }
  return points;
}

Vec place(const Columns& points, int p) {
  return {points(column::position, 0)[p], points(column::position, 1)[p], points(column::position, 2)[p]};
}

template <class Of>
Frame tangents(const SurfaceNeighbours& all, int p, Of&& of) {
  Frame f = Frame::Zero();
  for (int k = all.of.first[static_cast<std::size_t>(p)]; k < all.of.first[static_cast<std::size_t>(p) + 1]; ++k) {
    const auto n = static_cast<std::size_t>(k);
    const Vec x = of(all.of.other[n]);
    f.col(0) += all.of.along[n] * x;
    f.col(1) += all.of.across[n] * x;
  }
  for (int k = 0; !all.fixed.empty() && k < 6; ++k) f(k % 3, k / 3) += all.fixed[static_cast<std::size_t>(6 * p + k)];
  return f;
}

Frame flat() { return (Frame() << 1, 0, 0, 1, 0, 0).finished(); }
Vec in_plane(double u, double v) { return {u, v, 0}; }

TEST(SurfaceNeighbours, QuadraticMotionsOfASheetAreExact) {  // [Surface 1]
  const Columns points = sheet(8, 7, flat(), in_plane);
  const SurfaceNeighbours all = surface_neighbours(points, reach);
  const auto moved = [&](int p) {
    const Vec x = place(points, p);
    return Vec(x[0] + 0.4 * x[0] * x[1], 2 + 1.1 * x[1] - 0.3 * x[0] * x[0], 0.2 * x[0] + x[1] * x[1]);
  };
  for (int p = 0; p < points.points(); ++p) {
    const Vec x = place(points, p);
    Frame exact;
    exact << 1 + 0.4 * x[1], 0.4 * x[0], -0.6 * x[0], 1.1, 0.2, 2 * x[1];
    EXPECT_LT((tangents(all, p, moved) - exact).norm(), 1e3 * rounding) << p;
  }
}

// A sheet that is bent and stretched at the start: what is at rest is what its tangents say. In the plane of these the places of
// neighbours are the coordinates at rest, so that the tangents themselves come back there.
TEST(SurfaceNeighbours, StartsWithTheTangentsGiven) {  // [Surface 1]
  const Frame stretched = 1.3 * flat();
  const Columns points = sheet(8, 7, stretched, [](double u, double v) { return Vec(1.3 * u, 1.3 * v, 0); });
  const SurfaceNeighbours all = surface_neighbours(points, reach);
  for (int p = 0; p < points.points(); ++p) {
    EXPECT_LT((tangents(all, p, [&](int q) { return place(points, q); }) - stretched).norm(), 1e3 * rounding);
  }
}

TEST(SurfaceNeighbours, MovingOrTurningTheWholeTurnsTangents) {
  const Columns points = sheet(8, 7, flat(), [](double u, double v) { return Vec(u, v, 0.3 * u * u); });
  const SurfaceNeighbours all = surface_neighbours(points, reach);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.1, Vec(1, 2, -1).normalized()).toRotationMatrix();
  for (int p = 0; p < points.points(); ++p) {
    const Frame start = tangents(all, p, [&](int q) { return place(points, q); });
    const Frame now = tangents(all, p, [&](int q) { return Vec(turn * place(points, q) + Vec(3, -2, 5)); });
    EXPECT_LT((now - turn * start).norm(), 1e3 * rounding) << p;
  }
}

TEST(SurfaceNeighbours, LinksOnAPointAreThoseOfTheOthers) {
  const Columns points = sheet(6, 5, flat(), in_plane);
  const SurfaceNeighbours all = surface_neighbours(points, reach);
  const int n = points.points();
  Eigen::MatrixXd of = Eigen::MatrixXd::Zero(n, n), on = of;
  for (int p = 0; p < n; ++p) {
    const auto at = static_cast<std::size_t>(p);
    for (int k = all.of.first[at]; k < all.of.first[at + 1]; ++k)
      of(p, all.of.other[static_cast<std::size_t>(k)]) += all.of.across[static_cast<std::size_t>(k)];
    for (int k = all.on.first[at]; k < all.on.first[at + 1]; ++k)
      on(p, all.on.other[static_cast<std::size_t>(k)]) += all.on.across[static_cast<std::size_t>(k)];
  }
  EXPECT_EQ((of - on.transpose()).norm(), 0.0);
}

// A half sheet with odd images behind its edge x = 0 has the tangents of the whole sheet in a motion that is odd about it. [Surface 4]
TEST(SurfaceNeighbours, ImagesStandForTheOtherHalf) {
  const auto half = [](double u, double v) { return Vec(u + 0.05, v, 0); };
  const Columns points = sheet(8, 7, flat(), half, 0.0);
  std::vector<OddImage> images;
  for (int p = 0; p < points.points(); ++p) {
    const Vec x = place(points, p);
    if (x[0] < 0.3) images.push_back({p, {-x[0], x[1], x[2]}});
  }
  const SurfaceNeighbours all = surface_neighbours(points, reach, images);
  const auto moved = [&](int p) {  // of the whole sheet linear in x, and odd about the edge
    const Vec x = place(points, p);
    return Vec(x[0], x[1], 0.3 * x[0]);
  };
  for (int p = 0; p < points.points(); ++p) {
    const Frame f = tangents(all, p, moved);
    EXPECT_NEAR(f(2, 0), 0.3, 1e3 * rounding) << p;
    EXPECT_NEAR(f(0, 0), 1, 1e3 * rounding) << p;
  }
}

TEST(SurfaceNeighbours, OtherSheetsAreNoNeighbours) {
  Columns points = sheet(6, 6, flat(), in_plane);
  std::vector<int> number;
  for (int p = 0; p < points.points(); ++p) number.push_back(p % 6 < 3 ? 0 : 1);
  const SurfaceNeighbours all = surface_neighbours(points, 0.4, {}, number);
  for (int p = 0; p < points.points(); ++p) {
    const auto at = static_cast<std::size_t>(p);
    for (int k = all.of.first[at]; k < all.of.first[at + 1]; ++k) {
      EXPECT_EQ(number[static_cast<std::size_t>(all.of.other[static_cast<std::size_t>(k)])], number[at]);
    }
  }
}

// Whoever the neighbours are, quadratic motions are exact; and of others nothing is heard. [Surface 1]
TEST(SurfaceNeighbours, GivenOnesAreTheOnlyOnes) {
  const Columns points = sheet(7, 6, flat(), in_plane);
  std::vector<std::vector<int>> given(static_cast<std::size_t>(points.points()));
  for (int p = 0; p < points.points(); ++p) {
    for (int q = 0; q < points.points(); ++q) {
      const int along = std::abs(q % 7 - p % 7), across = std::abs(q / 7 - p / 7);
      if (q != p && along <= 2 && across <= 3) given[static_cast<std::size_t>(p)].push_back(q);
    }
  }
  const SurfaceNeighbours all = surface_neighbours(points, given);
  const auto moved = [&](int p) {
    const Vec x = place(points, p);
    return Vec(x[0] + 0.4 * x[0] * x[1], 1.1 * x[1] - 0.3 * x[0] * x[0], x[1] * x[1]);
  };
  for (int p = 0; p < points.points(); ++p) {
    const auto at = static_cast<std::size_t>(p);
    const std::vector<int> links(all.of.other.begin() + all.of.first[at], all.of.other.begin() + all.of.first[at + 1]);
    std::vector<int> expected = given[at];
    expected.push_back(p);
    EXPECT_EQ(links, expected);
    const Vec x = place(points, p);
    Frame exact;
    exact << 1 + 0.4 * x[1], 0.4 * x[0], -0.6 * x[0], 1.1, 0, 2 * x[1];
    EXPECT_LT((tangents(all, p, moved) - exact).norm(), 1e3 * rounding) << p;
  }
}

// A reach a fifth farther than the farthest neighbour of all points finds the same points with the same weights.
TEST(SurfaceNeighbours, GivenAsFoundAreWeightedAsFound) {
  const Columns points = sheet(9, 8, flat(), in_plane, 0.0);
  const SurfaceNeighbours found = surface_neighbours(points, 1.2 * std::hypot(0.1, 0.2));  // less than (0.2, 0.2)
  std::vector<std::vector<int>> given(static_cast<std::size_t>(points.points()));
  for (std::size_t p = 0; p < given.size(); ++p) {
    for (int k = found.of.first[p]; k + 1 < found.of.first[p + 1]; ++k)
      given[p].push_back(found.of.other[static_cast<std::size_t>(k)]);
  }
  const SurfaceNeighbours all = surface_neighbours(points, given);
  ASSERT_EQ(all.of.other, found.of.other);
  for (std::size_t k = 0; k < found.of.other.size(); ++k) {
    EXPECT_NEAR(all.of.along[k], found.of.along[k], 1e3 * rounding);
    EXPECT_NEAR(all.of.across[k], found.of.across[k], 1e3 * rounding);
  }
}

TEST(SurfaceNeighbours, ClearErrorsOfGivenOnes) {
  const Columns points = sheet(3, 3, flat(), in_plane);
  std::vector<std::vector<int>> all(9);
  for (int p = 0; p < 9; ++p) {
    for (int q = 0; q < 9; ++q) {
      if (q != p) all[static_cast<std::size_t>(p)].push_back(q);
    }
  }
  EXPECT_NO_THROW(surface_neighbours(points, all));
  EXPECT_THROW(surface_neighbours(points, std::vector<std::vector<int>>(8)), std::invalid_argument);
  // None, too few, itself, and no points.
  for (const std::vector<int>& wrong :
       {std::vector<int>{}, {1, 2, 3, 4}, {0, 1, 2, 3, 4, 5}, {1, 2, 3, 4, 5, 9}, {-1}}) {
    auto given = all;
    given[0] = wrong;
    EXPECT_THROW(surface_neighbours(points, given), std::invalid_argument);
  }
}

TEST(SurfaceNeighbours, ClearErrors) {
  EXPECT_THROW(surface_neighbours(sheet(6, 5, flat(), in_plane), 0.12), std::invalid_argument);  // too few
  EXPECT_THROW(surface_neighbours(sheet(6, 5, Frame::Zero(), in_plane), reach), std::invalid_argument);
}

}  // namespace
}  // namespace plumbline::surface_neighbours_test
