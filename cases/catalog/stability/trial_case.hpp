// What cases whose numbers the laboratory finds have in common.
#pragma once

#include "cases/harness/judge/gates.hpp"

namespace plumbline {

// A measure without a reference of its own: gates say what it must be.
Measure finding(std::string name, double value, std::string unit = "1");

// What a trial measured: its error, or its value.
Number error_of(const std::string& measure);
Number value_of(const std::string& measure);

// Why what runs show must be near what is predicted; where runs tell growth from noise less well, within 2 %.
inline const std::string observed_limits =
    "observed limits within 1 % of the predicted ones, a tenth of the margin that cfl=auto leaves below a limit";
inline const std::string roughly_observed_limits =
    "observed limits within 2 % of the predicted ones, a fifth of the margin that cfl=auto leaves below a limit";

}  // namespace plumbline
