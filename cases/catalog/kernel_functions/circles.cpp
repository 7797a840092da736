// Normals by fits: circles in the plane, planes and quadratics in space, against least squares by orthogonal factorisations.
#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "cases/catalog/kernel_functions/answers.hpp"
#include "kernel/normals/circle_fit.hpp"
#include "kernel/normals/connectivity.hpp"
#include "kernel/normals/directions.hpp"
#include "kernel/normals/surface_fit.hpp"

namespace plumbline::kernel_functions::circles_trial {
namespace {

using Flat = Eigen::Vector2d;
using Spots = std::vector<Flat>;

double turned_from(const Flat& a, const Flat& b) { return a[0] * b[1] - a[1] * b[0]; }

// min sum_k w_k (A z + D + n . r)^2, |n| = 1, without D where centred is false: what the columns (z, 1) leave of (u, v) has n as
// its last singular vector. [Circle 1]
struct FlatFit {
  Flat normal;
  double bend;

  FlatFit(const Spots& r, const std::vector<double>& weights, bool centred) {
    const auto rows = static_cast<Eigen::Index>(r.size());
    Eigen::MatrixXd given(rows, centred ? 2 : 1), along(rows, 2);
    for (Eigen::Index k = 0; k < rows; ++k) {
      const Flat& at = r[static_cast<std::size_t>(k)];
      const double root = std::sqrt(weights[static_cast<std::size_t>(k)]);
      given(k, 0) = root * at.squaredNorm();
      if (centred) given(k, 1) = root;
      along.row(k) = root * at.transpose();
    }
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> elimination(given);
    const Eigen::MatrixXd taken = elimination.solve(along);
    const Eigen::MatrixXd rest = along - given * taken;
    normal = Eigen::JacobiSVD<Eigen::MatrixXd>(rest, Eigen::ComputeFullV).matrixV().col(1);
    bend = -taken.row(0).dot(normal);
  }
};

// The normal at a point, of all points and their images. [Circle 1, 3]
Flat circle_normal(const Spots& all, const Flat& here, double h) {
  Spots off;
  for (const Flat& one : all) off.push_back(one - here);
  std::sort(off.begin(), off.end(), [](const Flat& a, const Flat& b) { return a.norm() < b.norm(); });
  double reach = h;
  Spots within, near;
  for (;; reach *= 2) {
    within.clear();
    near.clear();
    for (const Flat& r : off) {
      if (r.norm() >= reach) continue;
      within.push_back(r);
      if (r.norm() > 1e-6 * h && near.size() < 5) near.push_back(r);
    }
    if (near.size() >= std::min<std::size_t>(2, off.size() - 1)) break;
  }
  if (near.size() == 1) return Flat(-near[0][1], near[0][0]).normalized();  // the chord
  const bool full = near.size() == 5;
  const double d = near.back().norm(), edge = full ? d * d : 2 * d * d;
  std::vector<double> weights;
  for (const Flat& r : near) weights.push_back(std::pow(1 - r.squaredNorm() / edge, 2));
  const FlatFit first(near, weights, false);
  const double s = d / 10, b = full ? std::min(5 * d / 2, reach) : reach;
  weights.clear();
  for (const Flat& r : within) {
    const double z = r.squaredNorm(), e = first.bend * z + first.normal.dot(r);
    const double fade = std::max(0.0, 1 - z / (b * b)), doubt = 1 + e * e / (s * s * (1 + z / (d * d)));
    weights.push_back(std::pow(fade / doubt, 2));
  }
  return FlatFit(within, weights, true).normal;
}

struct FoundNormals {
  std::vector<double> x, y;
};

FoundNormals found_normals(const GridSpec& grid, const Spots& points, bool previous = false) {
  std::vector<double> x, y;
  for (const Flat& p : points) {
    x.push_back(p[0]);
    y.push_back(p[1]);
  }
  const std::vector<double> last_x(x.size(), 0.28), last_y(x.size(), 0.96);
  FoundNormals normals{std::vector<double>(x.size()), std::vector<double>(x.size())};
  CircleFit fit;
  NormalsInput input{grid, x, y, {}, {}, {}, {}};
  if (previous) {
    input.previous_x = last_x;
    input.previous_y = last_y;
  }
  fit.find(input, normals.x, normals.y);
  return normals;
}

template <class Exact>
void add_normals(const std::string& name, const GridSpec& grid, const Spots& points, const Exact& exact,
                 KnownAnswers& all) {
  const FoundNormals found = found_normals(grid, points);
  for (std::size_t p = 0; p < points.size(); ++p) {
    const Flat normal(found.x[p], found.y[p]);
    const std::string at = name + "." + std::to_string(p);
    all.push_back({at + ".direction", turned_from(exact(points[p]), normal), 0});
    all.push_back({at + ".length", normal.norm(), 1});
  }
}

constexpr double grid_h = 0.5, left = -0.3, low = 0.2;

GridSpec flat_grid(int across, int up) {
  GridSpec grid;
  grid.dim = 2;
  grid.cells = {across, up, 1};
  grid.h = grid_h;
  grid.origin = {left, low, 0};
  return grid;
}

// Unevenly around a centre, and so much off the circle.
Spots around(const Flat& centre, double radius, int count, double off) {
  Spots points;
  for (int k = 0; k < count; ++k) {
    const double angle = 2 * M_PI * (k + 0.3 * std::sin(7.0 * k)) / count;
    const double r = radius + off * std::cos(5.0 * k + 1);
    points.push_back(centre + r * Flat(std::cos(angle), std::sin(angle)));
  }
  return points;
}

void add_circles(KnownAnswers& all) {
  const GridSpec grid = flat_grid(6, 5);
  const Flat centre(1.1, 1.3), axis(0.8, -0.6);
  const auto radial = [](const Flat& middle) { return [middle](const Flat& p) { return (p - middle).normalized(); }; };
  // Exactly found whatever the weights are: many and few points on a circle, on a line, and on a quarter between two mirrors.
  for (const int count : {60, 20}) {
    add_normals("circle" + std::to_string(count), grid, around(centre, 0.6, count, 0), radial(centre), all);
  }
  Spots line;
  for (int k = 0; k < 24; ++k) line.push_back(centre + (0.05 * (k - 12) + 0.02 * std::sin(7.0 * k)) * axis);
  add_normals(
      "line", grid, line, [&](const Flat&) { return Flat(-axis[1], axis[0]); }, all);
  GridSpec mirrored = grid;
  mirrored.walls[0][0] = mirrored.walls[1][1] = Wall::symmetry;
  const Flat corner(left, low + 5 * grid_h);
  Spots quarter;
  for (int k = 0; k <= 12; ++k) quarter.push_back(corner + Flat(std::sin(k * M_PI / 24), -std::cos(k * M_PI / 24)));
  quarter.front()[0] = corner[0];
  quarter.back()[1] = corner[1];
  add_normals("quarter", mirrored, quarter, radial(corner), all);
  // Off the circle, with another one near it.
  for (const int count : {60, 20}) {
    Spots points = around(centre, 0.6, count, count == 60 ? 0.015 : 0.05);
    for (const Flat& p : around(centre, 0.85, count + 5, 0.01)) points.push_back(p);
    add_normals(
        "off" + std::to_string(count), grid, points, [&](const Flat& p) { return circle_normal(points, p, grid_h); },
        all);
  }
  Spots images;
  for (const Flat& p : quarter) {
    for (const double x : {p[0], 2 * corner[0] - p[0]}) {
      for (const double y : {p[1], 2 * corner[1] - p[1]}) images.emplace_back(x, y);
    }
  }
  add_normals(
      "mirrored", mirrored, quarter, [&](const Flat& p) { return circle_normal(images, p, grid_h); }, all);
  // So few that the search goes out: to two, four and eight cells.
  const Spots few{{0, 1}, {1.1, 1.5}, {2.3, 0.9}, {0.5, 2.4}}, three{{0.1, 0.4}, {0.7, 0.75}, {1.4, 0.5}};
  for (const Spots& points : {few, three}) {
    add_normals(
        "few" + std::to_string(points.size()), grid, points,
        [&](const Flat& p) { return circle_normal(points, p, grid_h); }, all);
  }
  // Two: the chord, from one end of the grid to the other. One: what it was.
  const Spots pair{{left + 0.05, low + 0.05}, {left + 2.9, low + 0.85}};
  add_normals(
      "pair", flat_grid(6, 2), pair, [&](const Flat& p) { return circle_normal(pair, p, grid_h); }, all);
  const Spots alone{{0.4, 0.9}};
  const FoundNormals kept = found_normals(grid, alone, true), none = found_normals(grid, alone);
  all.push_back({"alone.x", kept.x[0], 0.28});
  all.push_back({"alone.y", kept.y[0], 0.96});
  all.push_back({"none.x", none.x[0], 0});
  all.push_back({"none.y", none.y[0], 0});
}

// Of a length above which it is one, and below.
void add_directions(KnownAnswers& all) {
  const GridSpec grid = flat_grid(3, 3);
  const double x[] = {0.1, 0.2, 0.3}, y[] = {0.4, 0.5, 0.6}, last_x[] = {0, 0.6, 0}, last_y[] = {1, -0.8, 1};
  const NormalsInput input{grid, x, y, {}, {}, last_x, last_y}, fresh{grid, x, y, {}, {}, {}, {}};
  double nx[3] = {5, 5, 5}, ny[3] = {5, 5, 5};
  set_normal(input, 0, 3e-4, -4e-4, nx, ny);
  set_normal(input, 1, 0.594e-12, 0.792e-12, nx, ny);
  set_normal(input, 2, 0.606e-12, 0.808e-12, nx, ny);
  const double exact_x[] = {0.6, 0.6, 0.6}, exact_y[] = {-0.8, -0.8, 0.8};
  for (std::size_t p = 0; p < 3; ++p) {
    all.push_back({"direction.x" + std::to_string(p), nx[p], exact_x[p]});
    all.push_back({"direction.y" + std::to_string(p), ny[p], exact_y[p]});
  }
  set_normal(fresh, 2, 0, 0, nx, ny);
  all.push_back({"direction.none", std::hypot(nx[2], ny[2]), 0});
}

// Segments at known angles, of unequal lengths: the mean of two angles is the tangent's.
void add_chains(KnownAnswers& all) {
  constexpr int points = 5;
  const double angle[] = {0.3, 1.1, -0.4, 2.3}, length[] = {0.7, 1.9, 0.4, 1.2};
  double x[points] = {0.2}, y[points] = {-0.5};
  for (int k = 0; k + 1 < points; ++k) {
    x[k + 1] = x[k] + length[k] * std::cos(angle[k]);
    y[k + 1] = y[k] + length[k] * std::sin(angle[k]);
  }
  const double back = std::atan2(y[0] - y[4], x[0] - x[4]);
  for (const bool closed : {false, true}) {
    double tx[points] = {}, ty[points] = {};
    chain_tangents(x, y, points, 0, 3, closed, tx, ty);
    chain_tangents(x, y, points, 3, points, closed, tx, ty);
    for (int p = 0; p < points; ++p) {
      const double before = p > 0 ? angle[p - 1] : closed ? back : angle[0];
      const double after = p < 4 ? angle[p] : closed ? back : angle[3];
      // Of the two means, half a turn apart, the one between the angles.
      const double half = std::remainder(after - before, 2 * M_PI) / 2;
      const std::string at = (closed ? "closed." : "open.") + std::to_string(p);
      all.push_back({at + ".x", tx[p], std::cos(before + half)});
      all.push_back({at + ".y", ty[p], std::sin(before + half)});
    }
  }
}

}  // namespace

KnownAnswers circle_answers() {
  KnownAnswers all;
  add_circles(all);
  add_directions(all);
  add_chains(all);
  return all;
}

// Heights over a bent surface: planes by singular values of what the mean leaves, quadratics by an orthogonal factorisation.
KnownAnswers surface_fit_answers() {
  KnownAnswers all;
  std::vector<Eigen::Vector3d> points;
  const Eigen::Matrix3d axes = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, -2, 3).normalized()).toRotationMatrix();
  for (int k = 0; k < 48; ++k) {
    const double u = 0.1 * (k % 8) + 0.02 * std::sin(3.0 * k), v = 0.12 * (k / 8) + 0.02 * std::cos(5.0 * k);
    points.emplace_back(axes * Eigen::Vector3d(u, v, 0.6 * u * u - 0.4 * u * v + 0.3 * v * v * v));
  }
  constexpr double reach = 0.35;
  const auto planes = fitted_normals(points, reach, SurfaceFit::plane),
             quadrics = fitted_normals(points, reach, SurfaceFit::quadric);
  for (std::size_t p = 0; p < points.size(); ++p) {
    std::vector<Eigen::Vector3d> near;
    std::vector<double> weights;
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    double whole = 0;
    for (const Eigen::Vector3d& q : points) {
      const Eigen::Vector3d off = (q - points[p]) / reach;
      if (off.norm() >= 1) continue;
      near.push_back(off);
      weights.push_back(std::pow(1 - off.squaredNorm(), 2));
      mean += weights.back() * off;
      whole += weights.back();
    }
    mean /= whole;
    const auto rows = static_cast<Eigen::Index>(near.size());
    Eigen::MatrixXd spread(rows, 3), terms(rows, 6);
    Eigen::VectorXd height(rows);
    for (Eigen::Index k = 0; k < rows; ++k) {
      const auto at = static_cast<std::size_t>(k);
      spread.row(k) = std::sqrt(weights[at]) * (near[at] - mean).transpose();
    }
    const Eigen::Matrix3d own = Eigen::JacobiSVD<Eigen::MatrixXd>(spread, Eigen::ComputeFullV).matrixV();
    for (Eigen::Index k = 0; k < rows; ++k) {
      const auto at = static_cast<std::size_t>(k);
      const double u = own.col(0).dot(near[at]), v = own.col(1).dot(near[at]), root = std::sqrt(weights[at]);
      terms.row(k) << root, root * u, root * v, root * u * u, root * u * v, root * v * v;
      height[k] = root * own.col(2).dot(near[at]);
    }
    const Eigen::VectorXd fit = terms.colPivHouseholderQr().solve(height);
    const Eigen::Vector3d tilted = (own.col(2) - fit[1] * own.col(0) - fit[2] * own.col(1)).normalized();
    const std::string at = "surface." + std::to_string(p);
    all.push_back({at + ".plane", planes[p].cross(own.col(2)).norm(), 0});
    all.push_back({at + ".plane_length", planes[p].norm(), 1});
    all.push_back({at + ".quadric", quadrics[p].cross(tilted).norm(), 0});
    all.push_back({at + ".quadric_length", quadrics[p].norm(), 1});
  }
  return all;
}

}  // namespace plumbline::kernel_functions::circles_trial
