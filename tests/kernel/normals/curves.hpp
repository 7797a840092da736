// Points on curves with their exact normals, and what tests of all methods share.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "kernel/normals/normals.hpp"

namespace plumbline::test {

struct Curve {
  std::vector<double> x, y, nx, ny;
  void add(double px, double py, double normal_x, double normal_y) {
    const double length = std::hypot(normal_x, normal_y);
    x.push_back(px);
    y.push_back(py);
    nx.push_back(normal_x / length);
    ny.push_back(normal_y / length);
  }
  std::size_t size() const { return x.size(); }
};

// An arc about (x, y) with points at equal angles, in degrees.
inline Curve arc(double x, double y, double radius, double from, double to, int points) {
  Curve c;
  for (int p = 0; p < points; ++p) {
    const double a = (from + (to - from) * (p + 0.5) / points) * std::numbers::pi / 180;
    c.add(x + radius * std::cos(a), y + radius * std::sin(a), std::cos(a), std::sin(a));
  }
  return c;
}

// Points at distances t along a line through (x, y).
inline Curve line(double x, double y, double degrees, const std::vector<double>& t) {
  Curve c;
  const double a = degrees * std::numbers::pi / 180;
  const double tx = degrees == 90 ? 0 : std::cos(a), ty = degrees == 0 ? 0 : std::sin(a);
  for (const double s : t) c.add(x + s * tx, y + s * ty, -ty, tx);
  return c;
}

inline GridSpec square(int cells, double h, bool mirrors = false) {
  GridSpec grid;
  grid.dim = 2;
  grid.cells = {cells, cells, 1};
  grid.h = h;
  if (mirrors) grid.walls[0][0] = grid.walls[1][0] = Wall::symmetry;
  return grid;
}

struct Normals {
  std::vector<double> x, y;
};

inline Normals find(const std::string& method, const GridSpec& grid, const Curve& c,
                    const std::vector<double>& gas_x = {}, const std::vector<double>& gas_y = {}) {
  Normals n{std::vector<double>(c.size()), std::vector<double>(c.size())};
  make_normals(method)->find({grid, c.x, c.y, gas_x, gas_y, {}, {}, false}, n.x, n.y);
  return n;
}

// Between two directions without sign, degrees; 90 where there is none.
inline double angle(double ax, double ay, double bx, double by) {
  const double cross = std::abs(ax * by - ay * bx), dot = std::abs(ax * bx + ay * by);
  return cross == 0 && dot == 0 ? 90 : std::atan2(cross, dot) * 180 / std::numbers::pi;
}

inline double largest_angle(const Normals& n, const Curve& c) {
  double largest = 0;
  for (std::size_t p = 0; p < c.size(); ++p) {
    const double a = angle(n.x[p], n.y[p], c.nx[p], c.ny[p]);
    if (!(a <= largest)) largest = a;
  }
  return largest;
}

inline double mean_angle(const Normals& n, const Curve& c) {
  double sum = 0;
  for (std::size_t p = 0; p < c.size(); ++p) sum += angle(n.x[p], n.y[p], c.nx[p], c.ny[p]);
  return sum / static_cast<double>(c.size());
}

// Gas of n x n points per cell inside the unit circle about the origin.
inline void fill_circle(double h, int n, std::vector<double>& x, std::vector<double>& y) {
  for (int j = 0; (j + 0.5) * h / n < 1; ++j) {
    for (int i = 0; (i + 0.5) * h / n < 1; ++i) {
      const double px = (i + 0.5) * h / n, py = (j + 0.5) * h / n;
      if (std::hypot(px, py) >= 1) continue;
      x.push_back(px);
      y.push_back(py);
    }
  }
}

// Both halves or all four quarters of what symmetry walls at x = 0 and y = 0 show, in a grid without walls.
inline Curve unfolded(const Curve& c) {
  Curve all = c;
  for (std::size_t p = 0; p < c.size(); ++p) all.add(-c.x[p], c.y[p], -c.nx[p], c.ny[p]);
  const std::size_t half = all.size();
  for (std::size_t p = 0; p < half; ++p) all.add(all.x[p], -all.y[p], all.nx[p], -all.ny[p]);
  return all;
}

inline GridSpec unfolded(const GridSpec& grid) {
  GridSpec all = grid;
  for (std::size_t d = 0; d < 2; ++d) {
    all.cells[d] *= 2;
    all.origin[d] = -grid.cells[d] * grid.h;
    all.walls[d] = {Wall::free, Wall::free};
  }
  return all;
}

}  // namespace plumbline::test
