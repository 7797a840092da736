// The smoothing of the maps undone on the nodes. A map by shape functions damps the wave number k of a force, and of the
// velocity whose gradient strains a point, by S(k) = 1 - theta k^2 h^2 + ... along each axis d, which
//   Q = 1 + sum_d (s_1 B_d + s_2 B_d^2 + s_3 B_d^3),  (B_d u)_i = theta / M_i sum_j K_ij (u_i - u_j),
//   K_ij = 2 M_i M_j / (M_i + M_j),  j the neighbours along d,
// undoes to leading order with s_1 = 1. K is symmetric, so that every power of B_d is self-adjoint under M and keeps
// sum_i M_i u_i: forces through Q do exactly the work that strains through Q give back. Across a wall the mirror images are
// the neighbours. [Sharpening 1]
#pragma once

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "kernel/neighbours.hpp"
#include "kernel/rotations.hpp"
#include "kernel/summation.hpp"
#include "kernel/walls.hpp"

namespace plumbline {

// What sharpening accelerations adds to the momenta by walls, whose nodes cannot follow, and to the angular momentum.
template <int dim>
struct SharpeningAction {
  WallAction<dim> walls;
  Spin<dim> turn = Spin<dim>::Zero();
  SharpeningAction operator+(const SharpeningAction& o) const {
    SharpeningAction sum;
    sum.walls.linear = walls.linear + o.walls.linear;
    sum.walls.angular = walls.angular + o.walls.angular;
    sum.turn = turn + o.turn;
    return sum;
  }
};

template <int dim>
class Sharpening {
 public:
  using Vec = Eigen::Matrix<double, dim, 1>;
  using Amounts = std::array<double, 3>;  // s_1, s_2, s_3 >= 0
  // theta: 1/12 linear, 1/8 quadratic, 1/6 cubic shapes.
  Sharpening(const Grid<dim>& grid, double theta, const Amounts& amounts = {1, 0, 0})
      : grid_(grid),
        theta_(theta),
        amounts_(amounts) {
    while (powers_ < 3 && std::any_of(amounts.begin() + powers_, amounts.end(), [](double s) { return s != 0; }))
      ++powers_;
  }

  // Whether Q is the identity.
  bool none() const { return theta_ == 0 || powers_ == 0; }

  // to = Q from, on the touched nodes that are not ghosts of a wall.
  void apply(VelocityField<dim>& field, const std::vector<Vec>& from, std::vector<Vec>& to, int threads) const {
    apply_powers(field, from, to, threads, [](int, int, int, int, const Vec&, bool) {});
  }

  // The same; returns what Q adds to sum_i M_i a_i and sum_i x_i x M_i a_i.
  SharpeningAction<dim> apply_to_accelerations(VelocityField<dim>& field, const std::vector<Vec>& from,
                                               std::vector<Vec>& to, int threads) const {
    std::vector<SharpeningAction<dim>> rows(static_cast<std::size_t>(grid_.rows()));
    apply_powers(field, from, to, threads, [&](int row, int i, int j, int d, const Vec& change, bool off_walls) {
      if (!off_walls && on_wall(i, d)) return;  // counted from inside
      // Node i is pulled from node j, which node i pulls back: a couple with the arm x_i - x_j, half of it counted from
      // each side, all of it where the other node stands on a wall.
      SharpeningAction<dim>& all = rows[static_cast<std::size_t>(row)];
      const Vec pull = field.mass[static_cast<std::size_t>(i)] * change;
      const bool walled_in = !off_walls && on_wall(j, d);
      Vec arm = Vec::Zero();
      arm[d] = (walled_in ? 1.0 : 0.5) * grid_.h() * (i > j ? 1 : -1);
      all.turn += cross<dim>(arm, pull);
      if (!walled_in) return;
      // The node on the wall takes what is even of the other half; what is odd the wall takes.
      const Vec held = held_by(pull, j, d);
      all.walls.linear += held;
      all.walls.angular += cross<dim>(grid_.position(j), held);
    });
    return pairwise_sum(rows.data(), rows.size());
  }

