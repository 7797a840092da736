// Forces of the pressures that points of a gas bear, with the sum over points of what varies little replaced by its integral.
//   p_i = sum_p V_p p_p N_ip / |cell_i|, sharpened to p^_i as densities are [Read-off 1], and kept where it is even,
//   chi_i = max(0, 1 - ((p_most - p_least) / (eps p_most))^2)^2 of the nodes at most three away along each axis,
//   P_i = chi_i p^_i.                                                                                      [Quadrature 1]
// The force of P_i is its integral, no longer its sum over points:
//   f_i = sum_p V_p (p_p - sum_j N_jp P_j) grad N_ip + sum_j P_j int N_j grad N_i.                         [Quadrature 2]
// What presses must strain, so that energy closes:
//   D_p = div v_p + sum_i N_ip (chi_i p^_i / p_i) (int N_i div v / |cell_i| - sum_q V_q N_iq div v_q / |cell_i|).
//                                                                                                          [Quadrature 3]
// Where pressures and energies are even the points' places then do not matter: V_p p_p is (gamma - 1) m_p e_p, and so is
// V_p sum_j N_jp p^_j. The sums of grad grad N_ip over points, by which waves of shear grow in a gas at rest, are gone.
// Integrals along an axis are those of two B-splines k cells apart:
//   int N_0 N_k = h m_k, int N_0 dN_k/dx = -+ s_|k|.                                                        [Quadrature 4]
// Beyond a wall stand mirror images, of velocities about the wall's. Near free edges, and to other bodies, nodes with less
// pressure or none are within reach, and chi is 0.
#pragma once

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "kernel/velocity_field.hpp"

namespace plumbline {

// chi of pressures between a least and a most, which is not negative, at an evenness > 0: 1 of equal ones, 0 of none or of those
// that differ by more than that share.                                                                    [Quadrature 1]
inline double even_share(double least, double most, double evenness) {
  const double apart = most > 0 ? (most - least) / (evenness * most) : 1;
  return apart < 1 ? (1 - apart * apart) * (1 - apart * apart) : 0;
}

template <int dim>
class PressureQuadrature {
 public:
  using Vec = Eigen::Matrix<double, dim, 1>;
  using Field = VelocityField<dim>;
  using Values = std::vector<double>;

  // degree: of the shape's B-splines, 1 to 3; another: there is none. evenness: eps, [0, 1]; 0: none. On a line, where no
  // flow shears, and beside walls that gas sticks to, none either.
  PressureQuadrature(const Grid<dim>& grid, int degree, double evenness) : grid_(grid), evenness_(evenness) {
    if (dim == 1 || degree < 1 || degree > 3) evenness_ = 0;
    for (int d = 0; d < dim; ++d) {
      for (int side = 0; side < 2; ++side) {
        if (grid.wall(d, side) == Wall::no_slip) evenness_ = 0;
      }
    }
    if (none()) return;
    static constexpr std::array<std::array<double, reach + 1>, 3> both{
        {{4.0 / 6, 1.0 / 6},
         {66.0 / 120, 26.0 / 120, 1.0 / 120},
         {2416.0 / 5040, 1191.0 / 5040, 120.0 / 5040, 1.0 / 5040}}};
    static constexpr std::array<std::array<double, reach>, 3> rises{
        {{1.0 / 2}, {10.0 / 24, 1.0 / 24}, {245.0 / 720, 56.0 / 720, 1.0 / 720}}};
    mass_ = both[static_cast<std::size_t>(degree - 1)];
    slope_ = rises[static_cast<std::size_t>(degree - 1)];
  }

  bool none() const { return evenness_ == 0; }

  // From p_i in `mapped`, zero where no gas is, and p^_i in `pressure`: P_i there, and field.gas.share, P_i / p_i. Of all
  // nodes but ghosts, which are zero.
  void find_shares(Field& field, const Values& mapped, Values& pressure, int threads) const {
    Values &share = field.held(field.gas.share), &low = cleared(field, 0), &high = cleared(field, 1);
    Values &next_low = cleared(field, 2), &next_high = cleared(field, 3);
    low = high = mapped;
    for (int d = 0; d < dim; ++d) {
      along(field, d, threads, [&](int first, int last, const Beside& at) {
        const double *const least = low.data(), *const most = high.data();
        for (int i = first; i < last; ++i) {
          double below = least[i], above = most[i];
          for (std::size_t k = 0; k < reach; ++k) {
            below = std::min(below, std::min(least[i + at.below[k]], least[i + at.above[k]]));
            above = std::max(above, std::max(most[i + at.below[k]], most[i + at.above[k]]));
          }
          next_low[static_cast<std::size_t>(i)] = below;
          next_high[static_cast<std::size_t>(i)] = above;
        }
      });
      std::swap(low, next_low);
      std::swap(high, next_high);
    }
    std::fill(share.begin(), share.end(), 0.0);
    for_rows(field, threads, [&](int row, int first, int last) {
      const bool inside = within_reach(row);
      for (int k = first; k < last; ++k) {
        const auto i = static_cast<std::size_t>(row * grid_.row_length() + k);
        const bool even = inside && low[i] > 0 && k >= first_inside(0) && k <= last_inside(0);
        const double chi = even ? even_share(low[i], high[i], evenness_) : 0;
        share[i] = chi > 0 ? chi * pressure[i] / mapped[i] : 0;
        pressure[i] *= chi;
      }
    });
  }

