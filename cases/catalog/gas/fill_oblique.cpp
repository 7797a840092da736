#include "cases/catalog/gas/fill_oblique.hpp"

#include <algorithm>
#include <cmath>

namespace plumbline {
namespace {

// The grid's box as seen along n, widened to whole cells about the centre.
GasBox turned_box(const ObliqueGas& oblique, const GridSpec& grid) {
  double reach = 0;  // of the corners, m
  for (const int i : {0, 1}) {
    for (const int j : {0, 1}) {
      const double x = grid.origin[0] + i * grid.h * grid.cells[0] - oblique.centre[0];
      const double y = grid.origin[1] + j * grid.h * grid.cells[1] - oblique.centre[1];
      reach = std::max(reach, std::hypot(x, y));
    }
  }
  const double half = grid.h * std::ceil(reach / grid.h);
  GasBox box;
  box.low = {-half, -half, 0};
  box.high = {half, half, 0};
  box.jumps = oblique.jumps;
  box.state = [&oblique](const Position& at) {
    const reference::GasState state = oblique.initial(at[0]);
    return GasAt{state.density, {state.velocity, 0, 0}, state.pressure};
  };
  return box;
}

}  // namespace

Body fill_oblique(std::shared_ptr<const IdealGas> gas, const ObliqueGas& oblique, const PointRule& rule,
                  const GridSpec& grid) {
  const Body turned = fill_gas(gas, turned_box(oblique, grid), rule, grid);
  const double c = std::cos(oblique.angle), s = std::sin(oblique.angle);
  const auto turn = [&](const ColumnId& id, int p) {
    const double along = turned.points(id, 0)[p], across = turned.points(id, 1)[p];
    return std::array<double, 2>{c * along - s * across, s * along + c * across};
  };
  std::vector<int> inside;
  for (int p = 0; p < turned.points.points(); ++p) {
    const auto at = turn(column::position, p);
    bool in = true;
    for (std::size_t d = 0; d < 2; ++d) {
      const double x = at[d] + oblique.centre[d] - grid.origin[d];
      in = in && x > 0 && x < grid.h * grid.cells[d];
    }
    if (in) inside.push_back(p);
  }
  Body body = make_body("gas", std::move(gas), static_cast<int>(inside.size()), grid.dim);
  for (int k = 0; k < body.points.points(); ++k) {
    const int p = inside[static_cast<std::size_t>(k)];
    const auto at = turn(column::position, p), v = turn(column::velocity, p);
    for (std::size_t d = 0; d < 2; ++d) {
      body.points(column::position, static_cast<int>(d))[k] = at[d] + oblique.centre[d];
      body.points(column::velocity, static_cast<int>(d))[k] = v[d];
    }
    for (const ColumnId* id : {&column::volume, &column::mass, &column::density, &column::energy, &column::pressure}) {
      body.points(*id)[k] = turned.points(*id)[p];
    }
  }
  return body;
}

}  // namespace plumbline
