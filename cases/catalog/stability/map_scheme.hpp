// The choices of a problem as the reference's linear algebra knows them.
#pragma once

#include <optional>
#include <string>

#include "cases/harness/description/settings.hpp"
#include "reference/mpm_amplification.hpp"

namespace plumbline {

// Which of the reference's updates of stresses an integrator is; empty: none of them.
std::optional<reference::StressUpdate> stress_update(const std::string& integrator);

// Empty where the integrator, shape or transfer is none of the reference's, or points move.
std::optional<reference::MapScheme> map_scheme(const Settings& settings);

}  // namespace plumbline
