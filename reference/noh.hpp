#pragma once
// Noh's problem: cold gas streams at one speed towards a wall, an axis or a centre and is brought to rest by a shock
// that runs outwards. Source: W. F. Noh, J. Comput. Phys. 72 (1987) 78, doi 10.1016/0021-9991(87)90074-X.
#include "reference/gas_flow.hpp"

namespace plumbline::reference {

/// Any consistent units. `velocity` is the speed of approach.
struct NohProblem {
  int dimension = 3;  // 1: wall, 2: axis, 3: centre
  double gamma = 5.0 / 3;
  double density = 1;   // of the gas at t = 0
  double velocity = 1;  // > 0
};

class Noh {
 public:
  /// Throws ParameterError unless dimension is 1, 2 or 3, gamma > 1 and the rest > 0.
  explicit Noh(const NohProblem& problem);

  const NohProblem& problem() const { return problem_; }
  Bounded shock_speed() const { return shock_speed_; }
  Bounded shock_radius(double time) const;   // time >= 0
  Sample behind() const { return behind_; }  // the gas at rest
  /// The gas that still streams in; its velocity is negative, its pressure zero. radius > 0 or time = 0.
  Sample ahead(double radius, double time) const;
  /// radius, time >= 0; at the shock the value ahead of it.
  Sample sample(double radius, double time) const;

 private:
  NohProblem problem_;
  Bounded shock_speed_;
  Sample behind_;
};

}  // namespace plumbline::reference
