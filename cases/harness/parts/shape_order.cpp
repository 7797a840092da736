// How fast a smooth function is approached, by its values on the nodes, as cells get smaller.
#include <cmath>

#include "cases/harness/parts/shape_gates.hpp"
#include "cases/harness/verdict/order.hpp"

namespace plumbline {
namespace {

constexpr int order_points = 500;
constexpr int levels[] = {4, 8, 16, 32, 64};  // cells along the first direction, of length 1
constexpr double within = 0.1;                // what of an order may be left to coarse meshes

double smooth(const Eigen::RowVectorXd& x) { return std::sin(2.1 * x[0] + 1.3 * x.tail(x.size() - 1).sum() + 0.4); }
double slope(const Eigen::RowVectorXd& x) {
  return 2.1 * std::cos(2.1 * x[0] + 1.3 * x.tail(x.size() - 1).sum() + 0.4);
}

GridSpec unit_box(std::size_t geometry, int cells) {
  GridSpec grid = probe_grid(geometry, false);
  grid.h = 1.0 / cells;
  grid.origin = {0, 0, 0};
  for (std::size_t d = 0; d < 3; ++d) grid.cells[d] = static_cast<int>(d) < grid.dim ? cells : 1;
  return grid;
}

// Points that fill the box evenly and fall anywhere in their cells: multiples of three irrational numbers.
std::vector<ProbePoint> evenly(const GridSpec& grid) {
  const double irrational[] = {std::sqrt(2.0), std::sqrt(3.0), std::sqrt(5.0)};
  std::vector<ProbePoint> points(order_points);
  for (std::size_t p = 0; p < points.size(); ++p) {
    for (std::size_t d = 0; d < static_cast<std::size_t>(grid.dim); ++d) {
      const double x = static_cast<double>(p + 1) * irrational[d];
      points[p].x[d] = x - std::floor(x);
    }
    points[p].half = grid.h / 4;
  }
  return points;
}

// Root mean square errors of the values and of the gradient along the first direction.
std::pair<double, double> errors(const ShapeSubject& subject, int cells) {
  const GridSpec grid = unit_box(subject.geometry, cells);
  const auto there = probe(*subject.entry, subject.geometry, grid);
  Eigen::MatrixXd u(there->nodes(), grid.dim);
  for (int i = 0; i < there->nodes(); ++i) u.row(i).setConstant(smooth(there->place(i)));
  const std::vector<ProbePoint> points = evenly(grid);
  const Interpolated found = there->interpolated(points, u);
  double values = 0, gradients = 0;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const Eigen::RowVectorXd x = Eigen::Map<const Eigen::RowVectorXd>(points[p].x.data(), grid.dim);
    const auto row = static_cast<Eigen::Index>(p);
    values += std::pow(found.value(row, 0) - smooth(x), 2);
    gradients += std::pow(found.gradient[0](row, 0) - slope(x), 2);
  }
  return {std::sqrt(values / order_points), std::sqrt(gradients / order_points)};
}

Measured order(const ShapeSubject& subject, bool of_gradient) {
  std::vector<Level> all;
  for (const int cells : levels) {
    const auto [values, gradients] = errors(subject, cells);
    Level level;
    level.h = 1.0 / cells;
    level.error = of_gradient ? gradients : values;
    all.push_back(level);
  }
  return measured_order(fit_order(all, Weighting::equal));
}

}  // namespace

std::vector<MeasuredGate> shape_order_gates(const SharedSubject& subject) {
  const std::string where = geometry_names()[subject->geometry];
  std::vector<MeasuredGate> all;
  for (const bool of_gradient : {false, true}) {
    const double least = (of_gradient ? 1 : 2) - within;
    MeasuredGate row{
        "order",
        gate_row("order", (of_gradient ? "gradient/" : "value/") + where,
                 std::string("order in h of the ") + (of_gradient ? "gradient" : "value") +
                     " of a smooth function, 4 to 64 cells",
                 {least, {}}, Origin::theory,
                 of_gradient ? "what reproduces linear fields has gradients of order 1; 0.1 for coarse meshes"
                             : "what reproduces linear fields is of order 2; 0.1 for coarse meshes"),
        "linear fields are not reproduced, or the reach grows with finer cells",
        [subject, of_gradient] { return order(*subject, of_gradient); }};
    row.gate.order = true;  // the interval of the fit is judged
    all.push_back(std::move(row));
  }
  return all;
}

}  // namespace plumbline
