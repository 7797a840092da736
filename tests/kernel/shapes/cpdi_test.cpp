// Domains with corners: what their weights reproduce, how they deform, and what they have in common with boxes.
#include "kernel/shapes/cpdi.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "kernel/engine/loops/corner_weights.hpp"
#include "kernel/shapes/gimp.hpp"
#include "tests/kernel/solids.hpp"

namespace plumbline::cpdi_test {
namespace {

// Sums of some tens of terms of order one, over edges of a tenth of a cell at least.
constexpr double rounding = 1e-13;

template <int dim>
GridSpec grid_of() {
  GridSpec grid = scenes::box(scenes::space_of(dim), {7, 6, 4}, 0.3);
  grid.origin = {0.7, -0.4, 0.2};
  return grid;
}

// One point at a place in cells with edges in cells.
template <int dim>
class Listed {
 public:
  using Vec = Eigen::Matrix<double, dim, 1>;
  using Matrix = Eigen::Matrix<double, dim, dim>;

  Listed(const Vec& cells, const Matrix& edges) : grid(grid_of<dim>()), points_(1) {
    points_.add(column::position, dim);
    points_.add(column::half_edges, dim * dim);
    Places<dim> at;
    for (int d = 0; d < dim; ++d) {
      points_(column::position, d)[0] = grid.origin(d) + grid.h() * cells[d];
      at.x[d] = points_(column::position, d);
      x[d] = *at.x[d];
    }
    for (int k = 0; k < dim * dim; ++k) points_(column::half_edges, k)[0] = grid.h() * edges(k % dim, k / dim);
    Cpdi<dim>(grid).list(points_, at, {0, 1}, nodes_);
  }
  auto nodes() const { return nodes_.of(0); }
  double weight(int node) const {
    double sum = 0;
    for (const auto& [i, value, gradient] : nodes()) sum += i == node ? value : 0;
    return sum;
  }
  Vec gradient(int node) const {
    Vec sum = Vec::Zero();
    for (const auto& [i, value, slope] : nodes()) {
      if (i == node) sum += slope;
    }
    return sum;
  }

  Grid<dim> grid;
  Vec x;

