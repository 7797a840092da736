// A membrane in space whose tangents the grid's velocity gradient carries along.
#pragma once

#include "kernel/materials/material.hpp"
#include "kernel/materials/surface_law.hpp"

namespace plumbline {

// df_a/dt = (grad v) f_a, and sigma = S_ab f_a f_b^T on the volume at rest. [Carried 1] For comparison with SurfaceMembrane: irregular
// points are no exact quadrature, so a uniform tension leaves forces on the nodes, points slip, and the tangents relax against
// the true stretch. The energy falls meanwhile: only tangents compared with places show it.
struct CarriedMembrane final : Material, SurfaceLaw {
  std::string name() const override { return "carried_membrane"; }
  StressMeasure measure() const override { return StressMeasure::full; }
  Store store() const override { return Store::elastic; }
  bool surface() const override { return true; }
  // As SurfaceMembrane::add_columns().
  void add_columns(Columns& points, int dim) const override;
  double advance(Columns& points, PointRange range, const MaterialContext& context, double dt) const override;
  std::vector<const ColumnId*> internal_variables(const MaterialContext& context) const override;
  std::vector<double> rates(const Columns& points, const MaterialContext& context) const override;
  void evaluate_stress(Columns& points, PointRange range, const MaterialContext& context) const override;
  double stored_energy(const Columns& points, PointRange range) const override;
  StepBounds step_bounds(const Columns& points, PointRange range, int dim) const override;
  Fault first_fault(const Columns& points, PointRange range) const override;
};

}  // namespace plumbline
