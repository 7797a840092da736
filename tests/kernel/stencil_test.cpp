#include "kernel/stencil.hpp"

#include <set>

#include "kernel/shapes/cubic.hpp"
#include "kernel/shapes/linear.hpp"
#include "kernel/shapes/quadratic.hpp"
#include "tests/kernel/scenes.hpp"

namespace plumbline {
namespace {

// Sums of up to 16 products of numbers of order one.
constexpr double rounding = 1e-14;

// In the plane: sum N = 1, sum grad N = 0, sum N r = 0, sum r grad N^T = 1, sum N r r^T = D, N r = D a.
// [EC-APIC 5]
template <class Shape>
void expect_plane_identities() {
  const double h = 0.5;
  for (double fx : {-0.3, 0.05, 0.4}) {
    for (double fy : {-0.45, 0.2}) {
      const double shift = Shape::support == 3 ? 0.0 : 0.5;
      const double local[2] = {fx + shift, fy + shift};
      const Stencil<2, Shape> stencil(7, 20, local, h);
      double n_sum = 0;
      Eigen::Vector2d g_sum = Eigen::Vector2d::Zero(), r_sum = g_sum;
      Eigen::Matrix2d moment = Eigen::Matrix2d::Zero(), slope = moment, affine = moment;
      std::set<std::size_t> nodes;
      stencil.for_nodes(
          [&](std::size_t i, double n, const Eigen::Vector2d& g, const Eigen::Vector2d& r, const Eigen::Vector2d& a) {
            nodes.insert(i);
            n_sum += n;
            g_sum += g;
            r_sum += n * r;
            moment += n * r * r.transpose();
            slope += r * g.transpose();
            affine += r * a.transpose();
          });
      const Eigen::Vector2d d2(Shape::inertia(local[0]) * h * h, Shape::inertia(local[1]) * h * h);
      EXPECT_NEAR(n_sum, 1, rounding);
      EXPECT_LE(g_sum.norm(), rounding / h);
      EXPECT_LE(r_sum.norm(), rounding);
      EXPECT_LE((moment - Eigen::Matrix2d(d2.asDiagonal())).norm(), rounding);
      EXPECT_LE((slope - Eigen::Matrix2d::Identity()).norm(), rounding);
      EXPECT_LE((affine - Eigen::Matrix2d::Identity()).norm(), rounding);
      EXPECT_EQ(nodes.size(), static_cast<std::size_t>(Shape::support * Shape::support));
      EXPECT_EQ(*nodes.begin(), 7u);
      EXPECT_EQ(*nodes.rbegin(), 7u + (Shape::support - 1) * 21);
    }
  }
}

TEST(Stencil, LinearInThePlane) { expect_plane_identities<Linear>(); }
TEST(Stencil, QuadraticInThePlane) { expect_plane_identities<Quadratic>(); }
TEST(Stencil, CubicInThePlane) { expect_plane_identities<Cubic>(); }

TEST(Stencil, OnALine) {
  const double local[1] = {0.25};
  const Stencil<1, Linear> stencil(3, 10, local, 0.1);
  std::vector<double> seen;
  stencil.for_nodes([&](std::size_t i, double n, const auto& g, const auto& r, const auto& a) {
    seen.insert(seen.end(), {static_cast<double>(i), n, g[0], r[0], a[0]});
  });
  const std::vector<double> expected{3, 0.75, -10, -0.025, -10, 4, 0.25, 10, 0.075, 10};
  ASSERT_EQ(seen.size(), expected.size());
  for (std::size_t k = 0; k < seen.size(); ++k) EXPECT_NEAR(seen[k], expected[k], rounding);
}

}  // namespace
}  // namespace plumbline
