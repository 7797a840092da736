// Sod's tube as York ran it: of one table for all cases that are this flow in another setting.
#pragma once

#include "cases/catalog/gas/shock_tube.hpp"

namespace plumbline {

inline const ShockTube sod_tube{{{1.0, 0.0, 1.0}, {0.125, 0.0, 0.1}, 1.4}, 0.0, 1.0, 0.5, 0.143};  // [York 4.1]

}  // namespace plumbline
