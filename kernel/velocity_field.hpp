// The nodal arrays of one velocity field. Bodies that name the same field move together; bodies in contact do not.
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

#include "kernel/grid.hpp"
#include "kernel/parallel.hpp"

namespace plumbline {

// Below this nodal mass (kg) a quotient of sums would lose all digits to underflow. It is not a cut-off of light nodes.
inline constexpr double least_mass = 1e-200;

template <int dim>
struct VelocityField {
  using Vec = Eigen::Matrix<double, dim, 1>;

  enum class Holding { motion, mass };  // mass: of bodies whose mass alone is wanted

  explicit VelocityField(const Grid<dim>& grid, Holding holding = Holding::motion)
      : touched(static_cast<std::size_t>(grid.rows()), {0, 0}),
        mass(size(grid)) {
    if (holding == Holding::mass) return;
    held(unfolded.mass);
    for (std::vector<Vec>* array : {&momentum, &start, &force, &end, &midpoint}) held(*array);
  }

  template <class Value>
  static Value zero() {
    if constexpr (std::is_same_v<Value, Vec>)
      return Vec::Zero();
    else
      return 0;
  }
  // One of these arrays that not every scene needs, of zeros when it is first asked for.
  template <class Value>
  std::vector<Value>& held(std::vector<Value>& values) const {
    if (values.empty()) values.assign(mass.size(), zero<Value>());
    return values;
  }

  // Arrays that only fields need whose gas shares nodes with other bodies.
  void add_gas_arrays(const Grid<dim>& grid) {
    gas.mass.resize(size(grid));
    gas.loss.resize(size(grid));
  }

  // Whether gas shares the field's nodes with other bodies, and the mass of gas.
  bool mixed() const { return !gas.mass.empty(); }
  const std::vector<double>& mass_of_gas() const { return mixed() ? gas.mass : mass; }

  static std::size_t size(const Grid<dim>& grid) { return static_cast<std::size_t>(grid.node_count()); }

  std::vector<std::pair<int, int>> touched;  // [first, last) node of each row that a point reaches; empty: (0, 0)
  std::vector<double> mass;                  // M_i; at ghost nodes what the points put there, also after folding
  std::vector<Vec> momentum;                 // P_i
  std::vector<Vec> start;                    // v_i at the start of the step
  std::vector<Vec> force;                    // f_i, body force included
  std::vector<Vec> end;                      // v~_i = v_i + dt f_i / M_i
  std::vector<Vec> midpoint;                 // (v_i + v~_i) / 2
  // Those below are empty until a step needs them.
  std::vector<Vec> body_force;  // what of the force is sum_p m_p b_p N_ip, as points put it there
  std::vector<Vec> remapped;    // v_i from the updated point velocities [York 3.24]
  struct {
    std::vector<double> mass;   // what the points put on each node
    std::vector<Vec> momentum;  // the same of P_i
  } unfolded;                   // before folding at walls
  struct {
    std::vector<Vec> kept;                   // how much of the sharpening stays along each axis [Limiter 2]; empty: all
    std::vector<Vec> odd_power, even_power;  // of B_d on one [Sharpening 1]
    std::vector<Vec> straining;              // the one whose gradients strain the points, sharpened
    std::vector<Vec> added;                  // what sharpening adds to the one that carries them
    std::vector<Vec> filtered;               // w_i of the transfers xpic and fmpm
  } corrected;                               // nodal velocities
  struct {
    std::vector<double> mass;        // of the bodies that take heat, if others share the field
    std::vector<double> density;     // M_i / |cell_i|
    std::vector<double> heat;        // sum_p m_p e_p N_ip, then E_i, its mean per mass
    std::vector<double> exchange;    // sum_p m_p N_ip max(0, -div v), then alpha_i
    std::vector<double> kept;        // sum_p m_p c_p N_ip, then 1 - alpha_i of [Filter 1]
    std::vector<double> closing;     // K_i of [Limiter 1]
    std::vector<Vec> slopes;         // and what it is found from
    std::vector<double> pressure;    // sum_p V_p p_p N_ip, then p_i of [Pressure 1]
    std::vector<double> present;     // the mass of gas on all nodes, zero where none is
    std::vector<Vec> bearing, even;  // of the faces above: 8 / M_most, and what of b is of sixth order [Pressure 2]
    std::vector<Vec> faces;          // u_f of these
    std::vector<Vec> stretch;        // (u_(i + 1/2) - u_(i - 1/2)) / h
    std::vector<double> divergence;  // their sum D_i
    std::vector<double> share;       // P_i / p_i of [Quadrature 1]
    std::vector<double> even_part;   // P_i
    std::vector<double> mean;        // sum_p V_p N_ip div v_p, then what is added to div v_p [Quadrature 3]
    std::array<std::vector<double>, 4> along;  // for what goes from one axis to the next
    std::vector<double> loss;                  // what the others lost this step, then per mass of gas, J/kg
  } gas;

  // Calls visit(node) for every touched node of a row.
  template <class Visit>
  void for_touched_in(const Grid<dim>& grid, int row, Visit&& visit) const {
    const auto [first, last] = touched[static_cast<std::size_t>(row)];
    const int base = row * grid.row_length();
    for (int i = first; i < last; ++i) visit(static_cast<std::size_t>(base + i));
  }
  // For every touched node, row by row; visits of different rows may run side by side.
  template <class Visit>
  void for_touched(const Grid<dim>& grid, Visit&& visit, int threads = 1) const {
    for_each_piece(grid.rows(), threads, [&](int row) { for_touched_in(grid, row, visit); });
  }
};

}  // namespace plumbline
