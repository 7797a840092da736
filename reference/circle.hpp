#pragma once
#include "reference/bounded.hpp"

namespace plumbline::reference {

/// The circle constant, with the error of its nearest double.
inline constexpr Bounded pi{3.141592653589793116, 1.3e-16};

}  // namespace plumbline::reference
