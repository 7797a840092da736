// A membrane in space whose tangents are those of the surface through its points.
#pragma once

#include <memory>

#include "kernel/materials/material.hpp"
#include "kernel/materials/surface_law.hpp"
#include "kernel/surface_neighbours.hpp"

namespace plumbline {

// U = sum_p A_p t W(c_p) is a function of where points stand, so strain cannot drift, and F_k = -dU/dx_k goes to the nodes by N_ik:
// momentum and angular momentum are exact. [Surface 3] Points keep the order in which they were made.
struct SurfaceMembrane final : Material, SurfaceLaw {
  double reach = 2.6;  // of neighbours at rest, over the root of the mean area of a point, > 0
  std::shared_ptr<const SurfaceNeighbours> neighbours;  // of_rest() finds them

  std::string name() const override { return "surface_membrane"; }
  StressMeasure measure() const override { return StressMeasure::point_force; }
  Store store() const override { return Store::elastic; }
  bool surface() const override { return true; }
  // The volume of a point is the area at rest that it stands for times the thickness; tangents must be those of the start.
  void add_columns(Columns& points, int dim) const override;
  std::shared_ptr<const Material> of_rest(const Columns& points) const override;
  // The same with images of points behind a clamped edge, with the sheet of each point, with the direction out of a free edge near
  // it, and with neighbours given; see surface_neighbours().
  std::shared_ptr<const SurfaceMembrane> of_rest(const Columns& points, const std::vector<OddImage>& images,
                                                 const std::vector<int>& sheet,
                                                 const std::vector<std::array<double, 3>>& outward = {},
                                                 const std::vector<std::vector<int>>& given = {}) const;
  double advance(Columns& points, PointRange range, const MaterialContext& context, double dt) const override;
  std::vector<const ColumnId*> internal_variables(const MaterialContext& context) const override;
  std::vector<double> rates(const Columns& points, const MaterialContext& context) const override;
  void prepare_stress(Columns& points, PointRange range, const MaterialContext& context) const override;
  void evaluate_stress(Columns& points, PointRange range, const MaterialContext& context) const override;
  double stored_energy(const Columns& points, PointRange range) const override;
  StepBounds step_bounds(const Columns& points, PointRange range, int dim) const override;
  Fault first_fault(const Columns& points, PointRange range) const override;
  void describe(Columns& points) const override;

  double spacing(const Columns& points) const;  // root of the mean area of a point at rest, m

 private:
  const SurfaceNeighbours& known() const;
};

namespace column {
// A t S_ab f_b of a = 1, then 2: what a point pulls with, by the weights of its neighbours
inline const ColumnId surface_pull{"surface_pull", "N m"};
inline const ColumnId surface_energy{"surface_energy", "J"};
}  // namespace column
}  // namespace plumbline
