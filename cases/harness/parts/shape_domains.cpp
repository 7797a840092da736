// Gradients that are means over a point's domain: between two points that stand an edge of it apart, values change by the
// trapezoids of these means. Where corners carry values U, the mean gradient along an edge 2r is that of the differences of
// U across the domain, and each value the mean of the corners, so that the corners between the two cancel.
#include <algorithm>
#include <cmath>
#include <limits>

#include "cases/harness/parts/shape_gates.hpp"

namespace plumbline {
namespace {

constexpr int domains_points = 200;
constexpr unsigned long domains_seed = 50;

// The largest |U(x + 2 l e_d) - U(x) - l (U'(x) + U'(x + 2 l e_d))| of a random field, for points whose neighbour stands on
// the grid.
double off_trapezoids(const ShapeProbe& probe) {
  const GridSpec& grid = probe.grid();
  const std::vector<ProbePoint> from = probe_points(grid, domains_points, domains_seed);
  const Eigen::MatrixXd u = random_field(probe, domains_seed + 1);
  const Interpolated here = probe.interpolated(from, u);
  double worst = 0;
  for (std::size_t d = 0; d < static_cast<std::size_t>(grid.dim); ++d) {
    std::vector<ProbePoint> to = from;
    const double end = grid.origin[d] + grid.cells[d] * grid.h;
    for (ProbePoint& point : to) {
      if (point.x[d] + 2 * point.half <= end) point.x[d] += 2 * point.half;
    }
    const Interpolated there = probe.interpolated(to, u);
    for (std::size_t p = 0; p < from.size(); ++p) {
      const auto row = static_cast<Eigen::Index>(p);
      const double step = to[p].x[d] - from[p].x[d];
      const Eigen::RowVectorXd off = there.value.row(row) - here.value.row(row) -
                                     step / 2 * (here.gradient[d].row(row) + there.gradient[d].row(row));
      const double largest = off.hasNaN() ? std::numeric_limits<double>::quiet_NaN() : off.cwiseAbs().maxCoeff();
      if (!(largest <= worst)) worst = largest;
    }
  }
  return worst;
}

}  // namespace

std::vector<MeasuredGate> shape_domain_gates(const SharedSubject& subject) {
  if (!subject->entry->domain_gradients) return {};
  return {{"gradient",
           gate_row("gradient", "domain/" + geometry_names()[subject->geometry],
                    "change of a random field between points an edge of their domains apart, less the trapezoid of its "
                    "gradients, at 200 points in each direction",
                    {{}, shape_rounding}, Origin::identity,
                    "the shape says that gradients are means over domains whose corners carry the "
                    "values; a few thousand roundings"),
           "the gradient is no mean over the domain that the values belong to, or lacks a factor",
           [subject] { return plain(subject->larger_of_both(off_trapezoids)); }}};
}

}  // namespace plumbline
