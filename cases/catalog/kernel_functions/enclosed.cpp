// Volumes of nodes, of grids and inside polygons, against integrals of B-splines in closed form.
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "cases/catalog/kernel_functions/answers.hpp"
#include "cases/catalog/kernel_functions/splines.hpp"
#include "kernel/cell_volumes.hpp"
#include "kernel/enclosed_volumes.hpp"
#include "kernel/shapes/cubic.hpp"
#include "kernel/shapes/gimp.hpp"
#include "kernel/shapes/linear.hpp"
#include "kernel/shapes/quadratic.hpp"

namespace plumbline::kernel_functions::enclosed_trial {
namespace {

constexpr double cell_edge = 0.5;  // m

// Integrals of a shape from -inf to x, and of it times the distance from its node, in cells.
struct OfShape {
  int degree;
  bool boxes;  // of a tent averaged over a box of the usual width
  double over(double x, int times) const {
    if (!boxes) return spline_integral(degree, x, times);
    constexpr double half = 0.25;
    return (spline_integral(1, x + half, times + 1) - spline_integral(1, x - half, times + 1)) / (2 * half);
  }
  double mass(double x) const { return over(x, 1); }
  double moment(double x) const { return x * over(x, 1) - over(x, 2); }
};

template <class Shape>
OfShape of_shape() {
  if constexpr (Shape::boxes) {
    return {1, true};
  } else {
    return {Shape::degree, false};
  }
}

using Polygon = std::vector<std::array<double, 2>>;

Columns chain_of(const Polygon& corners, std::size_t count) {
  Columns points(static_cast<int>(count));
  points.add(column::position, 2);
  for (std::size_t p = 0; p < count; ++p) {
    for (int d = 0; d < 2; ++d) points(column::position, d)[p] = corners[p][static_cast<std::size_t>(d)];
  }
  return points;
}

// int Phi_i(x) N_j(y) dy over the edges, one Gauss point a piece in the plane, two of rings. [Coupling 4]
double inside(const Polygon& corners, const Grid<2>& grid, const OfShape& shape, int node) {
  const double h = grid.h();
  const auto place = grid.position(node);
  const bool rings = grid.axisymmetric();
  double volume = 0;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const auto [x0, y0] = corners[k];
    const auto [x1, y1] = corners[(k + 1) % corners.size()];
    const double length = std::sqrt((x1 - x0) * (x1 - x0) + (y1 - y0) * (y1 - y0));
    const double pieces = std::max(1.0, std::ceil(length / (h / 4)));
    for (double piece = 0; piece < pieces; ++piece) {
      for (const double place_in_piece :
           rings ? std::vector{0.5 - std::sqrt(1.0 / 12), 0.5 + std::sqrt(1.0 / 12)} : std::vector{0.5}) {
        const double t = (piece + place_in_piece) / pieces, x = x0 + t * (x1 - x0), y = y0 + t * (y1 - y0);
        const double u = (x - place[0]) / h, v = (y - place[1]) / h;
        const double phi = rings ? h * place[0] * shape.mass(u) + h * h * shape.moment(u) : h * shape.mass(u);
        volume += phi * spline(shape.degree, v) * (y1 - y0) / (rings ? 2 * pieces : pieces);
      }
    }
  }
  return volume;
}

template <class Shape>
void add_polygons(const std::string& name, KnownAnswers& all) {
  GridSpec spec;
  spec.dim = 2;
  spec.cells = {6, 5, 1};
  spec.h = cell_edge;
  spec.origin = {0.25, -0.75, 0};
  // Two polygons, the second clockwise and of one corner outside the chain; a rectangle whose edges are on quarters of cells.
  const Polygon bent{{0.375, -0.5}, {2.1, -0.62}, {3.05, 0.3}, {2.2, 1.45}, {1.3, 0.7}, {0.45, 1.6}};
  const Polygon clockwise{{1.1, 0.1}, {1.2, 1.2}, {2.8, 1.05}, {2.4, -0.3}};
  const Polygon even{{0.8, -0.625}, {2.975, -0.625}, {2.975, 1.25}, {0.8, 1.25}};
  for (const bool rings : {false, true}) {
    spec.axisymmetric = rings;
    const Grid<2> grid(spec);
    for (const Polygon* polygon : {&bent, &clockwise, &even}) {
      const std::size_t points = polygon == &clockwise ? 1 : polygon->size() - 2;
      const Polygon corners(polygon->begin() + static_cast<std::ptrdiff_t>(points), polygon->end());
      std::vector<double> found(3, 7.0);
      enclosed_volumes<Shape>(grid, chain_of(*polygon, points), corners, found);
      const std::string at = name + (rings ? ".rings" : ".plane") + std::to_string(polygon->size()) +
                             (polygon == &even ? ".even" : "");
      all.push_back({at + ".nodes", 1.0 * static_cast<double>(found.size()), 8.0 * 9});
      double sum = 0;
      for (int node = 0; node < grid.node_count(); ++node) {
        const double own = found[static_cast<std::size_t>(node)];
        sum += own;
        const std::string of = at + ".node" + std::to_string(node);
        all.push_back({of, own, inside(*polygon, grid, of_shape<Shape>(), node)});
      }
      // The polygon's area, or the integral of r over it.
      double whole = 0;
      for (std::size_t k = 0; k < polygon->size(); ++k) {
        const auto [x0, y0] = (*polygon)[k];
        const auto [x1, y1] = (*polygon)[(k + 1) % polygon->size()];
        whole += rings ? (x0 * x0 + x0 * x1 + x1 * x1) * (y1 - y0) / 6 : (x0 * y1 - x1 * y0) / 2;
      }
      all.push_back({at + ".sum", sum, whole});
      if (polygon != &even || Shape::degree != 1) continue;
      // One Gauss point is exact for tents on quarters of cells.
      for (int node = 0; node < grid.node_count(); ++node) {
        const auto place = grid.position(node);
        const auto between = [&](double low, double high, int d) {
          const double from = (low - place[d]) / cell_edge, to = (high - place[d]) / cell_edge;
          const double plain = cell_edge * (spline_integral(1, to) - spline_integral(1, from));
          if (d == 1 || !rings) return plain;
          return place[d] * plain + cell_edge * cell_edge * (spline_moment(1, to) - spline_moment(1, from));
        };
        all.push_back({at + ".exact" + std::to_string(node), found[static_cast<std::size_t>(node)],
                       between(0.8, 2.975, 0) * between(-0.625, 1.25, 1)});
      }
    }
  }
}

// What of the line between the ends, in cells, is a node's, and of rings with the radius as its weight, which has no sign.
double on_line(const OfShape& shape, double node, double from, double to, bool radial, double origin) {
  const auto between = [&](double a, double b) {
    const double plain = cell_edge * (shape.mass(b - node) - shape.mass(a - node));
    if (!radial) return plain;
    const double moment = shape.moment(b - node) - shape.moment(a - node);
    return (origin + node * cell_edge) * plain + cell_edge * cell_edge * moment;
  };
  const double axis = -origin / cell_edge;
  if (!radial || axis <= from) return between(from, to);
  return between(axis, to) - between(from, axis);
}

template <class Shape>
void add_lines(const std::string& name, KnownAnswers& all) {
  const OfShape shape = of_shape<Shape>();
  for (const bool rings : {false, true}) {
    for (const double origin : {0.0, 0.375, 2.25}) {
      for (const int walls : {0, 1, 2, 3}) {
        GridSpec spec;
        spec.dim = 2;
        spec.axisymmetric = rings;
        spec.cells = {4, 3, 1};
        spec.h = cell_edge;
        spec.origin = {origin, -0.3, 0};
        if (walls & 1) spec.walls[0][0] = spec.walls[1][1] = Wall::symmetry;
        if (walls & 2) spec.walls[0][1] = spec.walls[1][0] = Wall::no_slip;
        const Grid<2> grid(spec);
        const std::string at = name + (rings ? ".rings" : ".plane") + ".walls" + std::to_string(walls) + ".from" +
                               std::to_string(origin).substr(0, 4);
        std::vector<double> exact[2];
        for (int d = 0; d < 2; ++d) {
          const bool low = grid.wall(d, 0) != Wall::free, high = grid.wall(d, 1) != Wall::free;
          const int cells = grid.cells(d);
          const double from = low ? 0 : -3, to = cells + (high ? 0 : 3);
          const std::vector<double> found = line_volumes<Shape>(grid, d);
          for (int node = -1; node <= cells + 1; ++node) {
            const auto own = [&](int i) { return on_line(shape, i, from, to, rings && d == 0, grid.origin(d)); };
            // Nodes beyond a wall give what they have to their mirrors.
            const bool beyond = (low && node < 0) || (high && node > cells);
            double volume = beyond ? 0 : own(node);
            if (low && node == 1) volume += own(-1);
            if (high && node == cells - 1) volume += own(cells + 1);
            exact[d].push_back(volume);
            all.push_back({at + ".line" + std::to_string(d) + "." + std::to_string(node),
                           found[static_cast<std::size_t>(node + 1)], volume});
          }
        }
        const std::vector<double> inverse = inverse_cell_volumes<Shape>(grid);
        for (int node = 0; node < grid.node_count(); ++node) {
          const double volume = exact[0][static_cast<std::size_t>(grid.index(node, 0))] *
                                exact[1][static_cast<std::size_t>(grid.index(node, 1))];
          const double found = inverse[static_cast<std::size_t>(node)];
          const std::string of = at + ".cell" + std::to_string(node);
          if (volume > 0) {
            all.push_back({of, found * volume, 1});
          } else {
            all.push_back({of, found, 0});
          }
        }
      }
    }
  }
}

}  // namespace

KnownAnswers enclosed_answers() {
  KnownAnswers all;
  add_polygons<Linear>("linear", all);
  add_polygons<Quadratic>("quadratic", all);
  add_polygons<Cubic>("cubic", all);
  return all;
}

KnownAnswers cell_volume_answers() {
  KnownAnswers all;
  add_lines<Linear>("linear", all);
  add_lines<Quadratic>("quadratic", all);
  add_lines<Cubic>("cubic", all);
  add_lines<Gimp>("box", all);
  return all;
}

}  // namespace plumbline::kernel_functions::enclosed_trial
