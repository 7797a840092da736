// Gas that only expands: no point of it may ever be hotter than it was at the start.
#pragma once

#include <memory>
#include <vector>

#include "cases/catalog/gas/gas_problem.hpp"

namespace plumbline {

class ExpansionWatch {
 public:
  void start(const Body& body);                // remembers e_p(0) by the points' numbers
  void observe(const Simulation& simulation);  // after each step
  void history(Archive& archive);

  // e_p(0) of a point that came by splitting: that of the point it was part of.
  // energy_ratio: largest e_p(t)/e_p(0) of all points after all steps.
  // energy_rise: largest e_p(t) - e_p(0) of all points after all steps, over the largest e_p(0). Zero or less where
  //   nothing was ever heated.
  std::vector<Measure> measures() const;

 private:
  std::vector<double> start_;  // e_p(0), by number
  double hottest_ = 0;
  double ratio_ = 0, rise_ = -HUGE_VAL;
};

// Lets the watch see the flow's points: call it last, when `fill` is set.
std::shared_ptr<ExpansionWatch> watch_expansion(GasFlow& flow);

// entropy.L1: mass-weighted mean of |p rho^-gamma/K - 1|, where K is the gas's own at t = 0.
Measure entropy_error(const std::vector<GasSample>& points, double gamma, double constant);

// No point's internal energy above its initial value, at one level.
CaseGate no_heating_gate(const std::string& study, double level, Tier tier = Tier::quick);

}  // namespace plumbline
