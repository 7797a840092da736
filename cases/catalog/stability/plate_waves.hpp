// Limits of the step for waves in a plate on a lattice of points, by waves alone: units c = h = rho = 1, c the speed of
// pressure waves, `ppc` points a cell and direction at the same place of their shares, FLIP or PIC, positions held.
#pragma once

#include "reference/mpm_amplification.hpp"

namespace plumbline {

struct PlateLattice {
  int ppc = 1;
  double place_x = 0.5, place_y = 0.5;  // (0, 1)
};

// One node a cell carries each wave. With the lattice's factors along x and y, sums over the points of a cell,
//   B = sum m |S|^2, K = sum V |G|^2, R = sum V conj(G) S,
// the stiffness of pressure and shear waves together is the matrix
//   [K_x B_y + k B_x K_y, l c + k conj(c); ..., k K_x B_y + B_x K_y], c = R_x conj(R_y),
//   k = (1 - 2 nu)/(2 - 2 nu), l = 1 - 2 k,                                             [Plate 1]
// and 1/C^2 the largest of its eigenvalue times the scheme's weight of B_x B_y [Stability 5] over all waves.
double plate_limit(const reference::MapScheme& scheme, const PlateLattice& lattice, double nu);

// The same of a scalar wave, of the stiffness K_x B_y + B_x K_y. waves > 0: only those that a periodic patch of so many cells
// a side carries.
double scalar_plate_limit(const reference::MapScheme& scheme, const PlateLattice& lattice, int waves = 0);

}  // namespace plumbline
