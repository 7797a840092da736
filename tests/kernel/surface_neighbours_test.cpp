// Tangents from places: what moving least squares of the start must give, whatever the points. [Surface 1, 4]
#include "kernel/surface_neighbours.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
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

using Lists = std::vector<std::vector<int>>;

// Of each point of a sheet of 7 x 6 those no farther than this many points along and across.
Lists within(int along, int across) {
  Lists all(42);
  for (int p = 0; p < 42; ++p) {
    for (int q = 41; q >= 0; --q) {  // in any order
      if (q != p && std::abs(q % 7 - p % 7) <= along && std::abs(q / 7 - p / 7) <= across)
        all[static_cast<std::size_t>(p)].push_back(q);
    }
  }
  return all;
}

// Whoever the neighbours are, quadratic motions are exact; others, though within reach, have no weight. [Surface 1]
TEST(SurfaceNeighbours, GivenOnesAreTheOnlyOnes) {
  const Columns points = sheet(7, 6, flat(), in_plane);
  const Lists given = within(2, 3);
  const SurfaceNeighbours all = surface_neighbours(points, 1.0, {}, {}, {}, given);
  const auto moved = [&](int p) {
    const Vec x = place(points, p);
    return Vec(x[0] + 0.4 * x[0] * x[1], 1.1 * x[1] - 0.3 * x[0] * x[0], x[1] * x[1]);
  };
  for (int p = 0; p < points.points(); ++p) {
    const auto at = static_cast<std::size_t>(p);
    std::vector<int> links(all.of.other.begin() + all.of.first[at], all.of.other.begin() + all.of.first[at + 1] - 1);
    std::sort(links.begin(), links.end());
    EXPECT_EQ(links, std::vector<int>(given[at].rbegin(), given[at].rend()));
    const Vec x = place(points, p);
    Frame exact;
    exact << 1 + 0.4 * x[1], 0.4 * x[0], -0.6 * x[0], 1.1, 0, 2 * x[1];
    EXPECT_LT((tangents(all, p, moved) - exact).norm(), 1e4 * rounding) << p;
  }
}

TEST(SurfaceNeighbours, GivenOnesBeyondReachAreNone) {
  const Columns points = sheet(7, 6, flat(), in_plane);
  const SurfaceNeighbours found = surface_neighbours(points, reach),
                          all = surface_neighbours(points, reach, {}, {}, {}, within(7, 6));
  EXPECT_EQ(all.of.other, found.of.other);
  EXPECT_EQ(all.of.along, found.of.along);
  EXPECT_EQ(all.of.across, found.of.across);
}

TEST(SurfaceNeighbours, ClearErrorsOfGivenOnes) {
  const Columns points = sheet(7, 6, flat(), in_plane);
  const auto given = [&](const Lists& lists) { surface_neighbours(points, reach, {}, {}, {}, lists); };
  EXPECT_NO_THROW(given(within(3, 3)));
  EXPECT_THROW(given(Lists(41)), std::invalid_argument);
  EXPECT_THROW(given(within(1, 0)), std::invalid_argument);  // too few
  for (const int wrong : {0, 42, -1}) {                      // itself, and no points
    Lists lists = within(3, 3);
    lists[0].push_back(wrong);
    EXPECT_THROW(given(lists), std::invalid_argument) << wrong;
  }
}

TEST(SurfaceNeighbours, ClearErrors) {
  EXPECT_THROW(surface_neighbours(sheet(6, 5, flat(), in_plane), 0.12), std::invalid_argument);  // too few
  EXPECT_THROW(surface_neighbours(sheet(6, 5, Frame::Zero(), in_plane), reach), std::invalid_argument);
}

}  // namespace
}  // namespace plumbline::surface_neighbours_test
