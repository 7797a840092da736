// Small strains, Hooke's law.
#pragma once

#include "kernel/materials/elastic.hpp"
#include "kernel/materials/material.hpp"

namespace plumbline {

// sigma = lambda tr(eps) 1 + 2 mu eps, eps carried as the total strain: d eps = (grad v + grad v^T)/2 dt.  [Hooke 1]
// On a line the stress is uniaxial: sigma = E eps. In the plane either no strain out of it, or no stress: lambda becomes
// 2 lambda mu / (lambda + 2 mu). Strains add up in fixed axes, so bodies must not turn by more than a small angle; volumes
// stay constant.
struct LinearElastic final : Material {
  double youngs_modulus = 0;  // E, Pa, > 0
  double poissons_ratio = 0;  // nu, -1 < nu < 1/2
  double density = 0;         // rho_0, kg/m^3, > 0: sets the wave speed of the step limit
  bool plane_stress = false;  // in the plane alone

  std::string name() const override { return "linear_elastic"; }
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

  // lambda and mu of the plane or space; on a line (0, E/2).
  LameConstants constants(int dim) const;
  double wave_speed(int dim) const;  // of compression, m/s
};

}  // namespace plumbline
