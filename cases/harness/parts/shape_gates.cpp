#include "cases/harness/parts/shape_gates.hpp"

#include <cmath>
#include <utility>

namespace plumbline {
namespace {

// A place along a direction of so many cells, in cells.
double coordinate(ProbeRandom& random, int cells, double least) {
  double x = random(least, cells);
  if (random(0, 1) < 1.0 / 3) {
    x = std::round(2 * x) / 2;
    const double side = random(-1, 1);
    if (side < -0.3) x = std::nextafter(x, 0.0);
    if (side > 0.3) x = std::nextafter(x, 2.0 * cells);
  }
  return std::max(x, least);
}

}  // namespace

ShapeSubject::ShapeSubject(const ShapeEntry& shape, std::size_t geometry_)
    : entry(&shape),
      geometry(geometry_),
      walled(probe(shape, geometry, probe_grid(geometry, true))),
      open(probe(shape, geometry, probe_grid(geometry, false))) {}

double ShapeSubject::larger_of_both(const std::function<double(const ShapeProbe&)>& measure) const {
  const double a = measure(*walled), b = measure(*open);
  return std::isnan(a) || a > b ? a : b;
}

std::vector<ProbePoint> probe_points(const GridSpec& grid, int count, unsigned long seed, bool off_axis) {
  constexpr double least_half = 0.1, widest_half = 0.5;  // of boxes, in cells: up to half a cell on each side
  ProbeRandom random(seed);
  std::vector<ProbePoint> points(static_cast<std::size_t>(count));
  for (ProbePoint& point : points) {
    point.half = grid.h * random(least_half, widest_half);
    for (std::size_t d = 0; d < static_cast<std::size_t>(grid.dim); ++d) {
      const double least = off_axis && grid.axisymmetric && d == 0 ? 0.1 : 0;
      point.x[d] = grid.origin[d] + grid.h * coordinate(random, grid.cells[d], least);
    }
  }
  return points;
}

Eigen::MatrixXd random_field(const ShapeProbe& probe, unsigned long seed) {
  ProbeRandom random(seed);
  return Eigen::MatrixXd::NullaryExpr(probe.nodes(), probe.grid().dim, [&] { return random(-1, 1); });
}

std::vector<MeasuredGate> shape_gates(const ShapeEntry& shape) {
  std::vector<MeasuredGate> all;
  for (std::size_t geometry = 0; geometry < geometry_names().size(); ++geometry) {
    if (!has_geometry(shape, geometry)) continue;
    const auto subject = std::make_shared<const ShapeSubject>(shape, geometry);
    for (auto* rows : {shape_identity_gates, shape_support_gates, shape_path_gates, shape_order_gates}) {
      std::vector<MeasuredGate> some = rows(subject);
      std::move(some.begin(), some.end(), std::back_inserter(all));
    }
  }
  return all;
}

}  // namespace plumbline
