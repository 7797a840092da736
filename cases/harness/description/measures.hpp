// What a run is judged by: errors against a reference, and the columns a report draws.
#pragma once

#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace plumbline {

// The larger and the smaller of two numbers; a NaN wins, whichever of the two it is. std::max and a comparison with the
// largest so far both lose it.
inline double larger(double a, double b) { return a > b || std::isnan(a) ? a : b; }
inline double smaller(double a, double b) { return a < b || std::isnan(a) ? a : b; }

// One measured quantity. A field norm has error and scale (the same norm of the reference); a scalar also value and
// reference. All in `unit`.
struct Measure {
  std::string name;  // "density.L1", "period"
  double error = 0;  // >= 0
  double scale = 0;  // norm of the reference: relative_error = error / scale
  std::optional<double> value, reference;
  double reference_bound = 0;  // bound of what the reference's own error adds to `error`
  std::string unit = "1";
};

// A scalar against its reference.
Measure scalar_measure(std::string name, double value, double reference, double bound, std::string unit);
// A share or ratio, of scale and unit 1.
Measure share_measure(std::string name, double value, double reference = 0, double bound = 0);

// One point's share in field norms.
struct FieldSample {
  double volume;  // V_p, > 0
  double position;
  double computed, exact, bound;  // bound: of `exact`
};

// name.L1 = sum V |e| / sum V, name.L2 with squares under a root, name.Linf.
std::vector<Measure> field_norms(const std::string& name, const std::string& unit,
                                 std::span<const FieldSample> samples);

// The same where the error is known already, as the length of a vector's error is.
struct ErrorSample {
  double volume;        // V_p, > 0
  double error, scale;  // >= 0; scale: size of the exact value
  double bound;         // of the exact value
};
std::vector<Measure> error_norms(const std::string& name, const std::string& unit,
                                 std::span<const ErrorSample> samples);

// A column of a profile or history.
struct ProfileColumn {
  std::string name, unit, label;
  std::vector<double> values;
};

struct Profile {
  std::string kind = "space";  // or "history"
  std::string abscissa = "x";  // name of the column drawn against
  std::vector<ProfileColumn> columns;
  const ProfileColumn* find(const std::string& name) const;
};

// A history with the first of `columns` as abscissa, from one row a step (a value per column), thinned to at most 1500.
template <class Rows>
Profile history_profile(std::vector<ProfileColumn> columns, const Rows& rows) {
  Profile profile;
  profile.kind = "history";
  profile.abscissa = columns.front().name;
  profile.columns = std::move(columns);
  const std::size_t every = rows.size() / 1500 + 1;
  for (std::size_t k = 0; k < rows.size(); k += every) {
    for (std::size_t c = 0; c < profile.columns.size(); ++c) profile.columns[c].values.push_back(rows[k][c]);
  }
  return profile;
}

}  // namespace plumbline
