// Elastic constants and what is common to elastic materials.
#pragma once

#include <algorithm>

#include "kernel/points/column_names.hpp"
#include "kernel/points/columns.hpp"

namespace plumbline {

// Lame's constants of Young's modulus E (Pa, > 0) and Poisson's ratio nu (-1 < nu < 1/2).
struct LameConstants {
  double lambda, mu;  // Pa
};
inline LameConstants lame_constants(double youngs_modulus, double poissons_ratio) {
  const double e = youngs_modulus, nu = poissons_ratio;
  return {e * nu / ((1 + nu) * (1 - 2 * nu)), e / (2 * (1 + nu))};
}

// Adds the deformation gradient, with as many components as the stress has, and sets F = 1.
inline void add_deformation(Columns& points, int dim) {
  const int components = points.components(column::stress);
  points.add(column::deformation, components);
  for (int k = 0; k < components; ++k) {
    const bool diagonal = k == dim * dim || k % (dim + 1) == 0;
    if (diagonal) std::fill_n(points(column::deformation, k), points.points(), 1.0);
  }
}

}  // namespace plumbline
