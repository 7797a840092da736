// Pressures that act at the nodes, and the motion that goes with them.
//   p_i = sum_p V_p p_p N_ip / |cell_i|                                                                        [Pressure 1]
// Along each axis d the velocities of the nodes are interpolated to the faces between them, which move apart by
//   u_f = sum_j b_fj u_j,  D_i = sum_d (u_(i + 1/2) - u_(i - 1/2))_d / h,  D_p = sum_i N_ip D_i,               [Pressure 2]
// and what presses on a face acts on the nodes that its velocity is from:
//   f_i = -|cell_i| / h sum_f b_fi (p_(f + 1/2) - p_(f - 1/2))  along each axis.                               [Pressure 3]
// Points of the gas move with the velocity of which D_p is the divergence,
//   w_d(x) = sum_f u_f B(x_d - x_f) prod_(e /= d) N_e,  dB/dx = (N(x + h/2) - N(x - h/2)) / h.                 [Pressure 4]
// sum_p V_p p_p D_p = sum_i f_i . u_i: points lose in heat what their pressures do in work. A flow without discrete
// divergence is not driven, wherever points stand, and no wave of shear grows in a gas at rest; with forces by the gradients
// of the points' shape functions it does, where their sums are not corrected [Quadrature 2]. And points that come back to where
// they stood have the energies that they had: those of points that move with another velocity do not, and grow where the density
// is not uniform.
// b is the interpolation of sixth order, (1, -8, 37, 37, -8, 1) / 60, of which a node that is more than 8 times lighter than the
// heaviest of the six takes no more than it has mass, m = min(1, 8 M_j / M_most) of its share; what they leave goes to the two
// nodes beside the face by their masses. So no node gets more force than its mass can bear. Beside a node without mass a face
// moves with the node on its other side. Across a wall the mirror images are the neighbours, and a node on it has a whole
// cell along its normal.
#pragma once

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "kernel/rotations.hpp"
#include "kernel/summation.hpp"
#include "kernel/walls.hpp"

namespace plumbline {

template <int dim>
class NodalPressure {
 public:
  using Vec = Eigen::Matrix<double, dim, 1>;
  using Field = VelocityField<dim>;

  // acts: otherwise pressures act at the points.
  NodalPressure(const Grid<dim>& grid, bool acts) : grid_(grid), acts_(acts) {}

  bool none() const { return !acts_; }

  // Finds b from the masses of gas on the nodes, folded at walls: once they are mapped, before all else here.
  void find_interpolation(Field& field, int threads) const {
    auto& gas = field.gas;
    gas.present.assign(field.mass.size(), 0.0);
    gas.bearing.assign(field.mass.size(), Vec::Zero());
    gas.even.assign(field.mass.size(), Vec::Zero());
    const std::vector<double>& mass = field.mass_of_gas();
    field.for_touched(
        grid_, [&](std::size_t i) { gas.present[i] = mass[i]; }, threads);
    for_own_nodes(field, threads, [&](int i, const Index& at) {
      for (int d = 0; d < dim; ++d) {
        const auto [bearing, even] = interpolation(field, line(i, at, d));
        gas.bearing[static_cast<std::size_t>(i)][d] = bearing;
        gas.even[static_cast<std::size_t>(i)][d] = even;
      }
    });
  }

  // Adds the forces to field.force; field.gas.pressure: from sum_p V_p p_p N_ip, folded at walls, to p_i, zero elsewhere.
  // inverse_volumes: 1 / |cell_i| of the nodes, see PointLoops. Returns what the walls give.
  WallAction<dim> add_forces(Field& field, const std::vector<double>& inverse_volumes, int threads) const {
    std::vector<double>& pressure = field.gas.pressure;
    for_each_index(static_cast<int>(pressure.size()), threads, [&](int i) {
      const auto at = static_cast<std::size_t>(i);
      pressure[at] = field.gas.present[at] > 0 ? pressure[at] * inverse_volumes[at] : 0.0;
    });
    std::vector<WallAction<dim>> rows(static_cast<std::size_t>(grid_.rows()));
    for_own_nodes(field, threads, [&](int i, const Index& at) {
      for (int d = 0; d < dim; ++d) {
        const Line here = line(i, at, d);
        const PressureForce given = force_along(field, here);
        const double area = face_area(at, d);
        if (!here.on_wall(here.index)) field.force[static_cast<std::size_t>(i)][d] += area * given.force;
        if (given.by_walls == 0) continue;
        WallAction<dim>& walls = rows[static_cast<std::size_t>(i / grid_.row_length())];
        const Vec action = area * given.by_walls * Vec::Unit(d);
        walls.linear += action;
        walls.angular += cross<dim>(grid_.position(i), action);
      }
    });
    return pairwise_sum(rows.data(), rows.size());
  }

