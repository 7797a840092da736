#pragma once
// Natural frequencies that interlace with known poles: between two neighbouring poles there is one root and no other.
#include <functional>
#include <vector>

#include "reference/bounded.hpp"

namespace plumbline::reference {

/// The one root of f in [below, above], where f is negative below the root and positive above it; what f does outside
/// does not matter. `slope` is f' (it need only be roughly right). The two ends may have bounds of their own; where
/// they cannot be told apart the answer covers both. Throws std::runtime_error if f stops being finite.
Bounded root_between(const std::function<Bounded(double)>& f, const std::function<double(double)>& slope, Bounded below,
                     Bounded above);

/// The `count` smallest of the numbers k first, k second (k = 1, 2, ...) in order; one that is a multiple of both comes
/// twice. Both positive; `second` may be infinite.
std::vector<Bounded> merged_multiples(Bounded first, Bounded second, int count);

}  // namespace plumbline::reference
