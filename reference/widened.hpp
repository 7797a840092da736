#pragma once
// What a formula leaves out, added to the bound of what it gives.
#include <cmath>

#include "reference/bounded.hpp"

namespace plumbline::reference {

/// x, its bound larger by |by|.
inline Bounded widened(Bounded x, double by) { return {x.value, (x.bound + std::abs(by)) * rounding::inflate}; }

}  // namespace plumbline::reference