  // field.gas.faces: u_f of the faces above the touched nodes along each axis, m/s, by a nodal velocity; field.gas.stretch: how
  // fast the cells of the nodes stretch along each, 1/s. Ghosts of walls excepted.
  void find_flow(Field& field, const std::vector<Vec>& velocity, int threads) const {
    std::vector<Vec>&faces = field.held(field.gas.faces), &stretch = field.held(field.gas.stretch);
    for_own_nodes(field, threads, [&](int i, const Index& at) {
      for (int d = 0; d < dim; ++d) {
        faces[static_cast<std::size_t>(i)][d] = face_velocity(field, line(i, at, d), velocity);
      }
    });
    for_own_nodes(field, threads, [&](int i, const Index& at) {
      const auto own = static_cast<std::size_t>(i);
      for (int d = 0; d < dim; ++d) {
        const Line here = line(i, at, d);
        double below = velocity[own][d];  // nothing is there, and the face moves with this node
        if (here.walled[0] && here.index == here.low)
          below = -faces[own][d];
        else if (here.index > here.low && field.gas.present[here.at(-1)] > 0)
          below = faces[here.at(-1)][d];
        stretch[own][d] = field.gas.present[own] > 0 ? (faces[own][d] - below) / grid_.h() : 0.0;
      }
    });
  }

 private:
  using Index = std::array<int, 3>;  // of a node along each direction

  bool walled(int d, int side) const { return grid_.wall(d, side) != Wall::free; }
  // Indices along d of the first and the last node that is no ghost of a wall.
  int low(int d) const { return walled(d, 0) ? Grid<dim>::ghosts : 0; }
  int high(int d) const { return grid_.nodes(d) - 1 - (walled(d, 1) ? Grid<dim>::ghosts : 0); }

  // visit(i, index) of the touched nodes that are no ghosts of a wall.
  template <class Visit>
  void for_own_nodes(const Field& field, int threads, Visit&& visit) const {
    for_each_piece(grid_.rows(), threads, [&](int row) {
      Index at{};
      for (int d = 1; d < dim; ++d) {
        const int k = at[static_cast<std::size_t>(d)] = grid_.row_index(row, d);
        if (k < low(d) || k > high(d)) return;
      }
      const auto [from, to] = field.touched[static_cast<std::size_t>(row)];
      for (int i = std::max(from, low(0)); i < std::min(to, high(0) + 1); ++i) {
        at[0] = i;
        visit(row * grid_.row_length() + i, at);
      }
    });
  }

  // Of the cell of a node, across d, m^(dim - 1).
  double face_area(const Index& at, int d) const {
    double area = 1;
    for (int e = 0; e < dim; ++e) {
      if (e == d) continue;
      const Line across = line(0, at, e);
      area *= grid_.h() * (across.on_wall(across.index) ? 0.5 : 1.0);
    }
    return area;
  }

  static constexpr std::array<double, 6> sixth{1.0 / 60, -8.0 / 60, 37.0 / 60, 37.0 / 60, -8.0 / 60, 1.0 / 60};
  static constexpr int reach = 3;      // nodes on either side of a face
  static constexpr double uneven = 8;  // ratio of masses: more than a strong shock makes

  // A node, and those beside it along one direction.
  struct Line {
    int d, node, stride, index, low, high;  // along d: index of the node, of the first and of the last one
    bool walled[2];

    bool beyond(int there) const { return (walled[0] && there < low) || (walled[1] && there > high); }
    bool exists(int k) const { return index + k >= low && index + k <= high; }
    // How far away the node is that the one k steps away is an image of, or that node itself; sign: of a velocity along d.
    int source(int k, double& sign) const {
      int there = index + k;
      for (sign = 1; beyond(there); sign = -sign) there = 2 * (there < low ? low : high) - there;
      return there - index;
    }
    // The same of the face above it.
    int source_of_face(int j) const {
      int there = index + j;
      while ((walled[0] && there < low) || (walled[1] && there >= high))
        there = 2 * (there < low ? low : high) - there - 1;
      return there - index;
    }
    std::size_t at(int k) const { return static_cast<std::size_t>(node + k * stride); }
    bool on_wall(int there) const { return (walled[0] && there == low) || (walled[1] && there == high); }
    // Away from ends and walls by more than faces reach.
    bool inside() const { return index - low > reach && high - index > reach; }
  };
  Line line(int node, const Index& at, int d) const {
    return {d, node, grid_.stride(d), at[static_cast<std::size_t>(d)], low(d), high(d), {walled(d, 0), walled(d, 1)}};
  }

