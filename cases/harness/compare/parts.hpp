// The parts of a comparison: each adds a finding for everything that either snapshot has.
#pragma once

#include <limits>
#include <vector>

#include "cases/harness/compare/finding.hpp"
#include "cases/harness/compare/snapshot.hpp"

namespace plumbline {

// Equal but for rounding: sums over 1e7 points round to 3e-13, errors are some 1e-3 of what is summed.
inline constexpr double equal_share = 1e-9;
// Errors and constants are deterministic; below this share they count as the same. Regression gates allow 2 % for drift,
// a fifth of what shifting the grid below a cell may do: half of that is seen here before a gate could turn red.
inline constexpr double error_share = 0.01;
// Errors nearer to each other than this share of the reference's size differ by rounding: the bound of the generic
// gates.
inline constexpr double rounding_share = 1e-12;
// Orders: half of the 0.1 that an order gate leaves between the bounds of estimate and interval.
inline constexpr double order_difference = 0.05;
// A predicted limit is where a spectral radius passes 1 + 1e-6, found from finite differences: rounding moves it by some
// 1e-6 of itself, and nobody sets a step to more than four digits.
inline constexpr double limit_share = 1e-4;
// Wall times of the same program vary by some percent from build to build as its code moves in memory.
inline constexpr double cost_share = 0.10;
// Instruction counts repeat to 1e-4; inlining moves them by a percent.
inline constexpr double instruction_share = 0.02;
// Of a range or an interval whose upper end a record does not give.
inline constexpr double unbounded = std::numeric_limits<double>::infinity();

// A gate as the quantity of its findings: "cells/order (quick)".
std::string gate_words(const GateRecord& gate);

// Verdicts by severity; bounds by `shift`.
void compare_gates(const Snapshot& before, const Snapshot& after, std::vector<Finding>& findings);

// Orders: the slope of ln(E_after/E_before) over ln h on the levels that both fits use, with its 95 % interval by
// Student's t. Both studies share meshes and problem, so what is off a power law in both cancels; the difference of
// the two stated orders would call it noise. Fewer than three such levels: Welch's test of the stated orders. A
// difference counts beyond `order_difference`; then an interval that excludes zero makes it better or worse, one that
// does not INCONCLUSIVE. Constants: the mean of ln(E_after/E_before), so both at the same order, only where that is the
// same. Errors: at the finest common level. Runs that stop where they did not are worse.
void compare_studies(const Snapshot& before, const Snapshot& after, std::vector<Finding>& findings);

// The end of the first stable interval of steps, and all of them together: predicted to `limit_share`, observed by
// whether the brackets overlap.
void compare_limits(const Snapshot& before, const Snapshot& after, std::vector<Finding>& findings);

// By study: the levels that both have timed often enough, added up sample by sample, and their ratio
// (two_samples.hpp); worse where the whole interval is beyond `cost_share`, INCONCLUSIVE where it reaches beyond.
// Instruction counts, where both have them, decide unless times are surely worse, and the finding is then of them. Not
// comparable between different machines, compilers or flags: one finding says so.
void compare_costs(const Snapshot& before, const Snapshot& after, std::vector<Finding>& findings);

}  // namespace plumbline
