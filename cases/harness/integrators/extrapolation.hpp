// The limit of a vector as the step is halved again and again.
#pragma once

#include <vector>

namespace plumbline {

struct StepLimit {
  double size = 0;         // largest component of the limit, in magnitude
  double uncertainty = 0;  // of each component
  double finest = 0;       // largest component at the finest step, not extrapolated
  double before = 0;       // and two halvings before
  // Whether halving the step twice left more than half of what there was: nothing falls that could be extrapolated.
  bool stalls() const { return finest > 0.5 * before; }
};

// values[k] belongs to dt / 2^k; at least three. Neville's table for powers of dt, component by component: of its last row the
// entry that differs least from the one a step size before, and by how much. What depends on dt smoothly loses one power of
// dt a column; what does not stays in the first columns, with its own scatter as uncertainty.
StepLimit limit_of_halvings(const std::vector<std::vector<double>>& values);

}  // namespace plumbline