  // Of a value on the nodes that is even beyond walls, zero where nothing is, and doubled on walls where it is of half a cell.
  static double even_value(const Line& line, int k, const std::vector<double>& values, bool of_half) {
    if (line.inside()) return values[line.at(k)];
    double sign;
    const int source = line.source(k, sign);
    if (!line.exists(source)) return 0;
    return (of_half && line.on_wall(line.index + source) ? 2 : 1) * values[line.at(source)];
  }
  static double mass(const Field& field, const Line& line, int k) {
    return even_value(line, k, field.gas.present, true);
  }

  // Of the face above a node: 8 / M_most, 1/kg, and what nodes take of the interpolation of sixth order; none beside a node
  // without mass.
  static std::pair<double, double> interpolation(const Field& field, const Line& line) {
    if (!(mass(field, line, 0) > 0 && mass(field, line, 1) > 0)) return {0, 0};
    double most = 0, left = 0;
    for (int k = 1 - reach; k <= reach; ++k) most = std::max(most, mass(field, line, k));
    for (int k = 1 - reach; k <= reach; ++k) {
      left += sixth[static_cast<std::size_t>(k + reach - 1)] * (1 - taken(mass(field, line, k), uneven / most));
    }
    return {uneven / most, 1 - left};
  }
  static double taken(double mass, double bearing) { return std::min(1.0, mass * bearing); }

  // b of the node k steps away for the face above the node j steps away. The two may be images.
  static double share(const Field& field, const Line& line, int j, int k) {
    const int face = line.inside() ? j : line.source_of_face(j);
    const double even = line.exists(face) ? field.gas.even[line.at(face)][line.d] : 0.0;
    const double own = sixth[static_cast<std::size_t>(k - j + reach - 1)];
    if (even == 1) return own;
    const double m = mass(field, line, k);
    if (m == 0) return 0;
    const double b = line.exists(face) ? own * taken(m, field.gas.bearing[line.at(face)][line.d]) : 0.0;
    if (k != j && k != j + 1) return b;
    return b + (1 - even) * m / (m + mass(field, line, k == j ? j + 1 : j));
  }

  static double face_velocity(const Field& field, const Line& line, const std::vector<Vec>& velocity) {
    double sum = 0;
    for (int k = 1 - reach; k <= reach; ++k) {
      const double b = share(field, line, 0, k);
      if (b == 0) continue;
      double sign = 1;
      const int source = line.inside() ? k : line.source(k, sign);
      sum += b * sign * velocity[line.at(source)][line.d];
    }
    return sum;
  }

  struct PressureForce {
    double force = 0;     // on a node, per area of its cell across the direction
    double by_walls = 0;  // what of it, and of what nodes on walls do not take, is the walls'
  };
  // What faces beyond a wall do to a node the faces before it do to the image of the node, the other way: the wall gives
  // both. What they do to a node on the wall it takes, and it bears the pressure there.
  static PressureForce force_along(const Field& field, const Line& line) {
    const std::vector<double>& pressure = field.gas.pressure;
    PressureForce sum;
    for (int j = -reach; j < reach; ++j) {
      const double rise = even_value(line, j + 1, pressure, false) - even_value(line, j, pressure, false);
      if (rise == 0) continue;
      const double force = -share(field, line, j, 0) * rise;
      const bool beyond = line.beyond(line.index + j) || line.beyond(line.index + j + 1);
      sum.force += force;
      if (line.on_wall(line.index))
        sum.by_walls -= beyond ? 0 : force;
      else if (beyond)
        sum.by_walls += 2 * force;
    }
    if (line.on_wall(line.index)) sum.by_walls += (line.index == line.low ? 1 : -1) * pressure[line.at(0)];
    return sum;
  }

  Grid<dim> grid_;
  bool acts_;
};

}  // namespace plumbline
