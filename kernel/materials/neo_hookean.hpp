// Finite strains, compressible neo-Hookean.
#pragma once

#include "kernel/materials/elastic.hpp"
#include "kernel/materials/material.hpp"

namespace plumbline {

// W = mu/2 (F : F - d - 2 ln J) + lambda/2 (ln J)^2, P = mu (F - F^-T) + lambda ln J F^-T           [Neo-Hookean 1]
// dF/dt = grad v F                                                                                  [Neo-Hookean 2]
// (Wallstedt, Guilkey 2008, doi 10.1016/j.jcp.2008.07.019.) The stress column holds J^-1 P(F + ahead dF/dt) F^T: by the
// gradients of where the points stand it gives the nodal forces of P. On a line and in the plane there is no strain in the
// other directions; rings have the hoop's stretch beside F. The volume column follows: V = J m / rho_0.
struct NeoHookean final : Material {
  double youngs_modulus = 0;  // E, Pa, > 0
  double poissons_ratio = 0;  // nu, -1 < nu < 1/2
  double density = 0;         // rho_0, kg/m^3, > 0

  std::string name() const override { return "neo_hookean"; }
  StressMeasure measure() const override { return StressMeasure::full; }
  bool bounds_at_start() const override { return true; }
  // Sets F = 1.
  void add_columns(Columns& points, int dim) const override;
  Store store() const override { return Store::elastic; }
  double advance(Columns& points, PointRange range, const MaterialContext& context, double dt) const override;
  void share_dilatation(Columns& points) const override;
  std::vector<const ColumnId*> internal_variables(const MaterialContext& context) const override;
  std::vector<double> rates(const Columns& points, const MaterialContext& context) const override;
  void evaluate_stress(Columns& points, PointRange range, const MaterialContext& context) const override;
  double stored_energy(const Columns& points, PointRange range) const override;
  StepBounds step_bounds(const Columns& points, PointRange range, int dim) const override;
  std::optional<RestState> rest(int dim) const override;
  Fault first_fault(const Columns& points, PointRange range) const override;

  LameConstants constants() const { return lame_constants(youngs_modulus, poissons_ratio); }
};

}  // namespace plumbline
