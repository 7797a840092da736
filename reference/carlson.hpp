#pragma once
// Carlson's symmetric elliptic integrals by duplication [DLMF 19.26.18, 19.26.20], with bounds, and Legendre's
// integrals in their terms. Truncation: B. C. Carlson, Numer. Math. 33 (1979) 1.
#include "reference/bounded.hpp"

namespace plumbline::reference {

/// R_F(x, y, z) [DLMF 19.16.1]; true x, y, z >= 0, at most one of them zero, none below zero by its bound.
Bounded carlson_RF(Bounded x, Bounded y, Bounded z);

/// R_D(x, y, z) [DLMF 19.16.5]; x, y >= 0, not both zero, z > 0.
Bounded carlson_RD(Bounded x, Bounded y, Bounded z);

/// F = int dt/Delta and D = int sin^2 t/Delta dt from 0 to an angle in [0, pi/2], Delta^2 = 1 - m sin^2 t >= 0 there.
/// m may be above 1 as long as that holds.
struct LegendreFD {
  Bounded F, D;
};

/// From sine, cosine and Delta of the upper end: with Delta given, digits of m near 1/sin^2 are not lost.
LegendreFD legendre_FD(Bounded sine, Bounded cosine, Bounded delta);

/// Complete integrals, 0 to pi/2: K, D, and C = int sin^2 cos^2/Delta^3 = (2 D - K)/k^2 without its cancellation.
struct CompleteKDC {
  Bounded K, D, C;
};

/// From k^2 in [0, 1) and k' = sqrt(1 - k^2) > 0.
CompleteKDC complete_KDC(Bounded square, Bounded complement);

}  // namespace plumbline::reference
