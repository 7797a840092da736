#include "cases/catalog/normals/space_mass_matrix.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "cases/harness/laboratory/matrices.hpp"

namespace plumbline {
namespace {

using Vec = Eigen::Vector3d;
using Cell = std::array<long, 3>;
using Colours = Eigen::Matrix<double, 8, 1>;

Vec corner(int k) { return {static_cast<double>(k % 2), static_cast<double>(k / 2 % 2), static_cast<double>(k / 4)}; }

// Trilinear shapes of the corners at a place in the unit cell, and their gradients.
Colours shapes(const Vec& at) {
  Colours n;
  for (int k = 0; k < 8; ++k) {
    const Vec c = corner(k);
    n[k] = 1;
    for (int d = 0; d < 3; ++d) n[k] *= c[d] > 0 ? at[d] : 1 - at[d];
  }
  return n;
}
Vec gradient(const Colours& chi, const Vec& at) {
  Vec sum = Vec::Zero();
  for (int k = 0; k < 8; ++k) {
    const Vec c = corner(k);
    for (int d = 0; d < 3; ++d) {
      double slope = c[d] > 0 ? 1 : -1;
      for (int e = 0; e < 3; ++e) {
        if (e != d) slope *= c[e] > 0 ? at[e] : 1 - at[e];
      }
      sum[d] += chi[k] * slope;
    }
  }
  return sum;
}

// [York 7.10-7.12], of minimum norm where points do not determine them.
Colours colours(const std::vector<Vec>& members) {
  Vec other = Vec::Zero();
  double furthest = -1;
  for (int k = 0; k < 8; ++k) {
    double nearest = 2;
    for (const Vec& at : members) nearest = std::min(nearest, (at - corner(k)).norm());
    if (nearest <= furthest) continue;
    furthest = nearest;
    other = corner(k);
  }
  Eigen::Matrix<double, Eigen::Dynamic, 8> rows(static_cast<Eigen::Index>(members.size()) + 1, 8);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(rows.rows());
  for (std::size_t k = 0; k < members.size(); ++k)
    rows.row(static_cast<Eigen::Index>(k)) = shapes(members[k]).transpose();
  rows.row(rows.rows() - 1) = shapes(other).transpose();
  right[rows.rows() - 1] = 1;
  return least_squares(rows, right, std::sqrt(std::numeric_limits<double>::epsilon()));
}

}  // namespace

std::vector<Vec> space_mass_matrix_normals(const std::vector<Vec>& points, double h) {
  std::map<Cell, std::vector<std::size_t>> cells;
  for (std::size_t p = 0; p < points.size(); ++p) {
    Cell cell;
    for (std::size_t d = 0; d < 3; ++d) cell[d] = std::lround(std::floor(points[p][static_cast<Eigen::Index>(d)] / h));
    cells[cell].push_back(p);
  }
  const auto within = [&](const Cell& lowest, int across) {
    std::vector<std::size_t> all;
    for (long k = 0; k < across * across * across; ++k) {
      const auto found = cells.find(
          {lowest[0] + k % across, lowest[1] + k / across % across, lowest[2] + k / across / across});
      if (found != cells.end()) all.insert(all.end(), found->second.begin(), found->second.end());
    }
    return all;
  };
  std::vector<Vec> normals(points.size(), Vec::Zero());
  for (const auto& [cell, own] : cells) {
    Cell lowest = cell;
    int across = 1;
    if (own.size() == 1) {
      across = 2;
      for (std::size_t d = 0; d < 3; ++d) {
        const double local = points[own.front()][static_cast<Eigen::Index>(d)] / h - static_cast<double>(cell[d]);
        if (local < 0.5) --lowest[d];
      }
    }
    const auto local = [&](std::size_t p) -> Vec {
      return (points[p] / h -
              Vec(static_cast<double>(lowest[0]), static_cast<double>(lowest[1]), static_cast<double>(lowest[2]))) /
             across;
    };
    std::vector<Vec> members;
    for (const std::size_t p : within(lowest, across)) members.push_back(local(p));
    if (members.size() < 2) continue;
    const Colours chi = colours(members);
    for (const std::size_t p : own) normals[p] = gradient(chi, local(p));
  }
  return normals;
}

}  // namespace plumbline
