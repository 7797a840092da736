// Elastoplastic solids at finite strains: von Mises's yield condition with linear isotropic hardening.
#pragma once

#include "kernel/materials/elastic.hpp"
#include "kernel/materials/material.hpp"
#include "kernel/materials/radial_return.hpp"

namespace plumbline {

namespace column {
// Of (1/2) ln b_e: the normal components x, y, z in every geometry, then the shears that it has: xy, or yz, xz, xy.
inline const ColumnId elastic_strain{"elastic_strain", "1"};
inline const ColumnId plastic_strain{"plastic_strain", "1"};  // equivalent, alpha
inline const ColumnId heat{"heat", "J/kg"};                   // by plastic flow and viscosity, since the start
inline const ColumnId viscous_pressure{"viscous_pressure", "Pa"};
}  // namespace column

// Multiplicative plasticity with Hencky's law and an exponential return (Simo 1992, doi 10.1016/0045-7825(92)90123-2): the equations
// [J2 1-4] stand in radial_return.hpp. On a line and in the plane the total strain in the other directions is zero, not so the
// elastic and the plastic one. The stress column holds J^-1 tau(ahead) A^-T with A = 1 + ahead grad v, so that nodal forces are
// those of P = tau F^-T as for other finite strains, less a viscous pressure rho c_L c h max(0, -div v), c^2 = (K + 4 G/3)/rho_0  [J2 6]
// Of the plastic work Y d_alpha is heat, dE = Y d_alpha + V q (-div v) dt [J2 5]; the work of hardening, H alpha^2/2, stays stored.
// The column pressure is -tr tau / (3 J), without the viscous part. No heat changes the stress.
// Plastic flow keeps the volume, so that elements lock as of what hardly compresses, whatever nu: in the plane and in space points
// share their dilatation theta where the scene has them do so, with K in the place of lambda,
//   W = K_o/2 (tr eps)^2 + (K - K_o)/2 theta^2 + G |dev eps|^2,  K_o = K/50                               [J2 7]
struct J2Plasticity final : Material {
  double youngs_modulus = 0;     // E, Pa, > 0
  double poissons_ratio = 0;     // nu, -1 < nu < 1/2
  double density = 0;            // rho_0, kg/m^3, > 0
  double yield_stress = 0;       // Y, Pa, > 0
  double hardening_modulus = 0;  // H, Pa, >= 0
  double viscosity_linear = 0;   // c_L, >= 0

  std::string name() const override { return "j2_plasticity"; }
  StressMeasure measure() const override { return StressMeasure::full; }
  // Sets F = 1. Throws std::invalid_argument for a parameter out of range.
  void add_columns(Columns& points, int dim) const override;
  Store store() const override { return Store::elastic; }
  bool dissipates() const override { return true; }
  double advance(Columns& points, PointRange range, const MaterialContext& context, double dt) const override;
  void share_dilatation(Columns& points) const override;
  std::vector<const ColumnId*> internal_variables(const MaterialContext& context) const override;
  std::vector<double> rates(const Columns& points, const MaterialContext& context) const override;
  void evaluate_stress(Columns& points, PointRange range, const MaterialContext& context) const override;
  double viscous_heat(const Columns& points, PointRange range, const MaterialContext& context,
                      double dt) const override;
  double stored_energy(const Columns& points, PointRange range) const override;
  double heat(const Columns& points, PointRange range) const override;
  StepBounds step_bounds(const Columns& points, PointRange range, int dim) const override;
  std::optional<RestState> rest(int dim) const override;
  Fault first_fault(const Columns& points, PointRange range) const override;

  J2Law law() const;
  void check() const;  // throws std::invalid_argument with name, value and range
};

}  // namespace plumbline
