// Compressible ideal gas with an energy equation, viscosity and artificial viscosity. [York chapter 4]
#pragma once

#include "kernel/materials/material.hpp"

namespace plumbline {

// sigma = 2 mu e - 2/3 mu tr(e) 1 - (p + q) 1                                    [York 4.1]
// p = (gamma - 1) rho e                                                          [York 4.4]
// q = rho (c_L c h D + c_Q h^2 D^2), D = max(0, -div v) or, limited, the column closing  [York 4.11] [Limiter 1]
// The printed (4.11, 4.12) have one velocity too many and the wrong sign; this is the von Neumann-Richtmyer-Landshoff
// form after Wilkins (1980, doi 10.1016/0021-9991(80)90161-8).
struct IdealGas final : Material {
  double gamma = 1.4;              // > 1
  double viscosity = 0;            // mu, Pa s, >= 0
  double viscosity_linear = 0;     // c_L, >= 0
  double viscosity_quadratic = 0;  // c_Q, >= 0
  bool limits_viscosity = false;   // to what is not linear in the flow

  std::string name() const override { return "ideal_gas"; }
  void add_columns(Columns& points, int dim) const override;
  Store store() const override { return Store::internal; }
  bool has_density() const override { return true; }
  bool takes_heat() const override { return true; }
  // Without physical viscosity the stress is a pressure.
  StressMeasure measure() const override { return viscosity == 0 ? StressMeasure::pressure : StressMeasure::symmetric; }
  bool viscous() const { return viscosity > 0 || viscosity_linear > 0 || viscosity_quadratic > 0; }
  Traits needs() const override { return viscous() ? Traits{Trait::forward_steps} : Traits{}; }
  double advance(Columns& points, PointRange range, const MaterialContext& context, double dt) const override;
  std::vector<const ColumnId*> internal_variables(const MaterialContext& context) const override;
  std::vector<double> rates(const Columns& points, const MaterialContext& context) const override;
  void evaluate_stress(Columns& points, PointRange range, const MaterialContext& context) const override;
  bool reverse_cooling(Columns& points, PointRange range, const MaterialContext& context) const override;
  double viscous_heat(const Columns& points, PointRange range, const MaterialContext& context,
                      double dt) const override;
  void add_heat(Columns& points, PointRange range, const double* heat) const override;
  double stored_energy(const Columns& points, PointRange range) const override;
  StepBounds step_bounds(const Columns& points, PointRange range, int dim) const override;
  Fault first_fault(const Columns& points, PointRange range) const override;
  void describe(Columns& points) const override;
};

}  // namespace plumbline
