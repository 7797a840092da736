// What one pass of a transfer takes from standing waves between two walls, on two points a cell.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "cases/harness/parts/parts.hpp"
#include "cases/harness/parts/shape_probe.hpp"
#include "cases/harness/parts/transfer_gates.hpp"
#include "cases/harness/parts/transfer_probe.hpp"
#include "cases/harness/verdict/order.hpp"

namespace plumbline {
namespace {

constexpr int line_cells = 64;
constexpr double order_margin = 0.2;  // what of an order may be left to short waves

// Share of a wave with `halves` half waves between the walls that is left after one pass.
double left_over(const TransferEntry& transfer, const ShapeEntry& shape, int halves) {
  Scene scene;
  scene.grid.cells = {line_cells, 1, 1};
  scene.grid.walls[0] = {Wall::symmetry, Wall::symmetry};
  scene.shape = shape.name;
  scene.transfer = transfer.name;
  const double k = std::numbers::pi * halves / line_cells;
  std::vector<Eigen::VectorXd> places;
  for (int p = 0; p < 2 * line_cells; ++p) places.push_back(Eigen::VectorXd::Constant(1, 0.25 + 0.5 * p));
  TransferProbe probe(scene, places, std::vector<double>(places.size(), 0.5), [&](const Eigen::VectorXd& x) {
    return PointMotion{Eigen::VectorXd::Constant(1, std::sin(k * x[0])),
                       Eigen::MatrixXd::Constant(1, 1, k * std::cos(k * x[0]))};
  });
  const Eigen::VectorXd before = probe.velocities().col(0);
  probe.pass(0.01, false);
  return before.dot(probe.velocities().col(0)) / before.squaredNorm();
}

// The order in k h with which what is taken vanishes, from waves of 16 to 64 cells.
Measured order(const TransferEntry& transfer, const ShapeEntry& shape) {
  std::vector<Level> waves;
  for (const int halves : {8, 6, 5, 4, 3, 2}) {
    Level level;
    level.h = halves;
    level.error = std::abs(1 - left_over(transfer, shape, halves));
    level.rounding = rounding_of_parts / 100;
    waves.push_back(level);
  }
  return measured_order(fit_order(waves, Weighting::equal));
}

// By how much what is left of a wave is beyond 0 and 1: the most, of waves of 64 to 2 cells.
Measured beyond_all_and_nothing(const TransferEntry& transfer, const ShapeEntry& shape) {
  double worst = -1;
  for (int halves = 2; halves <= line_cells; halves += 2) {
    const double left = left_over(transfer, shape, halves);
    const double beyond = std::max(left - 1, -left);
    if (!(beyond <= worst)) worst = beyond;
  }
  const double eight = left_over(transfer, shape, line_cells / 4);
  return plain(worst,
               fmt::format("of a wave of 8 cells a pass leaves {:.6f}, two, in which sound crosses a cell at half "
                           "the Courant limit, {:.6f}",
                           eight, eight * eight));
}

// Two maps smooth twice, k^2 h^2; the affine part takes the leading term back where D_p is the same everywhere, and m passes to
// the grid and back leave the m-th power.
double order_of_filter(const TransferEntry& transfer, const ShapeEntry& shape) {
  if (transfer.has_order) return 2.0 * Scene().transfer_order;
  return transfer.does.affine && shape.offers.count(Trait::constant_inertia) > 0 ? 4 : 2;
}

}  // namespace

std::vector<MeasuredGate> transfer_filter_gates(const TransferEntry& transfer, const ShapeEntry& shape) {
  std::vector<MeasuredGate> all{
      {"filter",
       gate_row("filter", "range/line",
                "how far what a pass leaves of a wave is below 0 or above 1, of waves of 64 to 2 cells",
                {{}, rounding_of_parts}, Origin::theory,
                "a filter takes from each wave between nothing and all; rounding"),
       "a filter that overshoots", [&] { return beyond_all_and_nothing(transfer, shape); }}};
  if (transfer.offers.count(Trait::unfiltered_velocities) > 0) return all;
  const double claimed = order_of_filter(transfer, shape);
  MeasuredGate row{
      "filter",
      gate_row("filter", "order/line",
               "order in k h with which what a pass takes of a wave vanishes, of waves of 16 to 64 cells",
               {claimed - order_margin, {}}, Origin::theory,
               fmt::format("{:g} of this kind of transfer: long waves are left alone; 0.2 for short ones", claimed)),
      "a term of the filter lacks a factor", [&] { return order(transfer, shape); }};
  row.gate.order = true;  // the interval of the fit is judged
  all.push_back(std::move(row));
  return all;
}

}  // namespace plumbline
