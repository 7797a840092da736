// The smoothing of the maps undone on the nodes. A map by shape functions damps the wave number k of a force, and of the
// velocity whose gradient strains a point, by S(k) = 1 - theta k^2 h^2 + ... along each axis d, which
//   Q = 1 + sum_d (s_1 B_d + s_2 B_d^2 + s_3 B_d^3),  (B_d u)_i = theta / M_i sum_j K_ij (u_i - u_j),
//   K_ij = (t_i + t_j) M_i M_j / (M_i + M_j),  j the neighbours along d, t of [Limiter 2] or 1,
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
  SharpeningAction operator+(const SharpeningAction& o) const { return {walls + o.walls, turn + o.turn}; }
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
    apply_powers(
        field, from, to, threads, [](int, int, const Vec&) {}, [](int, int, int, int, const Vec&) {});
  }

  // The same; returns what Q adds to sum_i M_i a_i and sum_i x_i x M_i a_i.
  SharpeningAction<dim> apply_to_accelerations(VelocityField<dim>& field, const std::vector<Vec>& from,
                                               std::vector<Vec>& to, int threads) const {
    std::vector<SharpeningAction<dim>> rows(static_cast<std::size_t>(grid_.rows()));
    // Node i is pulled from node j, which node i pulls back: a couple with the arm x_i - x_j, half of it counted from each
    // side, all of it where the other node stands on a wall.
    const auto couple = [&](int row, int d, double arm, const Vec& pull) {
      const Vec direction = Vec::Unit(d);
      rows[static_cast<std::size_t>(row)].turn += cross<dim>(arm * direction, pull);
    };
    const auto plain = [&](int row, int d, const Vec& pulls) { couple(row, d, 0.5 * grid_.h(), pulls); };
    const auto other = [&](int row, int i, int j, int d, const Vec& change) {
      if (on_wall(i, d)) return;  // counted from inside
      const bool walled_in = on_wall(j, d);
      const Vec pull = field.mass[static_cast<std::size_t>(i)] * change;
      couple(row, d, (walled_in ? 1.0 : 0.5) * grid_.h() * (i > j ? 1 : -1), pull);
      if (!walled_in) return;
      // The node on the wall takes what is even of the other half; what is odd the wall takes.
      WallAction<dim>& walls = rows[static_cast<std::size_t>(row)].walls;
      const Vec held = held_by(pull, j, d);
      walls.linear += held;
      walls.angular += cross<dim>(grid_.position(j), held);
    };
    apply_powers(field, from, to, threads, plain, other);
    return pairwise_sum(rows.data(), rows.size());
  }

 private:
  bool walled(int d, int side) const { return grid_.wall(d, side) != Wall::free; }
  int first(int) const { return Grid<dim>::ghosts; }
  int last(int d) const { return grid_.nodes(d) - 1 - Grid<dim>::ghosts; }
  // Of an index along d.
  bool is_wall(int k, int d) const { return (k == first(d) && walled(d, 0)) || (k == last(d) && walled(d, 1)); }
  bool on_wall(int node, int d) const { return is_wall(grid_.index(node, d), d); }
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
  // to += amount B_d u, next = B_d u (null: not wanted) of plain nodes [first, last) of a row; kept: if limited.
  // Returns sum_i amount M_i (what the lower neighbour adds to (B_d u)_i less what the upper one does), on a line zero: there
  // nothing turns, and compilers pack the loop.
  template <bool limited>
  static Vec apply_plain(int first, int last, int d, int stride, double theta, double amount, const double* mass,
                         const Vec* kept, const Vec* u, Vec* __restrict to, Vec* __restrict next) {
    const auto pull = [=](int i, int j) __attribute__((always_inline)) {
      const double other = std::min(mass[i], mass[j]) > least_mass ? mass[j] : 0.0;
      double share = 2 * theta * ratio(other, mass[i] + mass[j]);
      if constexpr (limited) share *= 0.5 * (kept[i][d] + kept[j][d]);
      return Vec(share * (u[i] - u[j]));
    };
    Vec apart = Vec::Zero();
    for (int i = first; i < last; ++i) {
      const Vec below = pull(i, i - stride), above = pull(i, i + stride), sum = below + above;
      if constexpr (dim > 1) apart += mass[i] * (below - above);
      to[i] += amount * sum;
      if (next) next[i] = sum;
    }
    return amount * apart;
  }

  // Of what neighbours add to (Q u)_i: visit_plain(row, direction, what apply_plain returns) of the plain nodes of a row, for
  // others visit(row, i, j, direction, neighbour j's) of neighbours that are no mirror images.
  template <class VisitPlain, class Visit>
  void apply_powers(VelocityField<dim>& field, const std::vector<Vec>& from, std::vector<Vec>& to, int threads,
                    VisitPlain&& visit_plain, Visit&& visit) const {
    field.for_touched(
        grid_, [&](std::size_t i) { to[i] = from[i]; }, threads);
    for (int d = 0; d < dim; ++d) {
      const std::vector<Vec>* power = &from;
      for (int k = 0; k < powers_; ++k) {
        std::vector<Vec>* const next = k + 1 == powers_ ? nullptr
                                                        : &field.held(k % 2 == 0 ? field.corrected.odd_power
                                                                                 : field.corrected.even_power);
        const double amount = amounts_[static_cast<std::size_t>(k)];
        for_each_piece(grid_.rows(), threads, [&](int row) {
          if (ghost_row(row)) return;
          const RowNeighbours<dim> beside(grid_, field, row);
          for_own_nodes(field, row, [&](int i) {
            if (beside.plain(i)) return;
            const auto at = static_cast<std::size_t>(i);
            Vec sum = Vec::Zero();
            for_neighbours(field, beside, i, d, [&](int j, bool mirrored, double share) {
              Vec other = (*power)[static_cast<std::size_t>(j)];
              if (mirrored) other = image(other, beside.index(i, d), d);
              const Vec change = theta_ * share * ((*power)[at] - other);
              sum += change;
              if (!mirrored) visit(row, i, j, d, amount * change);
            });
            if (next) (*next)[at] = sum;
            to[at] += amount * sum;
          });
          const auto [first, last] = beside.plain_nodes();
          const auto& kept = field.corrected.kept;
          const auto apply = kept.empty() ? &apply_plain<false> : &apply_plain<true>;
          visit_plain(row, d,
                      apply(first, last, d, grid_.stride(d), theta_, amount, field.mass.data(), kept.data(),
                            power->data(), to.data(), next ? next->data() : nullptr));
        });
        power = next;
      }
    }
  }

  // The value beyond a wall of direction d that mirrors `value`, seen from a node on it, of the index k along d.
  Vec image(Vec value, int k, int d) const {
    const int side = k == first(d) && walled(d, 0) ? 0 : 1;
    if (grid_.wall(d, side) == Wall::no_slip) return -value;
    value[d] = -value[d];
    return value;
  }
  Vec held_by(const Vec& value, int node, int d) const { return 0.5 * (value - image(value, grid_.index(node, d), d)); }

  // visit(neighbour, whether it stands for a mirror image, K_ij / M_i) along d. A node on a wall of d has an image of its own.
  template <class Visit>
  void for_neighbours(const VelocityField<dim>& field, const RowNeighbours<dim>& beside, int i, int d,
                      Visit&& visit) const {
    const int index = beside.index(i, d);
    const auto mass_of = [&](int node, int k) {
      return (is_wall(k, d) ? 2 : 1) * field.mass[static_cast<std::size_t>(node)];
    };
    const double mass = mass_of(i, index);
    if (!(mass > least_mass)) return;
    for (int side = 0; side < 2; ++side) {
      const Neighbour there = beside(i, d, side);
      if (there.node < 0) continue;
      const double other = mass_of(there.node, index + (there.node > i ? 1 : -1));
      const auto& kept = field.corrected.kept;
      const auto at = [](int node) { return static_cast<std::size_t>(node); };
      const double stays = kept.empty() ? 2.0 : kept[at(i)][d] + kept[at(there.node)][d];
      visit(there.node, there.mirrored, stays * other / (mass + other));
    }
  }

  Grid<dim> grid_;
  double theta_;
  Amounts amounts_;
  int powers_ = 0;  // the highest whose amount is not zero
};

}  // namespace plumbline