  // Adds sum_j P_j int N_j grad N_i to field.force, on walls what these will take too: before forces are folded there.
  void add_forces(Field& field, const Values& pressure, const Values& inverse_volumes, int threads) const {
    for (int d = 0; d < dim; ++d) {
      const Values* from = &pressure;
      for (int e = 0; e < dim; ++e) {
        if (e != d) from = &smoothed(field, *from, e, threads);
      }
      const double* const p = from->data();
      along(field, d, threads, [&](int first, int last, const Beside& at) {
        for (int i = first; i < last; ++i) {
          double rise = 0;
          for (std::size_t k = 0; k < reach; ++k) rise += slope_[k] * (p[i + at.above[k]] - p[i + at.below[k]]);
          if (at.on_wall != 0) rise = on_wall(p + i, at);
          const auto own = static_cast<std::size_t>(i);
          if (inverse_volumes[own] > 0) field.force[own][d] -= rise / (grid_.h() * inverse_volumes[own]);
        }
      });
    }
  }

  // field.gas.mean: from sum_p V_p N_ip div v_p, folded at walls, to what D_p has beside div v_p, ghosts of walls excepted.
  void find_correction(Field& field, const std::vector<Vec>& velocity, const Values& inverse_volumes,
                       int threads) const {
    Values &mean = field.gas.mean, &sum = field.held(field.gas.along[2]);
    const Values& share = field.gas.share;
    for (int d = 0; d < dim; ++d) {
      const Values* from = &slope(field, velocity, d, threads);
      for (int e = 0; e < dim; ++e) {
        if (e != d) from = &smoothed(field, *from, e, threads);
      }
      for_nodes(field, threads, [&](std::size_t i) { sum[i] = (d == 0 ? 0.0 : sum[i]) + (*from)[i]; });
    }
    for_nodes(field, threads, [&](std::size_t i) { mean[i] = share[i] * (sum[i] - mean[i] * inverse_volumes[i]); });
  }

 private:
  static constexpr std::size_t reach = 3;  // nodes on either side whose kernels overlap

  // Where the arrays hold what is 1, 2, 3 nodes away along an axis, from a node on: images by what they mirror.
  struct Beside {
    std::array<int, reach> below{}, above{};
    std::array<double, reach> below_sign{1, 1, 1}, above_sign{1, 1, 1};  // -1: an image
    int wall_below = 0, wall_above = 0;                                  // of the walls that mirror
    int on_wall = 0;  // 1 on the lower one, -1 on the upper one, 0 on none
  };

  bool walled(int d, int side) const { return grid_.wall(d, side) != Wall::free; }
  // The first and the last node along d that is no ghost of a wall.
  int low(int d) const { return walled(d, 0) ? Grid<dim>::ghosts : 0; }
  int high(int d) const { return grid_.nodes(d) - 1 - (walled(d, 1) ? Grid<dim>::ghosts : 0); }
  // And of those from which all nodes within reach are images or exist.
  int first_inside(int d) const { return walled(d, 0) ? low(d) : static_cast<int>(reach); }
  int last_inside(int d) const { return walled(d, 1) ? high(d) : high(d) - static_cast<int>(reach); }
  bool within_reach(int row) const {
    for (int d = 1; d < dim; ++d) {
      const int k = grid_.row_index(row, d);
      if (k < first_inside(d) || k > last_inside(d)) return false;
    }
    return true;
  }

  // How far away along d what stands k nodes from `index` is held; beyond a free side the last node stands in.
  int step_to(int index, int k, int d, double& sign) const {
    int there = index + k;
    for (sign = 1; (walled(d, 0) && there < low(d)) || (walled(d, 1) && there > high(d)); sign = -1) {
      there = 2 * (walled(d, 0) && there < low(d) ? low(d) : high(d)) - there;
    }
    return std::clamp(there, low(d), high(d)) - index;
  }
  Beside beside(int index, int d) const {
    Beside at;
    const int stride = grid_.stride(d);
    for (std::size_t k = 0; k < reach; ++k) {
      at.below[k] = stride * step_to(index, -static_cast<int>(k) - 1, d, at.below_sign[k]);
      at.above[k] = stride * step_to(index, static_cast<int>(k) + 1, d, at.above_sign[k]);
    }
    at.wall_below = stride * (low(d) - index);
    at.wall_above = stride * (high(d) - index);
    if (walled(d, 0) && index == low(d)) at.on_wall = 1;
    if (walled(d, 1) && index == high(d)) at.on_wall = -1;
    return at;
  }

