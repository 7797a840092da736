#pragma once
// The complete elliptic integral of the first kind: GSL's value, with a bound certified by Gauss's mean,
// K = pi/(2 M(1, k')), k'^2 = 1 - k^2 [DLMF 19.8.5].
#include "reference/bounded.hpp"

namespace plumbline::reference {

/// Gauss's arithmetic-geometric mean of two positive numbers.
Bounded gauss_mean(Bounded a, Bounded b);

/// K(k) for 0 <= k < 1. It takes the complementary modulus k' > 0 as well, which loses its digits in k near 1.
Bounded elliptic_K(Bounded k, Bounded complement);

}  // namespace plumbline::reference