 private:
  bool walled(int d, int side) const { return grid_.wall(d, side) != Wall::free; }
  int first(int) const { return Grid<dim>::ghosts; }
  int last(int d) const { return grid_.nodes(d) - 1 - Grid<dim>::ghosts; }
  bool on_wall(int node, int d) const {
    const int k = grid_.index(node, d);
    return (k == first(d) && walled(d, 0)) || (k == last(d) && walled(d, 1));
  }
  bool ghost_row(int row) const {
    if constexpr (dim > 1) {
      for (int d = 1; d < dim; ++d) {
        const int k = grid_.row_index(row, d);
        if ((k < first(d) && walled(d, 0)) || (k > last(d) && walled(d, 1))) return true;
      }
    }
    return false;
  }
  template <class Visit>
  void for_own_nodes(const VelocityField<dim>& field, int row, Visit&& visit) const {
    auto [from, to] = field.touched[static_cast<std::size_t>(row)];
    if (walled(0, 0)) from = std::max(from, first(0));
    if (walled(0, 1)) to = std::min(to, last(0) + 1);
    for (int i = from; i < to; ++i) visit(row * grid_.row_length() + i);
  }
  // visit(row, i, j, direction, what neighbour j adds to (Q u)_i, whether i is plain) for neighbours that are no mirror images.
  template <class Visit>
  void apply_powers(VelocityField<dim>& field, const std::vector<Vec>& from, std::vector<Vec>& to, int threads,
                    Visit&& visit) const {
    for (int d = 0; d < dim; ++d) {
      const std::vector<Vec>* power = &from;
      for (int k = 0; k < powers_; ++k) {
        std::vector<Vec>* const next = k + 1 == powers_ ? nullptr
                                                        : &field.held(k % 2 == 0 ? field.corrected.odd_power
                                                                                 : field.corrected.even_power);
        for_each_piece(grid_.rows(), threads, [&](int row) {
          if (ghost_row(row)) return;
          const RowNeighbours<dim> beside(grid_, field, row);
          for_own_nodes(field, row, [&](int i) {
            const auto at = static_cast<std::size_t>(i);
            const bool plain = beside.plain(i);
            const double amount = amounts_[static_cast<std::size_t>(k)];
            Vec sum = Vec::Zero();
            for_neighbours(
                field, beside, i, d, [&](int j, bool mirrored, double share) __attribute__((always_inline)) {
                  Vec other = (*power)[static_cast<std::size_t>(j)];
                  if (mirrored) other = image(other, i, d);
                  const Vec change = theta_ * share * ((*power)[at] - other);
                  sum += change;
                  if (!mirrored) visit(row, i, j, d, amount * change, plain);
                });
            if (next) (*next)[at] = sum;
            to[at] = (d == 0 && k == 0 ? from[at] : to[at]) + amount * sum;
          });
        });
        power = next;
      }
    }
  }

  // The value beyond a wall of direction d that mirrors `value`, seen from the node i on it.
  Vec image(Vec value, int i, int d) const {
    const int side = grid_.index(i, d) == first(d) && walled(d, 0) ? 0 : 1;
    if (grid_.wall(d, side) == Wall::no_slip) return -value;
    value[d] = -value[d];
    return value;
  }
  Vec held_by(const Vec& value, int node, int d) const { return 0.5 * (value - image(value, node, d)); }

  // visit(neighbour, whether it stands for a mirror image, K_ij / M_i) along d. A node on a wall of d has an image of its own.
  template <class Visit>
  void for_neighbours(const VelocityField<dim>& field, const RowNeighbours<dim>& beside, int i, int d,
                      Visit&& visit) const {
    const bool plain = beside.plain(i);
    const auto mass_of = [&](int node) {
      return (!plain && on_wall(node, d) ? 2 : 1) * field.mass[static_cast<std::size_t>(node)];
    };
    const double mass = mass_of(i);
    if (!(mass > least_mass)) return;
    for (int side = 0; side < 2; ++side) {
      const Neighbour there = beside(i, d, side);
      if (there.node < 0) continue;
      const double other = mass_of(there.node);
      visit(there.node, there.mirrored, 2 * other / (mass + other));
    }
  }

  Grid<dim> grid_;
  double theta_;
  Amounts amounts_;
  int powers_ = 0;  // the highest whose amount is not zero
};

}  // namespace plumbline
