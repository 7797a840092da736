#include "kernel/materials/material.hpp"

#include <cmath>

namespace plumbline {

void StepBounds::include(const StepBounds& other) {
  const auto take = [](double& mine, double theirs) {
    if (!std::isnan(mine) && !(theirs <= mine)) mine = theirs;
  };
  take(fastest, other.fastest);
  take(diffusivity, other.diffusivity);
}

double fastest_point(const Columns& points, PointRange range, int dim) {
  const double* velocity[3];
  for (int d = 0; d < dim; ++d) velocity[d] = points(column::velocity, d);
  double largest = 0;
  for (int p = range.first; p < range.last; ++p) {
    double square = 0;
    for (int d = 0; d < dim; ++d) square += velocity[d][p] * velocity[d][p];
    if (!std::isnan(largest) && !(square <= largest)) largest = square;
  }
  return std::sqrt(largest);
}

Material::Fault first_not_finite(const Columns& points, PointRange range, const ColumnId& id,
                                 const std::string& reason) {
  for (int k = 0; k < points.components(id); ++k) {
    const double* values = points(id, k);
    for (int p = range.first; p < range.last; ++p) {
      if (!std::isfinite(values[p])) return {p, id.name(), values[p], reason};
    }
  }
  return {};
}

}  // namespace plumbline
