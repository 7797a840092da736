// Domains of points that deform with them: parallelograms (on a line edges, in space parallelepipeds) of half edges
// r_k = F r_k(0) [CPDI 1], whose corners carry tents:
//   x_c = x_p + sum_k s_ck r_k, s_ck = -1, 1;  N_ip = 2^-dim sum_c N_i(x_c)                                [CPDI 2]
//   grad N_ip = 2^-dim sum_c N_i(x_c) sum_k s_ck r^k, r^k . r_l = delta_kl: its mean over the domain       [CPDI 3]
// (Sadeghirad, Brannon, Burghardt 2011, doi 10.1002/nme.3110)
#pragma once

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "kernel/grid.hpp"
#include "kernel/lanes.hpp"
#include "kernel/points/components.hpp"
#include "kernel/shapes/domain_columns.hpp"
#include "kernel/shapes/listed_shape.hpp"

namespace plumbline {

// The edges of a body's domains: as they are, or where nobody has set them yet those of the start, which without further
// word are the edges of the points' boxes.
template <int dim>
class DomainEdges {
 public:
  using Matrix = Eigen::Matrix<double, dim, dim>;

  explicit DomainEdges(const Columns& points, bool at_start = false) {
    const bool now = !at_start && points.has(column::half_edges), start = points.has(column::half_edges_at_start);
    for (int k = 0; (now || start) && k < dim * dim; ++k)
      edges_[k] = points(now ? column::half_edges : column::half_edges_at_start, k);
    for (int d = 0; !now && !start && d < dim; ++d) half_size_[d] = points(column::half_size, d);
  }

  // Of a row of the matrix with a column for each edge, m; null: zero of every point.
  const double* component(int row, int edge) const {
    return edges_[0] ? edges_[row + dim * edge] : row == edge ? half_size_[row] : nullptr;
  }
  // That matrix, m.
  Matrix operator[](int p) const {
    Matrix edges;
    for (int k = 0; k < dim * dim; ++k) {
      const double* values = component(k % dim, k / dim);
      edges(k % dim, k / dim) = values ? values[p] : 0.0;
    }
    return edges;
  }

 private:
  const double *edges_[dim * dim] = {}, *half_size_[dim] = {};
};

template <int dim>
class Domains {
 public:
  using Vec = Eigen::Matrix<double, dim, 1>;
  using Matrix = Eigen::Matrix<double, dim, dim>;
  static constexpr int corners = 1 << dim;
  static constexpr int most_nodes = dim == 3 ? 5 : 6;  // along each direction that a domain may reach
  static constexpr double usual_half = 0.25;           // half an edge in cells: two points a cell
  // theta of S(k) = 1 - theta k^2 h^2 + ...: half the variance of tents, 1/6, and of the corners, l^2 [Sharpening 1]
  static constexpr double blur = (1.0 / 6 + usual_half * usual_half) / 2;

  explicit Domains(const Grid<dim>& grid) : grid_(grid), support_(most_nodes) {
    for (int d = 0; d < dim; ++d) support_ = std::min(support_, grid.nodes(d));
    furthest_ = (support_ - 2) / 2.0 - 1e-6;
  }

  // The same on this grid.
  int support() const { return support_; }

  // The place of a point in cells from the first node lines; one off the grid counts from its side.
  double place(double x, int d) const {
    const double cells = grid_.logical(x, d);
    return cells >= 0 ? std::min(cells, 1.0 * grid_.cells(d)) : 0.0;
  }
  // Domains whose corners lie within so many cells of their points are not squeezed, wherever they stand.
  double free_reach() const { return std::min(1.0, furthest_); }
  // Edges that reach further than the support, or beyond the ghost nodes at a side of the grid, are squeezed along that axis,
  // by this factor: of points at x cells from the first node lines whose corners lie within `extent` cells of them.
  template <class Number>
  Number squeeze(const Number& x, const Number& extent, int d) const {
    using std::min;
    const Number distance = min(min(Number(x + 1.0), Number(grid_.cells(d) + 1.0 - x)), Number(furthest_));
    return choose(extent > free_reach(), min(Number(distance / extent), Number(1.0)), Number(1.0));
  }
  // The edges of a domain as squeezed, all in cells.
  Matrix squeezed(const Vec& x, const Matrix& edges) const {
    Matrix within = edges;
    for (int d = 0; d < dim; ++d) within.row(d) *= squeeze(x[d], edges.row(d).cwiseAbs().sum(), d);
    return within;
  }
  // -1 or 1.
  static double sign(int corner, int edge) { return corner >> edge & 1 ? 1 : -1; }

