// Elastic constants and what is common to elastic materials.
#pragma once

namespace plumbline {

// Lame's constants of Young's modulus E (Pa, > 0) and Poisson's ratio nu (-1 < nu < 1/2).
struct LameConstants {
  double lambda, mu;  // Pa
};
inline LameConstants lame_constants(double youngs_modulus, double poissons_ratio) {
  const double e = youngs_modulus, nu = poissons_ratio;
  return {e * nu / ((1 + nu) * (1 - 2 * nu)), e / (2 * (1 + nu))};
}

}  // namespace plumbline
