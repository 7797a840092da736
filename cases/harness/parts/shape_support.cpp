// Which nodes a point of a shape reaches, and which points stand on the grid.
#include <algorithm>
#include <cmath>
#include <limits>

#include "cases/harness/parts/shape_gates.hpp"
#include "kernel/engine/point_loops.hpp"

namespace plumbline {
namespace {

constexpr int support_points = 40;
constexpr unsigned long support_seed = 30;

// Whether a node is one of those that a point says it reaches.
bool reached(const std::array<int, 3>& node, const std::array<int, 3>& lowest, int support, int dim) {
  for (std::size_t d = 0; d < static_cast<std::size_t>(dim); ++d) {
    if (node[d] < lowest[d] || node[d] >= lowest[d] + support) return false;
  }
  return true;
}

// The largest weight, or gradient times h, of a node beyond those.
double beyond_reach(const ShapeProbe& probe) {
  const std::vector<ProbePoint> points = probe_points(probe.grid(), support_points, support_seed);
  const std::vector<std::array<int, 3>> lowest = probe.lowest(points);
  const int dim = probe.grid().dim;
  double worst = 0;
  Eigen::MatrixXd unit = Eigen::MatrixXd::Zero(probe.nodes(), dim);
  for (int i = 0; i < probe.nodes(); ++i) {
    unit(i, 0) = 1;
    const Interpolated at = probe.interpolated(points, unit);
    unit(i, 0) = 0;
    for (std::size_t p = 0; p < points.size(); ++p) {
      if (reached(probe.index(i), lowest[p], probe.support(), dim)) continue;
      const auto row = static_cast<Eigen::Index>(p);
      double here = std::abs(at.value(row, 0));
      for (const Eigen::MatrixXd& gradient : at.gradient) {
        here = std::max(here, probe.grid().h * std::abs(gradient(row, 0)));
      }
      if (!(here <= worst)) worst = here;
    }
  }
  return worst;
}

// How many places beyond a side, far away or nowhere are taken for places on the grid, and how many on a side are not.
double misplaced(const ShapeProbe& probe) {
  const GridSpec& grid = probe.grid();
  const ProbePoint middle = [&] {
    ProbePoint point;
    for (std::size_t d = 0; d < 3; ++d) point.x[d] = grid.origin[d] + 0.5 * grid.cells[d] * grid.h;
    point.half = grid.h / 4;
    return point;
  }();
  int wrong = 0;
  for (std::size_t d = 0; d < static_cast<std::size_t>(grid.dim); ++d) {
    const double low = grid.origin[d], high = low + grid.cells[d] * grid.h;
    const double off = 1e3 * on_side * grid.h;
    const double outside[] = {low - off,
                              high + off,
                              low - 5 * grid.h,
                              high + 5 * grid.h,
                              -1e300,
                              1e300,
                              std::numeric_limits<double>::infinity(),
                              std::numeric_limits<double>::quiet_NaN()};
    ProbePoint point = middle;
    for (const double x : outside) {
      point.x[d] = x;
      wrong += probe.inside(point) ? 1 : 0;
    }
    for (const double x : {low, high, low + off, high - off, 0.5 * (low + high)}) {
      point.x[d] = x;
      wrong += probe.inside(point) ? 0 : 1;
    }
  }
  return wrong;
}

}  // namespace

std::vector<MeasuredGate> shape_support_gates(const SharedSubject& subject) {
  const std::string where = geometry_names()[subject->geometry];
  return {
      {"support",
       gate_row("support", "reach/" + where,
                "largest weight, or gradient in cells, of a node beyond those that a point says it reaches",
                {{}, shape_rounding}, Origin::identity,
                "a step clears and sums the nodes that points say they reach: what goes elsewhere is lost; rounding"),
       "the shape is wider than its support says, or its lowest node is another",
       [subject] { return plain(subject->larger_of_both(beyond_reach)); }},
      {"support",
       gate_row("support", "sides/" + where,
                "places beyond a side, far off or nowhere that are taken to be on the grid, and places on a side that "
                "are not",
                {{}, 0.0}, Origin::identity, "points that leave the grid have to be found, and those on a wall kept"),
       "comparisons with the grid's sides", [subject] { return plain(subject->larger_of_both(misplaced)); }}};
}

}  // namespace plumbline
