#include "cases/harness/description/fill_solid.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include "cases/harness/files/whole.hpp"

namespace plumbline {

Body fill_solid(std::string name, std::shared_ptr<const Material> material, const SolidShape& shape, double density,
                int ppc, const GridSpec& grid) {
  const double spacing = grid.h / ppc;
  std::array<int, 3> count{1, 1, 1};
  for (std::size_t d = 0; d < static_cast<std::size_t>(grid.dim); ++d) {
    count[d] = whole(std::round(std::ceil((shape.high[d] - shape.low[d]) / spacing - 1e-6)));
  }
  std::vector<std::array<double, 3>> places;
  for (int k = 0; k < count[2]; ++k) {
    for (int j = 0; j < count[1]; ++j) {
      for (int i = 0; i < count[0]; ++i) {
        const std::array<int, 3> index{i, j, k};
        std::array<double, 3> x{};
        for (std::size_t d = 0; d < static_cast<std::size_t>(grid.dim); ++d) {
          x[d] = shape.low[d] + (index[d] + 0.5) * spacing;
        }
        if (!shape.inside || shape.inside(x)) places.push_back(x);
      }
    }
  }
  if (places.empty()) throw std::invalid_argument("body " + name + " is smaller than a point");
  const double cube = std::pow(spacing, grid.dim);
  Body body = make_body(std::move(name), std::move(material), static_cast<int>(places.size()), grid.dim,
                        grid.axisymmetric);
  body.spacing = spacing;
  for (int p = 0; p < body.points.points(); ++p) {
    const auto& x = places[static_cast<std::size_t>(p)];
    for (int d = 0; d < grid.dim; ++d) body.points(column::position, d)[p] = x[static_cast<std::size_t>(d)];
    const double volume = cube * (grid.axisymmetric ? x[0] : 1.0);
    body.points(column::volume)[p] = volume;
    body.points(column::mass)[p] = density * volume;
  }
  return body;
}

}  // namespace plumbline
