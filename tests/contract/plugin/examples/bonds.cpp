// A material outside the repository whose points pull at their neighbours: each is bound to all others of the body within a horizon
// delta of where it started. Of a bond xi = X_b - X_a, s = |x_b - x_a| / |xi| - 1:
//   W = c s^2 |xi| V_a V_b / 2,  F_a = c s (x_b - x_a) / |x_b - x_a| V_a V_b = -F_b
// with V = m / rho_0 and, so that it is Hooke's law with nu = 1/4 where strains are uniform, c = 2 E / delta^2 on a line,
// 48 E / (5 pi delta^3) in the plane without strain out of it, 12 E / (pi delta^4) in space. (Silling, Askari 2005,
// doi 10.1016/j.compstruc.2004.11.026.) Near a surface bonds are missing, and it is softer. Not for rings.
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "kernel/materials/material_entry.hpp"
#include "kernel/register_part.hpp"

namespace {

using namespace plumbline;

const ColumnId rest_place{"rest_place", "m"};    // X_p, and behind it 1 once it is set
const ColumnId bond_energy{"bond_energy", "J"};  // half of the energy of each of its bonds

struct Bonds final : Material {
  double youngs_modulus = 1, density = 1;  // Pa; kg/m^3
  double horizon = 3;                      // delta over the spacing of the points

  std::string name() const override { return "bonds"; }
  StressMeasure measure() const override { return StressMeasure::point_force; }
  Store store() const override { return Store::elastic; }
  void add_columns(Columns& points, int dim) const override {
    points.add(rest_place, dim + 1);
    points.add(bond_energy);
  }
  std::vector<const ColumnId*> internal_variables(const MaterialContext&) const override { return {&bond_energy}; }

  // The first call is at the start of the run, where no bond is stretched. Forces are those of where the points will be.
  void evaluate_stress(Columns& points, PointRange range, const MaterialContext& context) const override {
    const int dim = points.components(column::position);
    for (int p = range.first; p < range.last; ++p) {
      std::array<double, 3> force{};
      if (points(rest_place, dim)[p] == 0) {
        for (int d = 0; d < dim; ++d) points(rest_place, d)[p] = points(column::position, d)[p];
        points(rest_place, dim)[p] = 1;
      } else {
        for_bonds(points, p, context.ahead, [&](const Bond& bond) {
          for (int d = 0; d < dim; ++d) force[at(d)] += bond.pull * bond.direction[at(d)];
        });
      }
      for (int d = 0; d < dim; ++d) points(column::stress, d)[p] = -force[at(d)] / points(column::volume)[p];
    }
  }

  double advance(Columns& points, PointRange range, const MaterialContext&, double) const override {
    double stored = 0;
    for (int p = range.first; p < range.last; ++p) {
      double energy = 0;
      for_bonds(points, p, 0, [&](const Bond& bond) { energy += 0.5 * bond.energy; });
      stored += energy - points(bond_energy)[p];
      points(bond_energy)[p] = energy;
    }
    return stored;
  }

  std::vector<double> rates(const Columns& points, const MaterialContext&) const override {
    std::vector<double> all(static_cast<std::size_t>(points.points()));
    for (int p = 0; p < points.points(); ++p) {
      for_bonds(points, p, 0, [&](const Bond& bond) {
        for (int d = 0; d < points.components(column::position); ++d) {
          const double* v = points(column::strain_rate, d);
          all[at(p)] += 0.5 * bond.pull * bond.direction[at(d)] * (v[bond.other] - v[p]);
        }
      });
    }
    return all;
  }

  double stored_energy(const Columns& points, PointRange range) const override {
    double sum = 0;
    for (int p = range.first; p < range.last; ++p) sum += points(bond_energy)[p];
    return sum;
  }
  StepBounds step_bounds(const Columns& points, PointRange range, int dim) const override {
    return {.fastest = std::sqrt(modulus(dim) / density) + fastest_point(points, range, dim)};
  }
  std::optional<RestState> rest(int dim) const override { return RestState{density, modulus(dim)}; }
  Fault first_fault(const Columns& points, PointRange range) const override {
    return first_not_finite(points, range, bond_energy, "the energy of bonds must be finite");
  }

 private:
  // Of compression, Pa.
  double modulus(int dim) const {
    const double stiff = dim == 1 ? 1 : 1.2;  // (1 - nu) / ((1 + nu) (1 - 2 nu))
    return stiff * youngs_modulus;
  }

  struct Bond {
    int other;
    double pull, energy;                // N; J
    std::array<double, 3> direction{};  // from the point to the other, of length 1
  };
  static std::size_t at(int k) { return static_cast<std::size_t>(k); }

  double stiffness(int dim, double delta) const {
    const double e = youngs_modulus, pi = std::numbers::pi;
    if (dim == 1) return 2 * e / (delta * delta);
    return dim == 2 ? 48 * e / (5 * pi * std::pow(delta, 3)) : 12 * e / (pi * std::pow(delta, 4));
  }

  // As they will be `ahead` seconds later if points keep the velocities in the strain_rate column.
  template <class Visit>
  void for_bonds(const Columns& points, int p, double ahead, Visit&& visit) const {
    const int dim = points.components(column::position);
    const double own = points(column::mass)[p] / density, delta = horizon * std::pow(own, 1.0 / dim);
    const double c = stiffness(dim, delta) * own / density;
    const double *rest[3] = {}, *x[3] = {}, *v[3] = {}, *mass = points(column::mass);
    for (int d = 0; d < dim; ++d) {
      rest[d] = points(rest_place, d);
      x[d] = points(column::position, d);
      v[d] = points(column::strain_rate, d);
    }
    for (int q = 0; q < points.points(); ++q) {
      double square = 0, length = 0;
      for (int d = 0; d < dim; ++d) square += (rest[d][q] - rest[d][p]) * (rest[d][q] - rest[d][p]);
      if (q == p || square > delta * delta) continue;
      Bond bond{q, 0, 0};
      for (int d = 0; d < dim; ++d) {
        bond.direction[at(d)] = x[d][q] - x[d][p];
        if (ahead != 0) bond.direction[at(d)] += ahead * (v[d][q] - v[d][p]);
        length += bond.direction[at(d)] * bond.direction[at(d)];
      }
      length = std::sqrt(length);
      const double s = length / std::sqrt(square) - 1;
      bond.pull = c * mass[q] * s;
      bond.energy = 0.5 * bond.pull * s * std::sqrt(square);
      for (double& part : bond.direction) part /= length;
      visit(bond);
    }
  }
};

const RegisterPart entry(material_entry<Bonds>("bonds between all points within a horizon",
                                               "Silling, Askari 2005, doi 10.1016/j.compstruc.2004.11.026",
                                               {{"youngs_modulus", "Pa", &Bonds::youngs_modulus},
                                                {"density", "kg/m^3", &Bonds::density},
                                                {"horizon", "1", &Bonds::horizon}}));

}  // namespace
