// Which points of two clouds may be near each other.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <map>
#include <vector>

namespace plumbline {

// visit(p, q) for points p of the first cloud and q of the second, both with a place x, m: for all that are nearer than
// `distance`, m, and for others that are nearer than about three times that. In the order of the first cloud.
template <int dim, class Point, class Visit>
void for_near(std::vector<Point>& first, std::vector<Point>& second, double distance, Visit&& visit) {
  // Of a lattice as wide as the distance: whoever is near stands in the same cell or beside it.
  using Cell = std::array<int, 3>;
  const auto cell_of = [&](const Point& point) {
    Cell cell{};
    for (int d = 0; d < dim; ++d)
      cell[static_cast<std::size_t>(d)] = static_cast<int>(std::floor(point.x[d] / distance));
    return cell;
  };
  std::map<Cell, std::vector<std::size_t>> cells;
  for (std::size_t j = 0; j < second.size(); ++j) cells[cell_of(second[j])].push_back(j);
  for (Point& point : first) {
    const Cell home = cell_of(point);
    for (int k = 0; k < (dim == 1 ? 3 : dim == 2 ? 9 : 27); ++k) {
      Cell there = home;
      there[0] += k % 3 - 1;
      if (dim > 1) there[1] += k / 3 % 3 - 1;
      if (dim > 2) there[2] += k / 9 - 1;
      const auto found = cells.find(there);
      if (found == cells.end()) continue;
      for (const std::size_t j : found->second) visit(point, second[j]);
    }
  }
}

}  // namespace plumbline
