#include "kernel/normals/mass_matrix.hpp"

#include <Eigen/SVD>
#include <cmath>
#include <limits>

#include "kernel/normals/directions.hpp"
#include "kernel/shapes/linear.hpp"
#include "kernel/shapes/quadratic.hpp"

namespace plumbline {
namespace {

template <class Shape>
using Colours = Eigen::Matrix<double, Shape::support * Shape::support, 1>;

// Shapes and their gradients in a unit cell. Quadratic ones stand on its centre and those of its neighbours.
// [York A.3.2]
template <class Shape>
void shapes_at(double r, double s, Colours<Shape>& n, Colours<Shape>& n_r, Colours<Shape>& n_s) {
  constexpr int support = Shape::support;
  constexpr double centre = support == 3 ? 0.5 : 0;
  double w[2][support], g[2][support];
  Shape::weights(r - centre, w[0]);
  Shape::weights(s - centre, w[1]);
  Shape::gradients(r - centre, g[0]);
  Shape::gradients(s - centre, g[1]);
  for (int k = 0; k < support * support; ++k) {
    n[k] = w[0][k % support] * w[1][k / support];
    n_r[k] = g[0][k % support] * w[1][k / support];
    n_s[k] = w[0][k % support] * g[1][k / support];
  }
}

// The least-squares problem of (7.10) row by row, by rotations: with R^T R = T it has the answer of (7.12) and sees
// twice the digits that T keeps.
template <class Shape>
class ColourSystem {
 public:
  void add(Colours<Shape> row, double colour) {
    for (Eigen::Index k = 0; k < row.size(); ++k) {
      if (row[k] == 0) continue;
      const double length = std::hypot(r_(k, k), row[k]), c = r_(k, k) / length, s = row[k] / length;
      for (Eigen::Index m = k; m < row.size(); ++m) {
        const double above = r_(k, m);
        r_(k, m) = c * above + s * row[m];
        row[m] = c * row[m] - s * above;
      }
      const double above = rhs_[k];
      rhs_[k] = c * above + s * colour;
      colour = c * colour - s * above;
    }
  }
  // Of minimum norm. Singular values of T below rounding of its largest, those of R below the root of that, count as
  // zero.
  Colours<Shape> solve() {
    svd_.setThreshold(std::sqrt(std::numeric_limits<double>::epsilon()));
    svd_.compute(r_, Eigen::ComputeFullU | Eigen::ComputeFullV);
    return svd_.solve(rhs_);
  }

 private:
  static constexpr int count = Shape::support * Shape::support;
  Eigen::Matrix<double, count, count> r_ = Eigen::Matrix<double, count, count>::Zero();
  Colours<Shape> rhs_ = Colours<Shape>::Zero();
  Eigen::JacobiSVD<Eigen::Matrix<double, count, count>> svd_;
};

struct Place {
  double r, s;
};

// Where the point of another colour stands. York: at random. One near the membrane would ask for two colours in one
// place, so it is the corner of the cell furthest from all its points, which the points alone determine.
template <class Members>
Place other_colour(const Members& members) {
  Place best{};
  double furthest = -1;
  for (int corner = 0; corner < 4; ++corner) {
    const double r = corner % 2, s = corner / 2;
    double nearest = 2;
    for (const auto& m : members) nearest = std::min(nearest, std::hypot(m.r - r, m.s - s));
    if (nearest > furthest) {
      furthest = nearest;
      best = {r, s};
    }
  }
  return best;
}

// chi_p0 = sum_i chi_i N_i(X_p) [York 7.8, 7.13, 7.18], as T chi = sum_p chi_p N [York 7.10-7.12]
template <class Shape, class Members>
Colours<Shape> solve_colours(const Members& members) {
  ColourSystem<Shape> system;
  Colours<Shape> n, n_r, n_s;
  for (const auto& m : members) {
    shapes_at<Shape>(m.r, m.s, n, n_r, n_s);
    system.add(n, 0);
  }
  const Place other = other_colour(members);
  shapes_at<Shape>(other.r, other.s, n, n_r, n_s);
  system.add(n, 1);
  return system.solve();
}

// n_p = sum_i chi_i grad N_i(X_p) [York 7.9, 7.14, 7.19]
template <class Shape>
Place gradient_at(const Colours<Shape>& chi, double r, double s) {
  Colours<Shape> n, n_r, n_s;
  shapes_at<Shape>(r, s, n, n_r, n_s);
  return {chi.dot(n_r), chi.dot(n_s)};
}

}  // namespace

void MassMatrix::gather(const Square& square, int cell_x, int cell_y, int across) {
  members_.clear();
  for (int j = cell_y; j < cell_y + across; ++j) {
    const auto [first, last] = points_.row(cell_x, cell_x + across - 1, j);
    for (int k = first; k < last; ++k) {
      const auto at = static_cast<std::size_t>(k);
      members_.push_back({(points_.x()[at] - square.x) / square.edge, (points_.y()[at] - square.y) / square.edge,
                          points_.number()[at]});
    }
  }
}

void MassMatrix::find_alone(const NormalsInput& input, const Member& alone, const Square& cell, int cell_x, int cell_y,
                            std::span<double> normal_x, std::span<double> normal_y) {
  const auto number = static_cast<std::size_t>(alone.number);
  const bool had_one = !input.previous_x.empty() && std::hypot(input.previous_x[number], input.previous_y[number]) > 0;
  if (keeps_ && had_one) {
    set_normal(input, number, 0, 0, normal_x, normal_y);
    return;
  }
  const int left = alone.r < 0.5 ? cell_x - 1 : cell_x, below = alone.s < 0.5 ? cell_y - 1 : cell_y;
  const Square ghost{cell.x + (left - cell_x) * cell.edge, cell.y + (below - cell_y) * cell.edge, 2 * cell.edge};
  gather(ghost, left, below, 2);
  Place n{0, 0};
  if (members_.size() > 1) {
    const double r = (alone.r + cell_x - left) / 2, s = (alone.s + cell_y - below) / 2;
    n = gradient_at<Linear>(solve_colours<Linear>(members_), r, s);
  }
  set_normal(input, number, n.r, n.s, normal_x, normal_y);
}

void MassMatrix::find(const NormalsInput& input, std::span<double> normal_x, std::span<double> normal_y) {
  points_.sort(input.grid, input.x, input.y);
  const GridSpec& grid = input.grid;
  for (int j = 0; j < grid.cells[1]; ++j) {
    for (int i = 0; i < grid.cells[0]; ++i) {
      const Square cell{grid.origin[0] + i * grid.h, grid.origin[1] + j * grid.h, grid.h};
      gather(cell, i, j, 1);
      if (members_.empty()) continue;
      if (members_.size() == 1) {
        const Member alone = members_.front();
        find_alone(input, alone, cell, i, j, normal_x, normal_y);
        continue;
      }
      const auto take = [&](const auto& chi, auto gradient) {
        for (const Member& m : members_) {
          if (m.number < 0) continue;
          const Place n = gradient(chi, m.r, m.s);
          set_normal(input, static_cast<std::size_t>(m.number), n.r, n.s, normal_x, normal_y);
        }
      };
      if (quadratic_) {
        take(solve_colours<Quadratic>(members_), gradient_at<Quadratic>);
      } else {
        take(solve_colours<Linear>(members_), gradient_at<Linear>);
      }
    }
  }
}

}  // namespace plumbline
