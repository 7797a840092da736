// What the cases with manufactured solutions have in common beside the motion.
#pragma once

#include <string>
#include <vector>

#include "cases/catalog/solid/manufactured_problem.hpp"
#include "cases/harness/judge/gates.hpp"

namespace plumbline {

class ManufacturedCase : public Case {
 public:
  Kind kind() const override { return Kind::solid; }
  // York has no such case: four points a cell of the plane as in his solids, and the step of the published studies.
  std::vector<Override> points_and_end(const std::string& scheme) const override;
  void derive(Settings& settings, const std::string& scheme) const override;
  std::unique_ptr<Problem> problem(const Settings& settings) const override;

 protected:
  virtual ManufacturedSetup setup(const Settings& settings) const = 0;
};

// The key of Poisson's ratio.
Key poisson_key(double value);

// Points of the regular lattice that starts at `shape.low`, as ManufacturedSetup::body wants them.
struct SolidShape;
std::function<Body(std::shared_ptr<const Material>)> lattice_body(const SolidShape& shape, const ExactMotion& exact,
                                                                  int ppc, const GridSpec& grid);

// The order of displacement.worst: its estimate at least `order`, the low end of its interval 0.1 below.
std::vector<CaseGate> displacement_order(const std::string& study, double order, const std::string& reason,
                                         Tier tier = Tier::quick);
// The error at one level at most `most`.
CaseGate displacement_gate(const std::string& study, double level, double most, Origin origin,
                           const std::string& reason, Tier tier = Tier::quick);
// That no step raises the energy of the points: largest measure energy_rise of all runs of a study. Linear elasticity,
// midpoint step, no load.
CaseGate energy_monotone_gate(const std::string& study);
// The order that is required and that a scheme misses: as an expected failure with the band of its estimate.
// Fitted over these levels alone, so that each tier judges the same number.
CaseGate missed_order(const std::string& study, const std::vector<double>& levels, double order,
                      const std::string& cause, Range band);

}  // namespace plumbline
