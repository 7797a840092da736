#include "kernel/materials/material.hpp"

#include <cmath>

#include "kernel/largest.hpp"

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
  Largest square;
  for_packs(
      range.first, range.last, [&](int p, int count) __attribute__((always_inline)) {
        Pack sum = 0.0;
        for (int d = 0; d < dim; ++d) sum += load(velocity[d] + p) * load(velocity[d] + p);
        square.include(sum, count);
      });
  return std::sqrt(square.value());
}

Material::Fault first_not_finite(const Columns& points, PointRange range, const ColumnId& id, const char* reason) {
  for (int k = 0; k < points.components(id); ++k) {
    const double* values = points(id, k);
    for (int p = range.first; p < range.last; ++p) {
      if (!std::isfinite(values[p])) return {p, id.name(), values[p], reason};
    }
  }
  return {};
}

}  // namespace plumbline
