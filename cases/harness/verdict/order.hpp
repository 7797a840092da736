// Observed order of accuracy: a straight line through ln E over ln h, with its 95 % confidence interval.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace plumbline {

// One level of a refinement study. All errors are absolute, in the unit of the measure.
struct Level {
  double h = 0;                       // what is refined: cell size, time step, ...; > 0, one unit on all levels
  double error = 0;                   // the measured error; > 0 and finite
  double rounding = 0;                // error level that rounding alone can reach; >= 0
  double reference_bound = 0;         // bound of the reference's own error; >= 0
  std::vector<double> offset_errors;  // for sub-cell offsets of the grid, `error` among them; may be empty
  std::string dropped;                // why the case, before the run, leaves the level out; empty: kept
};

enum class Weighting {
  equal,   // every level counts the same and `error` is fitted
  offsets  // weights 1/(s^2 + floor^2), and the mean of ln E over the offsets is fitted
};

// All lists run from coarse to fine. n is the number of levels used.
struct OrderFit {
  double order = 0;              // slope of ln E over ln h; NaN with fewer than two levels used
  double low = 0;                // 95 % confidence interval of the slope: Student's t with n - 2 degrees of freedom;
  double high = 0;               // (-inf, inf) with two levels, which say nothing about their own scatter
  double constant = 0;           // E = constant h^order
  bool asymptotic = false;       // see `asymptotic_order` and `asymptotic_plateau`
  std::vector<double> pairwise;  // n - 1: orders between neighbouring levels used
  std::vector<double> leave_one_out;       // n: the order without that level; empty below three levels
  std::vector<double> plateau;             // n: E/h^order
  std::vector<double> h;                   // every level, used or not
  std::vector<double> error;               // every level: the error fitted (with weights: exp of the mean of ln E)
  std::vector<bool> used;                  // every level
  std::vector<std::string> why_unused;     // every level; empty where used
  Weighting weighting = Weighting::equal;  // the weighting in fact applied
  std::string reason;                      // why there is no usable fit; empty if there is one
  bool usable = false;   // at least `least_levels` levels and a finite interval; otherwise inconclusive
  bool invalid = false;  // the data are not a study at all: empty, not finite, not positive, or a repeated h
};

inline constexpr std::size_t least_levels = 5;      // t(0.975) is 12.7 with three, 4.3 with four, 3.2 with five
inline constexpr std::size_t least_offsets = 4;     // offsets a level needs for its scatter to count
inline constexpr double rounding_factor = 10;       // a level within this factor of rounding does not enter,
inline constexpr double reference_share = 0.05;     // nor one whose reference bound is above this share of the error
inline constexpr double asymptotic_order = 0.15;    // most a pairwise order of the three finest is off the fit
inline constexpr double asymptotic_plateau = 0.15;  // largest over smallest E/h^order of the three finest, less 1

// Fits E = constant h^order to the levels, given in any order. Throws nothing: `invalid` or `reason` say
// what is wrong.
//
// Weights 1/(s^2 + floor^2): s is the sample standard deviation of ln E over the offsets of a level (not of
// their mean: the interval takes its scale from the residuals, so only ratios of weights matter), and
//   floor^2 = reference_share^2 + mean of s^2 over the levels used.
// The first part: a level may enter with a reference bound of that share of its error, so its ln E is not
// known better, however little the offsets scatter. The second: s^2 from four offsets has three degrees of
// freedom and is below a tenth of its mean once in twenty-five times; such a lucky level would decide the
// fit alone, and the interval would miss the true order in up to 10 % of studies instead of 5 % (the unit
// test counts). If any level the case keeps has fewer than `least_offsets` offsets, all weights are equal,
// and `weighting` says so.
//
// The interval covers scatter about a power law. A study whose finest levels stall has a *wide* interval
// and is not asymptotic; the interval cannot say what order finer levels would have shown.
OrderFit fit_order(std::span<const Level> levels, Weighting weighting);

}  // namespace plumbline
