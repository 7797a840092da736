// Gates that any shape must meet, in each geometry. Bounds follow from theory.
#pragma once

#include <memory>
#include <vector>

#include "cases/harness/judge/measured_gates.hpp"
#include "cases/harness/parts/shape_probe.hpp"

namespace plumbline {

// A shape in one geometry, on a grid with walls on all sides and on one with none.
struct ShapeSubject {
  ShapeSubject(const ShapeEntry& shape, std::size_t geometry_);
  const ShapeEntry* entry;
  std::size_t geometry;
  std::unique_ptr<ShapeProbe> walled, open;
  // The largest of what `measure` finds on both grids; a value that is no number stays.
  double larger_of_both(const std::function<double(const ShapeProbe&)>& measure) const;
};
using SharedSubject = std::shared_ptr<const ShapeSubject>;

// Sums of values of order one over the nodes that a point reaches, times the grid's cells: a few thousand roundings, which
// allows for shapes that solve small systems of equations.
inline constexpr double shape_rounding = 1e-12;

std::vector<MeasuredGate> shape_gates(const ShapeEntry& shape);

// The rows of one geometry.
std::vector<MeasuredGate> shape_identity_gates(const SharedSubject& subject);
std::vector<MeasuredGate> shape_support_gates(const SharedSubject& subject);
std::vector<MeasuredGate> shape_path_gates(const SharedSubject& subject);
std::vector<MeasuredGate> shape_domain_gates(const SharedSubject& subject);
std::vector<MeasuredGate> shape_order_gates(const SharedSubject& subject);

// Random values from -1 to 1 on every node, a column for each direction.
Eigen::MatrixXd random_field(const ShapeProbe& probe, unsigned long seed);

}  // namespace plumbline
