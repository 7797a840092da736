// How wide the band of an expected failure may be: as narrow as a number that roundings do not move, or as wide as a stored
// ensemble of runs shows that they move it.
#pragma once

#include <string>
#include <vector>

#include "cases/harness/compare/tolerances.hpp"

namespace plumbline {

inline constexpr double widest_band = 1.35;       // high over low
inline constexpr double widest_order_band = 0.2;  // of an order: high minus low

// Runs that differ by 1e-15 to 1e-14 of one parameter, made by ci/ensembles.
struct Ensemble {
  struct Stopped {
    long step = 0;
    std::string field;
  };
  std::string case_name, study, id;  // of the gate
  std::vector<double> values;        // of the runs that arrived
  std::vector<Stopped> stopped;
};

inline constexpr std::size_t least_members = 16;

// The range of the values, widened by half its width to either side. Of seventeen members of one distribution the next lies
// outside their range once in nine times; how rarely outside the widened one depends on the distribution. Half is a choice.
Range widened(const Ensemble& ensemble);

// FileError for a file that is not there or holds no ensembles.
std::vector<Ensemble> read_ensembles(const std::string& file);

// Why the band of a gate's expected failure is too wide; empty if it is not, or if there is none.
std::string too_wide(const Gate& gate, const Ensemble* ensemble);

// All gates of the cases whose bands are too wide, and ensembles of no gate.
std::vector<Discrepancy> wide_bands(const std::vector<const Case*>& entries, const std::vector<Ensemble>& ensembles);

}  // namespace plumbline
