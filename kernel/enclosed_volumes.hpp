// How much of the space inside a closed line of points belongs to each node.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "kernel/grid.hpp"
#include "kernel/points/columns.hpp"

namespace plumbline {

// Integrals of one shape function from the left end of its support, over whole pieces of it: of N and of N xi, xi in cells
// from the node.
template <class Shape>
struct ShapeIntegrals {
  static constexpr bool even = Shape::support % 2 == 0;
  double mass[Shape::support + 1] = {}, moment[Shape::support + 1] = {};

  // Adds int N_j and int N_j xi_j from the start of a piece to the local coordinate `to` in it, exactly for cubics.
  static void add_part(double to, double (&m)[Shape::support], double (&first)[Shape::support]) {
    const double from = even ? 0.0 : -0.5, half = 0.5 * (to - from), middle = 0.5 * (to + from);
    const double abscissa = std::sqrt(0.6), weight[3] = {5.0 / 9, 8.0 / 9, 5.0 / 9};
    for (int k = 0; k < 3; ++k) {
      const double x = middle + (k - 1) * abscissa * half;
      double n[Shape::support];
      Shape::weights(x, n);
      for (int j = 0; j < Shape::support; ++j) {
        m[j] += half * weight[k] * n[j];
        first[j] += half * weight[k] * n[j] * (x - (Shape::first + j));
      }
    }
  }

  ShapeIntegrals() {
    double m[Shape::support] = {}, first[Shape::support] = {};
    add_part(even ? 1.0 : 0.5, m, first);
    // In a piece the j-th node of the stencil has the piece support - 1 - j of its own support.
    for (int piece = 0; piece < Shape::support; ++piece) {
      mass[piece + 1] = mass[piece] + m[Shape::support - 1 - piece];
      moment[piece + 1] = moment[piece] + first[Shape::support - 1 - piece];
    }
  }
};

// |cell_i| = int_inside N_i dA, axisymmetric int_inside N_i r dA, of all nodes, ghosts included, m^2 (m^3 per radian).
// Inside: the polygon of the points in their order, and on through the corners back to the first point; positive if it runs
// counter-clockwise. By Green's theorem |cell_i| = sum over edges of int Phi_i(x) N_i(y) dy, Phi_i(x) = int^x N_i (r) dx:
// with one or two Gauss points on pieces of at most a quarter of a cell, and tents in place of boxes, which is good to a few
// thousandths of a cell; the sum over all nodes is the polygon's area (volume per radian) to rounding. [Coupling 4]
template <class Shape>
void enclosed_volumes(const Grid<2>& grid, const Columns& chain, const std::vector<std::array<double, 2>>& corners,
                      std::vector<double>& volume) {
  static const ShapeIntegrals<Shape> whole;
  const bool rings = grid.axisymmetric();
  const double h = grid.h();
  const int across = grid.nodes(0), stride = grid.stride(1);
  volume.assign(static_cast<std::size_t>(grid.node_count()), 0.0);
  std::vector<double> left(static_cast<std::size_t>(grid.node_count()));  // what goes to a node and all left of it
  const auto at_point = [&](double px, double py, double dy) {
    const double x = grid.logical(px, 0), y = grid.logical(py, 1);
    double fx, fy, ny[Shape::support];
    const int i = Shape::anchor(std::clamp(x, 0.0, 1.0 * grid.cells(0)), grid.cells(0), fx);
    const int j = Shape::anchor(std::clamp(y, 0.0, 1.0 * grid.cells(1)), grid.cells(1), fy);
    Shape::weights(fy, ny);
    double m[Shape::support] = {}, moment[Shape::support] = {};
    ShapeIntegrals<Shape>::add_part(fx, m, moment);
    for (int a = 0; a < Shape::support; ++a) {
      m[a] += whole.mass[Shape::support - 1 - a];
      moment[a] += whole.moment[Shape::support - 1 - a];
    }
    const int lowest = i + Shape::first + Grid<2>::ghosts;
    for (int b = 0; b < Shape::support; ++b) {
      const int row = (j + Shape::first + b + Grid<2>::ghosts) * stride;
      const double share = h * ny[b] * dy;
      for (int a = 0; a < Shape::support; ++a) {
        const double r = grid.line(lowest + a, 0);
        volume[static_cast<std::size_t>(row + lowest + a)] += share * (rings ? r * m[a] + h * moment[a] : m[a]);
      }
      if (lowest > 0) left[static_cast<std::size_t>(row + lowest - 1)] += share;
    }
  };
  const auto edge = [&](double x0, double y0, double x1, double y1) {
    if (y0 == y1) return;
    const int pieces = std::max(1, static_cast<int>(std::ceil(4 * std::hypot(x1 - x0, y1 - y0) / h)));
    for (int k = 0; k < pieces; ++k) {
      const double dy = (y1 - y0) / pieces, spread = rings ? 0.5 / std::sqrt(3.0) : 0.0;
      for (int side = -1; side <= (rings ? 1 : -1); side += 2) {
        const double t = (k + 0.5 + side * spread) / pieces;
        at_point(x0 + t * (x1 - x0), y0 + t * (y1 - y0), rings ? 0.5 * dy : dy);
      }
    }
  };
  const double *x = chain(column::position), *y = chain(column::position, 1);
  const int n = chain.points();
  for (int p = 0; p + 1 < n; ++p) edge(x[p], y[p], x[p + 1], y[p + 1]);
  std::array<double, 2> last{x[n - 1], y[n - 1]};
  for (const auto& corner : corners) {
    edge(last[0], last[1], corner[0], corner[1]);
    last = corner;
  }
  edge(last[0], last[1], x[0], y[0]);
  for (int row = 0; row < grid.nodes(1); ++row) {
    double sum = 0;
    for (int k = across - 1; k >= 0; --k) {
      const auto i = static_cast<std::size_t>(row * stride + k);
      sum += left[i];
      volume[i] += sum * (rings ? grid.line(k, 0) : 1.0);
    }
  }
}

}  // namespace plumbline