 private:
  Grid<dim> grid_;
  int support_;
  double furthest_;  // that a corner may be from its point along an axis, cells
};

// Sets the edges from the points' deformations, where they carry one. [CPDI 1]
template <int dim>
void deform_domains(Columns& points) {
  using Matrix = Eigen::Matrix<double, dim, dim>;
  points.add(column::half_edges, dim * dim);
  const DomainEdges<dim> start(points, true);
  const bool deforms = points.has(column::deformation);
  const Components<Matrix, const double> deformation(points, column::deformation, deforms);
  Components<Matrix, double> edges(points, column::half_edges);
  for (int p = 0; p < points.points(); ++p) {
    const Matrix at_start = start[p], now = deforms ? Matrix(deformation[p] * at_start) : at_start;
    edges.set(p, now.transpose());
  }
}

// As lists of the nodes that each point reaches.
template <int dim>
class Cpdi final : public ListedShape<dim> {
 public:
  explicit Cpdi(const Grid<dim>& grid) : grid_(grid), domains_(grid) {}

  ShapeTraits traits() const override {
    return {.support = domains_.support(), .blur = Domains<dim>::blur, .fixed_inertia = false, .boxes = true};
  }

  bool keeps_affine_energy() const override { return true; }
  bool follows() const override { return true; }
  void follow(Columns& points) const override { deform_domains<dim>(points); }

  void list(const Columns& points, const Places<dim>& at, PointRange range, NodeList<dim>& nodes) const override {
    const DomainEdges<dim> edges_of(points);
    for (int p = range.first; p < range.last; ++p) {
      Vec x;
      for (int d = 0; d < dim; ++d) x[d] = domains_.place(at.x[d][p], d);
      const Matrix edges = domains_.squeezed(x, edges_of[p] / grid_.h());
      const Matrix duals = edges.inverse().transpose() / grid_.h();
      for (int c = 0; c < Domains<dim>::corners; ++c) {
        Vec signs;
        for (int k = 0; k < dim; ++k) signs[k] = Domains<dim>::sign(c, k);
        list_corner(x + edges * signs, duals * signs, nodes);  // [CPDI 2] [CPDI 3]
      }
      nodes.end_point();
    }
  }

 private:
  using Vec = Eigen::Matrix<double, dim, 1>;
  using Matrix = Eigen::Matrix<double, dim, dim>;
  static constexpr double share = 1.0 / Domains<dim>::corners;

  // slope: of a value at the corner, times the number of corners.
  void list_corner(const Vec& corner, const Vec& slope, NodeList<dim>& nodes) const {
    int lowest = 0;
    double w[dim][2];
    for (int d = 0; d < dim; ++d) {
      const double cell = std::clamp(std::floor(corner[d]), -1.0, 1.0 * grid_.cells(d));
      lowest += (static_cast<int>(cell) + Grid<dim>::ghosts) * grid_.stride(d);
      w[d][1] = corner[d] - cell;
      w[d][0] = 1 - w[d][1];
    }
    for (int k = 0; k < 1 << dim; ++k) {
      int node = lowest;
      double value = share;
      for (int d = 0; d < dim; ++d) {
        node += (k >> d & 1) * grid_.stride(d);
        value *= w[d][k >> d & 1];
      }
      nodes.add(node, value, value * slope);
    }
  }

  Grid<dim> grid_;
  Domains<dim> domains_;
};

extern template class Cpdi<1>;
extern template class Cpdi<2>;
extern template class Cpdi<3>;

}  // namespace plumbline
