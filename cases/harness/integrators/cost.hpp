// Errors against what they cost, of two integrators on the same refinements, timed in turns.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cases/harness/integrators/subject.hpp"

namespace plumbline {

// One mesh: its error, and the seconds of each repetition.
struct CostLevel {
  double cells = 0, error = 0;
  long particle_steps = 0;
  std::vector<double> wall_s = {};
};

struct CostCurve {
  std::string case_name, measure;
  std::vector<CostLevel> levels = {};  // from coarse to fine
  std::string note = {};               // why there is none
};

// How many times as much the first costs as the second at equal error, with the least and the most of any pair of
// repetitions; or why it cannot be told.
struct CostFactor {
  std::string case_name;
  std::optional<double> factor = {};
  double low = 0, high = 0;
  std::string note = {};
};

// Smooth solids and gases, jumps, a membrane: the default schemes with each integrator, or FLIP where it needs that. Every
// repetition runs all integrators, one after the other, on one thread.
std::vector<std::vector<CostCurve>> cost_curves(const std::vector<const Subject*>& subjects);

// By interpolating ln seconds over ln error where both have errors.
CostFactor cost_factor(const CostCurve& mine, const CostCurve& other);

// The median of the factors, of their lows and of their highs; none without any.
std::optional<CostFactor> median_of(const std::vector<CostFactor>& factors);

}  // namespace plumbline
