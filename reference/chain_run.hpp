#pragma once
// One integration of a chain of bars, in the units of its rest length L, sqrt(L/g) and m g; see bar_chain.hpp.
#include <memory>
#include <vector>

namespace plumbline::reference {

/// Start: all nodes on a straight line from the support, the end at (end_x, end_y) from it.
struct ChainSettings {
  int elements = 8;
  double stiffness = 0;   // kappa = E A/(m g)
  double mass_ratio = 0;  // string over end
  bool one_way = false;
  double end_x = 0, end_y = -1;
  double tolerance = 1e-9;
};

class ChainRun {
 public:
  explicit ChainRun(const ChainSettings& settings);
  ~ChainRun();
  ChainRun(const ChainRun&) = delete;
  ChainRun& operator=(const ChainRun&) = delete;

  double time() const { return time_; }
  void advance_to(double time);
  /// On to the next change of sign of the end's angular momentum (swing) or vertical velocity. Throws
  /// std::runtime_error if there is none for a long time.
  void advance_to_turn(bool swing);

  // x, y, velocity of the end
  double x() const;
  double y() const;
  double velocity_x() const;
  double velocity_y() const;
  double support_tension() const;
  double kinetic() const;
  double elastic() const;
  double potential() const;  // zero where all masses stand at the support's height

 private:
  struct System;
  double turning(bool swing) const;  // what changes its sign

  std::unique_ptr<System> system_;
  double time_ = 0, step_ = 0;
  std::vector<double> state_;  // x, y of each node below the support, then their velocities
};

}  // namespace plumbline::reference
