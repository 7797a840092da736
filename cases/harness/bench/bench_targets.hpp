// Figures of speed that are wanted.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cases/harness/results/documents.hpp"

namespace plumbline {

inline Json or_null(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

// An entry of "targets"; one that is missed is shown as missed.
Json target_entry(const std::string& name, const std::string& unit, double measured, std::optional<double> low,
                  std::optional<double> high);

// Largest over smallest cost of a particle-step among sizes from 1e4 to 1e7 points; one entry per
// number of threads. `kernels`: entries of part scale.
std::vector<Json> scale_targets(const Json& kernels);

}  // namespace plumbline
