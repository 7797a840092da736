#include "kernel/surface_mesh.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace plumbline {
namespace {

using Lists = std::vector<std::vector<int>>;

std::vector<int>& of(Lists& lists, int p) { return lists[static_cast<std::size_t>(p)]; }

void sort_once(std::vector<int>& numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

void refuse_what_is_no_triangle(const Triangle& corners, int points) {
  for (std::size_t k = 0; k < 3; ++k) {
    const int corner = corners[k];
    if (corner >= 0 && corner < points && corner != corners[(k + 1) % 3]) continue;
    throw std::invalid_argument("a triangle has the corners " + std::to_string(corners[0]) + ", " +
                                std::to_string(corners[1]) + ", " + std::to_string(corners[2]) +
                                ": they must be three of the points 0 to " + std::to_string(points - 1));
  }
}

}  // namespace

std::vector<std::vector<int>> neighbours_in_mesh(const std::vector<Triangle>& mesh, int points, int rings) {
  if (rings < 1)
    throw std::invalid_argument("neighbours in a mesh: rings must be at least 1, not " + std::to_string(rings));
  Lists joined(static_cast<std::size_t>(points));
  for (const Triangle& corners : mesh) {
    refuse_what_is_no_triangle(corners, points);
    for (std::size_t k = 0; k < 3; ++k) {
      of(joined, corners[k]).push_back(corners[(k + 1) % 3]);
      of(joined, corners[k]).push_back(corners[(k + 2) % 3]);
    }
  }
  for (std::vector<int>& others : joined) sort_once(others);
  Lists all = joined;
  for (int ring = 1; ring < rings; ++ring) {
    for (int p = 0; p < points; ++p) {
      std::vector<int> farther = of(all, p);
      for (const int other : of(all, p)) {
        const std::vector<int>& next = of(joined, other);
        farther.insert(farther.end(), next.begin(), next.end());
      }
      sort_once(farther);
      std::erase(farther, p);
      of(all, p) = std::move(farther);
    }
  }
  return all;
}

}  // namespace plumbline
