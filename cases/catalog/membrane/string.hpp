// Strings of membrane points, on a line or in the plane, and what their cases have in common.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "cases/harness/description/case.hpp"
#include "cases/harness/description/measures.hpp"
#include "cases/harness/description/settings.hpp"
#include "kernel/ledger.hpp"
#include "kernel/points/body.hpp"
#include "kernel/simulation.hpp"

namespace plumbline {

// How the points of a string know their strain; the key `strain` of every membrane case.
//   segments     stretch of the segments between points, SegmentMembrane: what `default` takes
//   accumulated  t . e . t summed over time at each point [York 5.2, 5.3], UniaxialMembrane: York's
Key strain_key();
// What york1997 sets of it.
inline Override york_strain() { return {"strain", "accumulated"}; }

struct StringMaterial {
  double youngs_modulus = 0;  // E, Pa, > 0
  double area = 0;            // A, m^2, > 0
  double density = 0;         // rho, kg/m^3, > 0
  bool one_way = true;        // no stress under compression
};

// One string, from its first point to its last. n >= 2 points have n - 1 segments.
struct StringState {
  std::vector<std::array<double, 2>> place;  // of the points, m; on a line the first component counts
  std::vector<double> strain;                // of the points
  std::vector<double> segment_strain;        // of the segments
  std::vector<double> segment_length;        // m: those in which the string has the section A and the density rho
};

// n points evenly between two places, all with one strain; the section is that of the string as it stands.
StringState straight_string(std::array<double, 2> from, std::array<double, 2> to, int points, double strain = 0);

// What the end points carry: half a segment, so that mass and volume are exact, or as much as all others, as York's do.
enum class StringEnds { half, whole };

// The body, with the measure of strain that `strain` names. dim: 1 or 2.
// A point's volume is A times its share of the adjoining segments, its mass rho times that; stress E eps on these
// volumes is the tension E A eps on a string of that length. Rest lengths of segments follow from places and segment
// strains.
Body string_body(const std::string& name, const std::string& strain, const StringMaterial& material,
                 const StringState& state, int dim, StringEnds ends = StringEnds::half);

// Largest distance of a point from the straight line through the first and the last one, m. In the plane.
double misalignment(const Columns& points);
// Sum of the squared distances of all points from that line, m^2. In the plane.
double squared_distances_to_chord(const Columns& points);

// Distance between the first and the last point, m. In the plane.
double chord_length(const Columns& points);

// Segments of a string along `lengths` of the case's reference lengths, as cells and ppc say; four at least.
int segment_count(const Settings& settings, double lengths = 1);

// The levels of most strings, and their study with strain summed from rates.
inline const std::vector<double> string_levels{10, 14, 20, 28, 40};
StudyPlan accumulated_study(std::string why, std::vector<double> values);

// Case::york_step of a string that York did not run: the Courant number of his pendulum, for waves of `speed` (m/s) and
// cells of h = 1/cells m. [York A.4.5]
Override york_string_step(const Settings& settings, double speed);

// What a scheme that claims no conservation of energy gains or loses, as a share of the energies at play.
double energy_drift(const Account& energy);

// The energy drift of a run.
Measure drift_measure(const Simulation& simulation);

// A value for each column.
void add_row(Profile& profile, const std::vector<double>& row);

// Rows for a profile, at most `most` and a few, evenly over `count` samples.
std::vector<std::size_t> thinned_rows(std::size_t count, std::size_t most);
// A history of these samples: row(k) at the k-th, the first of `columns` is the abscissa.
Profile thinned_history(std::vector<ProfileColumn> columns, std::size_t count, std::size_t most,
                        const std::function<std::vector<double>(std::size_t)>& row);

}  // namespace plumbline
