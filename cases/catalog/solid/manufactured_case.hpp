// What the cases with manufactured solutions have in common beside the motion.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cases/catalog/solid/manufactured_problem.hpp"
#include "cases/harness/judge/gates.hpp"

namespace plumbline {

// York has no such case: four points a cell of the plane as in his solids, and the Courant number of the published
// studies.
constexpr double published_courant = 0.2;

// A body [0, length]^dim between mirrors, its points on a regular lattice.
std::unique_ptr<Problem> axis_aligned_run(const reference::AxisAlignedProblem& motion, double end_time,
                                          const Settings& settings);

// The key of Poisson's ratio.
Key poisson_key(double value);

// The order of displacement.worst in each of the studies: its estimate at least `order`, the low end of its interval
// 0.1 below.
std::vector<CaseGate> displacement_orders(const std::vector<std::string>& studies, double order,
                                          const std::string& reason, Tier tier = Tier::quick);
// displacement.worst over the largest norm of the exact displacement, at one level.
Number relative_error_at(double level);
// That no step raises the energy of the points: largest measure energy_rise of all runs of a study. Linear elasticity,
// midpoint step, no load.
CaseGate energy_monotone_gate(const std::string& study);
// The order that is required and that a scheme misses: as an expected failure with the band of its estimate.
// Fitted over these levels alone, so that each tier judges the same number.
CaseGate missed_order(const std::string& study, const std::vector<double>& levels, double order,
                      const std::string& cause, Range band);

}  // namespace plumbline
