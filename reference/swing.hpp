#pragma once
// One integration of the elastic pendulum with a given step, in the units of elastic_pendulum.hpp.
#include <array>
#include <functional>
#include <memory>

#include "reference/bounded.hpp"

namespace plumbline::reference {

/// s, s', angle, angle': s the tension over m g, times in sqrt(L0/g).
using SwingState = std::array<double, 4>;

class Swing {
 public:
  /// kappa = k L0/(m g). `step` is the longest one taken.
  Swing(double kappa, bool one_way, SwingState start, double step);
  ~Swing();
  Swing(const Swing&) = delete;
  Swing& operator=(const Swing&) = delete;

  double time() const { return time_; }
  const SwingState& state() const { return state_; }
  double steps() const { return steps_; }
  bool taut() const { return taut_; }

  void advance_to(double time);
  /// On to where component `index` of the state next changes its sign, which it must have had since the last change.
  void advance_to_change(int index);

 private:
  struct Stepper;
  struct Plan {
    double step;
    bool changes_string;  // at its end: the string stops or begins to carry
    SwingState end;
  };
  SwingState after(double step) const;
  double root(int index, double low, double high, double sign) const;
  double until_change_of_string(double step, const SwingState& end) const;
  Plan plan(double longest) const;
  void take(const Plan& plan);

  std::unique_ptr<Stepper> stepper_;
  double step_, time_ = 0, steps_ = 0;
  bool one_way_, taut_;
  SwingState state_;
};

}  // namespace plumbline::reference
