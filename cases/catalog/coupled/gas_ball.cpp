#include "cases/catalog/coupled/gas_ball.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace plumbline {
namespace {

struct Part {
  double volume = 0;
  std::array<double, 3> moment{};  // m^4
};

// Of a cube inside a ball about the origin: columns along z, each as far as it is inside.
Part part_inside(const std::array<double, 3>& low, double side, double radius) {
  constexpr int columns = 24;  // each way: the volume of a cut cell is good to a thousandth of a cell
  Part part;
  const double width = side / columns;
  for (int i = 0; i < columns; ++i) {
    for (int j = 0; j < columns; ++j) {
      const double x = low[0] + (i + 0.5) * width, y = low[1] + (j + 0.5) * width;
      const double square = radius * radius - x * x - y * y;
      if (square <= 0) continue;
      const double top = std::min(low[2] + side, std::sqrt(square)), bottom = std::max(low[2], -std::sqrt(square));
      if (top <= bottom) continue;
      const double volume = width * width * (top - bottom);
      part.volume += volume;
      part.moment[0] += volume * x;
      part.moment[1] += volume * y;
      part.moment[2] += volume * 0.5 * (top + bottom);
    }
  }
  return part;
}

}  // namespace

Body fill_ball(const std::string& name, std::shared_ptr<const IdealGas> gas, const GridSpec& grid, int ppc,
               double radius, double density, double energy) {
  const double side = grid.h / std::cbrt(static_cast<double>(ppc));
  // The lattice is the grid's, so that a moved grid moves it.
  std::array<int, 3> first{}, last{};
  for (std::size_t d = 0; d < 3; ++d) {
    first[d] = static_cast<int>(std::floor((-radius - grid.origin[d]) / side));
    last[d] = static_cast<int>(std::ceil((radius - grid.origin[d]) / side));
  }
  std::vector<Part> parts;
  double sum = 0;
  for (int k = first[2]; k < last[2]; ++k) {
    for (int j = first[1]; j < last[1]; ++j) {
      for (int i = first[0]; i < last[0]; ++i) {
        const std::array<double, 3> low{grid.origin[0] + i * side, grid.origin[1] + j * side,
                                        grid.origin[2] + k * side};
        const Part part = part_inside(low, side, radius);
        if (!(part.volume > 1e-6 * side * side * side)) continue;  // a corner, as small as columns can tell
        parts.push_back(part);
        sum += part.volume;
      }
    }
  }
  // What columns are wrong by, a share of some 1e-5, is spread over all.
  const double scale = 4.0 / 3.0 * std::numbers::pi * radius * radius * radius / sum;
  Body body = make_body(name, std::move(gas), static_cast<int>(parts.size()), 3);
  for (std::size_t p = 0; p < parts.size(); ++p) {
    for (int d = 0; d < 3; ++d)
      body.points(column::position, d)[p] = parts[p].moment[static_cast<std::size_t>(d)] / parts[p].volume;
    body.points(column::volume)[p] = scale * parts[p].volume;
    body.points(column::mass)[p] = density * scale * parts[p].volume;
    body.points(column::density)[p] = density;
    body.points(column::energy)[p] = energy;
  }
  return body;
}

}  // namespace plumbline
