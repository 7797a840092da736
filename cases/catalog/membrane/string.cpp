#include "cases/catalog/membrane/string.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <utility>

#include "cases/harness/files/whole.hpp"
#include "kernel/materials/segment_membrane.hpp"
#include "kernel/materials/uniaxial_membrane.hpp"

namespace plumbline {
namespace {

std::shared_ptr<const Material> membrane(const std::string& strain, const StringMaterial& of) {
  if (strain == "segments") {
    auto segments = std::make_shared<SegmentMembrane>();
    segments->youngs_modulus = of.youngs_modulus;
    segments->density = of.density;
    segments->section = of.area;
    segments->one_way = of.one_way;
    return segments;
  }
  auto uniaxial = std::make_shared<UniaxialMembrane>();
  uniaxial->youngs_modulus = of.youngs_modulus;
  uniaxial->density = of.density;
  uniaxial->one_way = of.one_way;
  return uniaxial;
}

double distance(const std::array<double, 2>& a, const std::array<double, 2>& b, int dim) {
  return dim == 1 ? std::abs(b[0] - a[0]) : std::hypot(b[0] - a[0], b[1] - a[1]);
}

// Length of string that point p stands for.
double share(const std::vector<double>& segment, std::size_t p, StringEnds ends) {
  const bool first = p == 0, last = p == segment.size();
  if (first || last) return (ends == StringEnds::half ? 0.5 : 1.0) * (first ? segment.front() : segment.back());
  return 0.5 * (segment[p - 1] + segment[p]);
}

void set_segments(Body& body, const StringState& state, int dim) {
  double *strain = body.points(column::strain), *rest = body.points(column::rest_length);
  for (std::size_t s = 0; s + 1 < state.place.size(); ++s) {
    strain[s] = state.segment_strain[s];
    rest[s] = distance(state.place[s], state.place[s + 1], dim) / (1 + state.segment_strain[s]);
  }
}

struct Chord {
  double x, y, length;
};

Chord chord(const Columns& points) {
  const int last = points.points() - 1;
  const double *x = points(column::position), *y = points(column::position, 1);
  return {x[last] - x[0], y[last] - y[0], std::hypot(x[last] - x[0], y[last] - y[0])};
}

// Distance of a point from the line.
double aside(const Columns& points, int p, const Chord& line) {
  const double *x = points(column::position), *y = points(column::position, 1);
  return std::abs((x[p] - x[0]) * line.y - (y[p] - y[0]) * line.x) / line.length;
}

}  // namespace

Key strain_key() {
  return {
      .name = "strain",
      .value = "segments",
      .choices = {"accumulated", "segments"},
      .description = "of the string: the stretch of the segments between points, or summed from rates at the points",
      .method = true};
}

StringState straight_string(std::array<double, 2> from, std::array<double, 2> to, int points, double strain) {
  if (points < 2) throw std::invalid_argument("a string needs at least two points");
  StringState state;
  const int segments = points - 1;
  for (int p = 0; p < points; ++p) {
    const double at = static_cast<double>(p) / segments;
    state.place.push_back({from[0] + at * (to[0] - from[0]), from[1] + at * (to[1] - from[1])});
  }
  state.strain.assign(static_cast<std::size_t>(points), strain);
  state.segment_strain.assign(static_cast<std::size_t>(segments), strain);
  state.segment_length.assign(static_cast<std::size_t>(segments), distance(from, to, 2) / segments);
  return state;
}

Body string_body(const std::string& name, const std::string& strain, const StringMaterial& material,
                 const StringState& state, int dim, StringEnds ends) {
  const std::size_t points = state.place.size();
  if (points < 2 || state.strain.size() != points || state.segment_strain.size() + 1 != points ||
      state.segment_length.size() + 1 != points) {
    throw std::invalid_argument("string " + name + ": places, strains and lengths do not fit together");
  }
  Body body = make_body(name, membrane(strain, material), static_cast<int>(points), dim);
  double length = 0;
  for (std::size_t p = 0; p < points; ++p) {
    for (int d = 0; d < dim; ++d) body.points(column::position, d)[p] = state.place[p][static_cast<std::size_t>(d)];
    const double own = share(state.segment_length, p, ends);
    body.points(column::volume)[p] = material.area * own;
    body.points(column::mass)[p] = material.density * material.area * own;
    body.points(column::strain)[p] = state.strain[p];
    if (p > 0) length += distance(state.place[p - 1], state.place[p], dim);
  }
  body.spacing = length / static_cast<double>(points - 1);
  if (strain == "segments") set_segments(body, state, dim);
  return body;
}

double misalignment(const Columns& points) {
  const Chord line = chord(points);
  double largest = 0;
  for (int p = 0; p < points.points(); ++p) largest = std::max(largest, aside(points, p, line));
  return largest;
}

double squared_distances_to_chord(const Columns& points) {
  const Chord line = chord(points);
  double sum = 0;
  for (int p = 0; p < points.points(); ++p) sum += aside(points, p, line) * aside(points, p, line);
  return sum;
}

double chord_length(const Columns& points) { return chord(points).length; }

int segment_count(const Settings& settings, double lengths) {
  return std::max(4, whole(std::round(settings.number("cells") * settings.number("ppc") * lengths)));
}

StudyPlan accumulated_study(std::string why, std::vector<double> values) {
  return study("accumulated", "strain summed from rates", std::move(why), std::move(values)).with({york_strain()});
}

Override york_string_step(const Settings& settings, double speed) {
  return {"dt", 0.63 / speed / settings.number("cells")};
}

double energy_drift(const Account& energy) {
  return (energy.flow(Flow::integration) + energy.flow(Flow::transfer)) / energy.scale();
}

Measure drift_measure(const Simulation& simulation) {
  return share_measure("energy_drift", energy_drift(simulation.ledger().energy));
}

void add_row(Profile& profile, const std::vector<double>& row) {
  for (std::size_t c = 0; c < row.size(); ++c) profile.columns[c].values.push_back(row[c]);
}

std::vector<std::size_t> thinned_rows(std::size_t count, std::size_t most) {
  std::vector<std::size_t> rows;
  for (std::size_t k = 0; k < count; k += count / most + 1) rows.push_back(k);
  return rows;
}

Profile thinned_history(std::vector<ProfileColumn> columns, std::size_t count, std::size_t most,
                        const std::function<std::vector<double>(std::size_t)>& row) {
  Profile profile;
  profile.kind = "history";
  profile.abscissa = columns.front().name;
  profile.columns = std::move(columns);
  for (const std::size_t k : thinned_rows(count, most)) add_row(profile, row(k));
  return profile;
}

}  // namespace plumbline
