#include "cases/harness/integrators/measured_limit.hpp"

#include <algorithm>

#include "cases/harness/integrators/extrapolation.hpp"

namespace plumbline {

Measured measured_limit(const Halvings& halvings, const std::function<std::vector<double>(int steps)>& values_at) {
  constexpr double certain = 3;
  std::vector<std::vector<double>> values;
  Measured measured;
  for (int k = 0, steps = halvings.steps; k < halvings.most; ++k, steps *= 2) {
    values.push_back(values_at(steps));
    if (k + 1 < halvings.least) continue;
    const StepLimit limit = limit_of_halvings(values);
    const double off = certain * limit.uncertainty;
    measured.value = limit.size;
    measured.interval = {std::max(0.0, limit.size - off), limit.size + off};
    if (limit.size + off <= halvings.bound || limit.size - off > halvings.bound) return measured;
    if (k + 1 < halvings.most) continue;
    measured.note = "the extrapolation is not certain enough";
    if (!limit.stalls()) continue;
    measured.value = limit.finest;
    measured.interval = {limit.finest, limit.finest};
    measured.note = "does not fall with the step";
  }
  return measured;
}

}  // namespace plumbline