  // visit(row, first, last) of the touched nodes of each row that are no ghosts.
  template <class Visit>
  void for_rows(const Field& field, int threads, Visit&& visit) const {
    for_each_piece(grid_.rows(), threads, [&](int row) {
      for (int d = 1; d < dim; ++d) {
        const int k = grid_.row_index(row, d);
        if (k < low(d) || k > high(d)) return;
      }
      const auto [from, to] = field.touched[static_cast<std::size_t>(row)];
      const int first = std::max(from, low(0)), last = std::min(to, high(0) + 1);
      if (first < last) visit(row, first, last);
    });
  }
  template <class Visit>
  void for_nodes(const Field& field, int threads, Visit&& visit) const {
    for_rows(field, threads, [&](int row, int first, int last) {
      for (int k = first; k < last; ++k) visit(static_cast<std::size_t>(row * grid_.row_length() + k));
    });
  }
  // visit(first, last, what is beside them along d) of stretches of these nodes that are alike in that.
  template <class Visit>
  void along(const Field& field, int d, int threads, Visit&& visit) const {
    for_rows(field, threads, [&](int row, int first, int last) {
      const int start = row * grid_.row_length();
      if (d > 0) return visit(start + first, start + last, beside(grid_.row_index(row, d), d));
      const int margin = static_cast<int>(reach);
      const int plain = std::clamp(low(0) + margin, first, last), end = std::clamp(high(0) + 1 - margin, plain, last);
      for (int k = first; k < plain; ++k) visit(start + k, start + k + 1, beside(k, 0));
      if (plain < end) visit(start + plain, start + end, beside(plain, 0));
      for (int k = end; k < last; ++k) visit(start + k, start + k + 1, beside(k, 0));
    });
  }

  // One of the arrays for what goes from one axis to the next.
  Values& cleared(Field& field, std::size_t which) const {
    Values& values = field.held(field.gas.along[which]);
    std::fill(values.begin(), values.end(), 0.0);
    return values;
  }

  // sum_k m_k of values that are even at walls, along d: in that array which does not hold them.
  const Values& smoothed(Field& field, const Values& values, int d, int threads) const {
    Values& out = cleared(field, &values == &field.gas.along[0] ? 1 : 0);
    const double* const in = values.data();
    along(field, d, threads, [&](int first, int last, const Beside& at) {
      for (int i = first; i < last; ++i) {
        double sum = mass_[0] * in[i];
        for (std::size_t k = 0; k < reach; ++k) sum += mass_[k + 1] * (in[i + at.below[k]] + in[i + at.above[k]]);
        out[static_cast<std::size_t>(i)] = sum;
      }
    });
    return out;
  }

  // sum_k s_k (v_k - v_-k) / h of the velocity's component along d.
  const Values& slope(Field& field, const std::vector<Vec>& velocity, int d, int threads) const {
    Values& out = field.held(field.gas.along[0]);
    const double* const v = velocity.front().data() + d;
    along(field, d, threads, [&](int first, int last, const Beside& at) {
      const auto image = [&](int i, int there, double sign, int wall) {
        return sign > 0 ? v[dim * (i + there)] : 2 * v[dim * (i + wall)] - v[dim * (i + there)];
      };
      for (int i = first; i < last; ++i) {
        double sum = 0;
        for (std::size_t k = 0; k < reach; ++k) {
          sum += slope_[k] * (image(i, at.above[k], at.above_sign[k], at.wall_above) -
                              image(i, at.below[k], at.below_sign[k], at.wall_below));
        }
        out[static_cast<std::size_t>(i)] = sum / grid_.h();
      }
    });
    return out;
  }

  // What a wall's node bears, per half a cell, of p on the nodes from it on: what its velocity does to all slopes.
  double on_wall(const double* p, const Beside& at) const {
    const std::array<int, reach>& inwards = at.on_wall > 0 ? at.above : at.below;
    double sum = 0, beyond = 0;
    for (std::size_t k = reach; k-- > 0; beyond += slope_[k]) sum += p[inwards[k]] * (slope_[k] + 2 * beyond);
    return 2 * at.on_wall * (sum + p[0] * beyond);
  }

  Grid<dim> grid_;
  double evenness_;
  std::array<double, reach + 1> mass_{};  // m_0 to m_3 of [Quadrature 4]
  std::array<double, reach> slope_{};     // s_1 to s_3
};

}  // namespace plumbline
