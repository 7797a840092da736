#include "kernel/normals/connectivity.hpp"

#include <cmath>

namespace plumbline {
namespace {

struct Direction {
  double x, y;
};

Direction segment(const double* x, const double* y, int from, int to) {
  const double dx = x[to] - x[from], dy = y[to] - y[from], length = std::sqrt(dx * dx + dy * dy);
  return {dx / length, dy / length};
}

}  // namespace

// The normalised sum of two unit vectors has the mean of their angles. [York 7.1]
void chain_tangents(const double* x, const double* y, int points, int first, int last, bool closed, double* tangent_x,
                    double* tangent_y) {
  const int n = points;
  if (n < 2) return;
  for (int p = first; p < last; ++p) {
    const bool at_start = p == 0 && !closed, at_end = p == n - 1 && !closed;
    const int before = (p + n - 1) % n, after = (p + 1) % n;
    const Direction a = at_start ? segment(x, y, p, after) : segment(x, y, before, p);
    const Direction b = at_end ? a : segment(x, y, p, after);
    const double sx = a.x + b.x, sy = a.y + b.y, length = std::sqrt(sx * sx + sy * sy);
    tangent_x[p] = sx / length;
    tangent_y[p] = sy / length;
  }
}

}  // namespace plumbline
