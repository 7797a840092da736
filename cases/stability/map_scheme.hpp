// The choices of a problem as the reference's linear algebra knows them.
#pragma once

#include <optional>

#include "cases/harness/settings.hpp"
#include "reference/mpm_amplification.hpp"

namespace plumbline {

// Empty where the integrator, shape or transfer is none of the reference's, or points move.
std::optional<reference::MapScheme> map_scheme(const Settings& settings);

}  // namespace plumbline