 private:
  Columns points_;
  NodeList<dim> nodes_;
};

template <int dim>
void expect_linear_fields(const Eigen::Matrix<double, dim, 1>& cells, const Eigen::Matrix<double, dim, dim>& edges) {
  using Matrix = Eigen::Matrix<double, dim, dim>;
  const Listed<dim> at(cells, edges);
  double unity = 0;
  Eigen::Matrix<double, dim, 1> place = -at.x, sum = place * 0;
  Matrix slopes = -Matrix::Identity();
  for (const auto& [node, value, gradient] : at.nodes()) {
    unity += value;
    place += value * at.grid.position(node);
    sum += gradient;
    slopes += at.grid.position(node) * gradient.transpose();
  }
  EXPECT_NEAR(unity, 1, rounding);
  EXPECT_LE(place.norm(), rounding);
  EXPECT_LE(sum.norm(), 100 * rounding);  // 1/m, over edges of 0.03
  EXPECT_LE(slopes.norm(), 100 * rounding);
}

// Uniform and linear fields by value and by gradient, of domains sheared and turned anyhow, at sides and in the middle, among
// them such that are cut. [CPDI 2] [CPDI 3]
template <int dim>
void expect_linear_fields_anywhere() {
  scenes::Random random(5);
  for (int k = 0; k < 200; ++k) {
    SCOPED_TRACE(k);
    Eigen::Matrix<double, dim, 1> cells;
    Eigen::Matrix<double, dim, dim> edges = 0.2 * Eigen::Matrix<double, dim, dim>::Identity();
    const double most = k % 5 == 0 ? 2.5 : 0.3;
    for (int d = 0; d < dim; ++d) {
      cells[d] = k % 3 == 0 ? std::round(random(0, 4)) : random(0, 4);
      for (int e = 0; e < dim; ++e) edges(d, e) += random(-most, most);
    }
    if (std::abs(edges.determinant()) < 0.1 * std::pow(0.2, dim)) continue;
    expect_linear_fields<dim>(cells, edges);
  }
}
TEST(Cpdi, KeepsLinearFieldsOnLines) { expect_linear_fields_anywhere<1>(); }
TEST(Cpdi, KeepsLinearFieldsInThePlane) { expect_linear_fields_anywhere<2>(); }
TEST(Cpdi, KeepsLinearFieldsInSpace) { expect_linear_fields_anywhere<3>(); }

// Where a square along the axes lies within a cell tents are bilinear over it: the means at corners and over the square are
// the same. Along an axis the mean gradient is that of the box wherever it lies. [GIMP 1]
TEST(Cpdi, OfSquaresWithinCellsIsContiguousGimp) {
  for (double x : {2.25, 2.4, 2.7}) {
    for (double y : {3.3, 3.5}) {
      const double half = 0.2;
      const Listed<2> at({x, y}, half * Eigen::Matrix2d::Identity());
      double local[2], n[2][3], g[2][3];
      int anchor[2];
      for (int d = 0; d < 2; ++d) {
        anchor[d] = Gimp::anchor(d == 0 ? x : y, 6, local[d]);
        Gimp::weights(local[d], half, n[d]);
        Gimp::gradients(local[d], half, g[d]);
      }
      for (int b = 0; b < 3; ++b) {
        for (int a = 0; a < 3; ++a) {
          const int node = (anchor[0] + a) * at.grid.stride(0) + (anchor[1] + b) * at.grid.stride(1);
          EXPECT_NEAR(at.weight(node), n[0][a] * n[1][b], rounding);
          EXPECT_NEAR(at.gradient(node)[0], g[0][a] * n[1][b] / at.grid.h(), 10 * rounding);
          EXPECT_NEAR(at.gradient(node)[1], n[0][a] * g[1][b] / at.grid.h(), 10 * rounding);
        }
      }
    }
  }
  for (double x : {2.0, 2.1, 2.5, 2.9}) {
    double local, g[3];
    const int anchor = Gimp::anchor(x, 7, local);
    Gimp::gradients(local, 0.3, g);
    const Listed<1> at(Eigen::Matrix<double, 1, 1>(x), Eigen::Matrix<double, 1, 1>(0.3));
    for (int a = 0; a < 3; ++a) EXPECT_NEAR(at.gradient(anchor + a)[0], g[a] / at.grid.h(), 10 * rounding);
  }
}

// A quarter turn of grid, point and domain is a quarter turn of the gradients.
TEST(Cpdi, TurnsWithItsDomain) {
  Eigen::Matrix2d edges, quarter;
  edges << 0.3, -0.1, 0.15, 0.2;
  quarter << 0, -1, 1, 0;
  const Eigen::Vector2d middle(3, 3), off(0.35, -0.2);
  const Listed<2> at(middle + off, edges), turned(middle + quarter * off, quarter * edges);
  for (int j = -2; j <= 2; ++j) {
    for (int i = -2; i <= 2; ++i) {
      const auto node = [&](int a, int b) { return (4 + a) * at.grid.stride(0) + (4 + b) * at.grid.stride(1); };
      EXPECT_NEAR(turned.weight(node(-j, i)), at.weight(node(i, j)), rounding);
      EXPECT_LE((turned.gradient(node(-j, i)) - quarter * at.gradient(node(i, j))).norm(), 10 * rounding);
    }
  }
}

// D = sum_k r_k r_k^T + h^2 mean of f (1 - f) along each axis, f where corners stand in their cells. [CPDI 4]
TEST(Cpdi, InertiaIsThatOfCornersAndTents) {
  scenes::Random random(6);
  for (int k = 0; k < 50; ++k) {
    const Eigen::Vector2d cells(random(0, 7), random(0, 6));
    Eigen::Matrix2d edges;
    edges << random(0.1, 0.4), random(-0.3, 0.3), random(-0.1, 0.1), random(0.1, 0.4);
    const Listed<2> at(cells, edges);
    Eigen::Matrix2d exact = Eigen::Matrix2d::Zero();
    for (const auto& [node, value, gradient] : at.nodes()) {
      const Eigen::Vector2d arm = at.grid.position(node) - at.x;
      exact += value * arm * arm.transpose();
    }
    const Parallelograms pack{{cells[0] + Grid<2>::ghosts, cells[1] + Grid<2>::ghosts},
                              {edges(0, 0), edges(0, 1), edges(1, 0), edges(1, 1)}};
    const PackMatrix d = pack.inertia(at.grid.h());
    EXPECT_NEAR(d.xx[0], exact(0, 0), rounding);
    EXPECT_NEAR(d.xy[0], exact(0, 1), rounding);
    EXPECT_NEAR(d.yx[0], exact(1, 0), rounding);
    EXPECT_NEAR(d.yy[0], exact(1, 1), rounding);
  }
}

// r_k = F r_k(0): from the edges of the start, or of boxes where there are none. [CPDI 1]
TEST(Cpdi, DomainsFollowTheDeformation) {
  Columns points(1);
  points.add(column::half_size, 2);
  points.add(column::deformation, 4);
  const double half[] = {0.2, 0.3}, f[] = {1.1, 0.4, -0.2, 0.9}, start[] = {0.2, 0.1, -0.3, 0.4};
  for (int d = 0; d < 2; ++d) points(column::half_size, d)[0] = half[d];
  for (int k = 0; k < 4; ++k) points(column::deformation, k)[0] = f[k];
  deform_domains<2>(points);
  const double of_box[] = {1.1 * 0.2, -0.2 * 0.2, 0.4 * 0.3, 0.9 * 0.3};
  for (int k = 0; k < 4; ++k) EXPECT_DOUBLE_EQ(points(column::half_edges, k)[0], of_box[k]);
  points.add(column::half_edges_at_start, 4);
  for (int k = 0; k < 4; ++k) points(column::half_edges_at_start, k)[0] = start[k];
  deform_domains<2>(points);
  const double of_edges[] = {1.1 * 0.2 + 0.4 * 0.1, -0.2 * 0.2 + 0.9 * 0.1, -1.1 * 0.3 + 0.4 * 0.4,
                             0.2 * 0.3 + 0.9 * 0.4};
  for (int k = 0; k < 4; ++k) EXPECT_NEAR(points(column::half_edges, k)[0], of_edges[k], 1e-16);
}

// Domains that lie askew across a wall, beside their mirror images: a body at a symmetry wall moves as one half of the body
// and its image do without a wall, to rounding.
TEST(Cpdi, AWallIsAMirror) {
  const auto scene_of = [](bool whole) {
    GridSpec grid = scenes::plane(whole ? 12 : 6, 8, 0.25,
                                  scenes::walls(whole ? Wall::free : Wall::symmetry, Wall::free));
    if (whole) grid.origin[0] = -1.5;
    std::vector<scenes::Place> places;
    for (const double side : {1.0, -1.0}) {
      if (side < 0 && !whole) continue;
      for (int k = 0; k < 5; ++k) places.push_back({side * (0.05 + 0.11 * (k % 2)), 0.7 + 0.11 * k});
    }
    Scene scene = scenes::scene_of(
        grid, {scenes::solid_body(scenes::Law::neo_hookean, scenes::Space::plane, places, 0.012)}, "cpdi", "apic");
    Columns& points = scene.bodies[0].points;
    points.add(column::half_edges_at_start, 4);
    for (int p = 0; p < points.points(); ++p) {
      const double side = p < 5 ? 1 : -1, shear = 0.1 * (p % 5), v = 0.2 + 0.05 * (p % 5);
      const double edges[] = {0.08, side * 0.03, -side * 0.02, 0.06}, f[] = {1.1, side * shear, side * 0.1, 0.95};
      for (int k = 0; k < 4; ++k) {
        points(column::half_edges_at_start, k)[p] = edges[k];
        points(column::deformation, k)[p] = f[k];
      }
      points(column::velocity, 0)[p] = side * v;
      points(column::velocity, 1)[p] = 0.1 * (p % 5);
    }
    return scene;
  };
  Simulation half(scene_of(false), "midpoint", {0.3, 0.01}), whole(scene_of(true), "midpoint", {0.3, 0.01});
  for (int k = 0; k < 20; ++k) {
    half.step(1);
    whole.step(1);
  }
  const Body &one = half.scene().bodies[0], &both = whole.scene().bodies[0];
  for (const ColumnId* id : {&column::position, &column::velocity, &column::deformation}) {
    for (int k = 0; k < one.points.components(*id); ++k) {
      const auto own = scenes::by_id(one, *id, k), other = scenes::by_id(both, *id, k);
      for (std::size_t p = 0; p < 5; ++p) EXPECT_NEAR(own[p], other[p], 1e-12) << id->name() << ' ' << k << ' ' << p;
    }
  }
  EXPECT_LE(half.ledger().energy.relative_drift(false), 1e-14);
}

}  // namespace
}  // namespace plumbline::cpdi_test
