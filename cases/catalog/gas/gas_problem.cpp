#include "cases/catalog/gas/gas_problem.hpp"

#include <algorithm>
#include <cmath>

#include "cases/catalog/gas/ideal_gas.hpp"
#include "cases/harness/files/whole.hpp"

namespace plumbline {
namespace {

using Samples = std::vector<FieldSample>;

int whole_cells(double length, double h) { return whole(std::ceil(length / h - 1e-9)); }

void append(std::vector<Measure>& all, const std::vector<Measure>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

double dot(const Position& a, const Position& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// The points that a profile shows, in the order of their numbers: all, or where there are more than a picture needs, a
// share of them that no row of points lines up with, since multiples of the golden section fill [0, 1] evenly.
std::vector<int> shown_points(const Body& body) {
  constexpr double most = 20000, golden = 0.61803398874989485;
  const double share = most / static_cast<double>(body.id.size());
  std::vector<int> shown;
  for (int p = 0; p < body.points.points(); ++p) {
    const double place = golden * body.id[static_cast<std::size_t>(p)];
    if (place - std::floor(place) < share) shown.push_back(p);
  }
  std::sort(shown.begin(), shown.end(),
            [&](int a, int b) { return body.id[static_cast<std::size_t>(a)] < body.id[static_cast<std::size_t>(b)]; });
  return shown;
}

// Rows of a profile, one for each of the points shown.
class ProfileTable {
 public:
  explicit ProfileTable(std::vector<int> shown) : shown_(std::move(shown)) {}

  // `value` takes the number of the row and the point.
  void add(const std::string& name, const std::string& unit, const std::string& label,
           const std::function<double(std::size_t row, int p)>& value) {
    ProfileColumn column{name, unit, label, {}};
    for (std::size_t row = 0; row < shown_.size(); ++row) column.values.push_back(value(row, shown_[row]));
    columns_.push_back(std::move(column));
  }
  std::vector<ProfileColumn> take() { return std::move(columns_); }

 private:
  std::vector<int> shown_;
  std::vector<ProfileColumn> columns_;
};

}  // namespace

GasProblem::GasProblem(GasFlow flow, Settings settings) : flow_(std::move(flow)), settings_(std::move(settings)) {
  const auto axis = static_cast<std::size_t>(flow_.axis);
  if (!flow_.coordinate) flow_.coordinate = [axis](const Position& x) { return x[axis]; };
  if (!flow_.direction) {
    flow_.direction = [axis](const Position&) {
      Position n{};
      n[axis] = 1;
      return n;
    };
  }
}

GasProblem::Layout GasProblem::layout() const {
  Layout at;
  GridSpec& grid = at.grid;
  grid.dim = flow_.dim;
  grid.axisymmetric = flow_.axisymmetric;
  grid.h = flow_.cells_along / settings_.number("cells");
  grid.walls = flow_.walls;
  const double h = grid.h, offset = settings_.number("offset");
  const auto axis = static_cast<std::size_t>(flow_.axis);
  for (std::size_t d = 0; d < static_cast<std::size_t>(flow_.dim); ++d) {
    grid.cells[d] = whole(std::round((flow_.high[d] - flow_.low[d]) / h));
    grid.origin[d] = flow_.low[d];
  }
  const int below = whole_cells(flow_.margin[0], h), above = whole_cells(flow_.margin[1], h);
  at.gas = {flow_.low[axis] - below * h, flow_.high[axis] + above * h};
  const auto travel = [&](std::size_t side) {
    return (flow_.frame_velocity + flow_.pistons[side].value_or(0.0)) * flow_.end_time;
  };
  const int empty_below = whole_cells(flow_.space[0] + std::max(0.0, -travel(0)), h);
  const int empty_above = whole_cells(flow_.space[1] + std::max(0.0, travel(1)), h);
  grid.cells[axis] += below + above + empty_below + empty_above + (offset > 0 ? 1 : 0);
  grid.origin[axis] = at.gas.from - empty_below * h - offset * h;
  if (empty_below == 0) at.gas.from = grid.origin[axis];
  if (empty_above == 0) at.gas.to = grid.origin[axis] + h * grid.cells[axis];
  return at;
}

Body GasProblem::body(const Layout& at) const {
  const auto axis = static_cast<std::size_t>(flow_.axis);
  GasBox box;
  for (std::size_t d = 0; d < static_cast<std::size_t>(flow_.dim); ++d) {
    box.low[d] = at.grid.origin[d];
    box.high[d] = at.grid.origin[d] + at.grid.h * at.grid.cells[d];
  }
  box.low[axis] = at.gas.from;
  box.high[axis] = at.gas.to;
  box.axis = flow_.axis;
  box.jumps = flow_.jumps;
  box.state = [this, axis](const Position& x) {
    const reference::GasState state = flow_.initial(flow_.coordinate(x));
    const Position n = flow_.direction(x);
    GasAt gas{state.density, {}, state.pressure};
    for (std::size_t d = 0; d < 3; ++d) gas.velocity[d] = state.velocity * n[d];
    gas.velocity[axis] += flow_.frame_velocity;
    return gas;
  };
  auto gas = chosen_gas(settings_, flow_.gamma);
  gas->viscosity = flow_.viscosity;
  const PointRule rule{settings_.text("points") == "equal-mass", settings_.number("ppc"), flow_.lines, 1};
  if (flow_.fill) return flow_.fill(gas, rule, at.grid);
  return fill_gas(gas, box, rule, at.grid);
}

Scene GasProblem::scene() const {
  const Layout at = layout();
  Scene scene;
  scene.grid = at.grid;
  for (int side : {0, 1}) {
    const auto& piston = flow_.pistons[static_cast<std::size_t>(side)];
    if (!piston) continue;
    scene.pistons.push_back({.direction = flow_.axis,
                             .side = side,
                             .position = side == 0 ? at.gas.from : at.gas.to,
                             .velocity = *piston + flow_.frame_velocity});
  }
  scene.bodies.push_back(body(at));
  apply_choices(settings_, scene);
  return scene;
}

// Where points are judged at the end, of the coordinate in the moving frame.
Interval GasProblem::judged() const {
  if (flow_.judged) return *flow_.judged;
  const auto axis = static_cast<std::size_t>(flow_.axis);
  const Interval gas = layout().gas;
  const auto end = [&](std::size_t side, double of_gas, double of_domain) {
    if (flow_.margin[side] > 0) return of_domain;
    return of_gas + flow_.pistons[side].value_or(0.0) * flow_.end_time;
  };
  return {end(0, gas.from, flow_.low[axis]), end(1, gas.to, flow_.high[axis])};
}

// Volume (per radian) of the space where points are judged, if the coordinate is the place along the axis.
double GasProblem::judged_space() const {
  const GridSpec grid = layout().grid;
  double volume = 1;
  for (std::size_t d = 0; d < static_cast<std::size_t>(flow_.dim); ++d) {
    const Interval across{grid.origin[d], grid.origin[d] + grid.h * grid.cells[d]};
    const Interval over = static_cast<int>(d) == flow_.axis ? judged() : across;
    volume *= over.length() * (flow_.axisymmetric && d == 0 ? over.middle() : 1.0);
  }
  return volume;
}

GasProblem::Seen GasProblem::seen(const Columns& points, int p, double time) const {
  const auto axis = static_cast<std::size_t>(flow_.axis);
  Position x{}, v{};
  for (int d = 0; d < flow_.dim; ++d) {
    x[static_cast<std::size_t>(d)] = points(column::position, d)[p];
    v[static_cast<std::size_t>(d)] = points(column::velocity, d)[p];
  }
  x[axis] -= flow_.frame_velocity * time;
  v[axis] -= flow_.frame_velocity;
  return {flow_.coordinate(x), flow_.direction(x), v, !flow_.inside || flow_.inside(x)};
}

// The share of a point inside the space where it is judged. Walls and pistons cut nothing: all is inside.
double GasProblem::share_judged(double coordinate, double volume) const {
  const double length = std::pow(volume, 1.0 / flow_.dim);
  const bool open_below = flow_.judged || flow_.margin[0] > 0, open_above = flow_.judged || flow_.margin[1] > 0;
  const Interval where = judged();
  const double from = std::max(coordinate - length / 2, open_below ? where.from : -HUGE_VAL);
  const double to = std::min(coordinate + length / 2, open_above ? where.to : HUGE_VAL);
  return std::clamp((to - from) / length, 0.0, 1.0);
}

std::vector<Measure> GasProblem::measures(const Simulation& simulation) const {
  const Columns& points = simulation.scene().bodies.front().points;
  const Interval where = judged();
  Samples density, pressure, energy;
  std::vector<ErrorSample> velocity;
  std::vector<GasSample> samples;
  double covered = 0;
  for (int p = 0; p < points.points(); ++p) {
    const double rho = points(column::density)[p], volume = points(column::mass)[p] / rho;
    const Seen at = seen(points, p, simulation.time());
    if (!at.inside) continue;
    covered += volume * share_judged(at.coordinate, volume);
    // A wall's own rounding may leave a point a hair beyond it.
    const double hair = 1e-9 * where.length();
    if (at.coordinate < where.from - hair || at.coordinate > where.to + hair) continue;
    const reference::Sample exact = flow_.exact(at.coordinate, simulation.time());
    const auto add = [&](Samples& field, double computed, const reference::Bounded& value) {
      field.push_back({volume, at.coordinate, computed, value.value, value.bound});
    };
    add(density, rho, exact.density);
    add(pressure, points(column::pressure)[p], exact.pressure);
    add(energy, points(column::energy)[p], exact.energy);
    double off = 0;
    for (std::size_t d = 0; d < static_cast<std::size_t>(flow_.dim); ++d) {
      off = std::hypot(off, at.velocity[d] - exact.velocity.value * at.direction[d]);
    }
    velocity.push_back({volume, off, std::abs(exact.velocity.value), exact.velocity.bound});
    samples.push_back({at.coordinate, volume, rho, dot(at.velocity, at.direction), points(column::pressure)[p],
                       points(column::energy)[p]});
  }
  std::vector<Measure> all;
  append(all, field_norms("density", "kg/m^3", density));
  append(all, error_norms("velocity", "m/s", velocity));
  append(all, field_norms("pressure", "Pa", pressure));
  append(all, field_norms("energy", "J/kg", energy));
  if (flow_.exact_error) {
    const reference::GasFields known = flow_.exact_error();
    for (Measure& m : all) {
      if (m.name == "density.L1") m.reference_bound = known.density;
      if (m.name == "velocity.L1") m.reference_bound = known.velocity;
      if (m.name == "pressure.L1") m.reference_bound = known.pressure;
      if (m.name == "energy.L1") m.reference_bound = known.energy;
    }
  }
  if (flow_.filled) all.push_back(scalar_measure("coverage", covered / judged_space(), 1.0, 0.0, "1"));
  if (flow_.further) append(all, flow_.further(samples, simulation.time()));
  return all;
}

Profile GasProblem::profile(const Simulation& simulation) const {
  const Body& body = simulation.scene().bodies.front();
  const Columns& points = body.points;
  const std::vector<int> shown = shown_points(body);
  std::vector<Seen> rows;
  std::vector<reference::Sample> exact;
  for (const int p : shown) {
    rows.push_back(seen(points, p, simulation.time()));
    exact.push_back(flow_.exact(rows.back().coordinate, simulation.time()));
  }
  ProfileTable table(shown);
  table.add(flow_.abscissa, "m", flow_.abscissa == "x" ? "position" : "radius",
            [&](std::size_t row, int) { return rows[row].coordinate; });
  const auto plain = [&](const ColumnId& id, const char* label) {
    table.add(id.name(), id.unit(), label, [&](std::size_t, int p) { return points(id)[p]; });
  };
  plain(column::mass, "point mass");
  plain(column::density, "density");
  table.add("velocity", "m/s", "velocity",
            [&](std::size_t row, int) { return dot(rows[row].velocity, rows[row].direction); });
  plain(column::pressure, "pressure");
  plain(column::energy, "specific internal energy");
  table.add("volume", "m^3", "point volume",
            [&](std::size_t, int p) { return points(column::mass)[p] / points(column::density)[p]; });
  const auto reference_of = [&](const char* name, const char* unit, const char* label, auto member) {
    table.add(name, unit, label, [&](std::size_t row, int) { return (exact[row].*member).value; });
  };
  reference_of("density_reference", "kg/m^3", "exact density", &reference::Sample::density);
  reference_of("velocity_reference", "m/s", "exact velocity", &reference::Sample::velocity);
  reference_of("pressure_reference", "Pa", "exact pressure", &reference::Sample::pressure);
  reference_of("energy_reference", "J/kg", "exact specific internal energy", &reference::Sample::energy);
  Profile profile;
  profile.abscissa = flow_.abscissa;
  profile.columns = table.take();
  return profile;
}

std::unique_ptr<Problem> gas_problem(const GasFlow& flow, const Settings& settings) {
  return std::make_unique<GasProblem>(flow, settings);
}

}  // namespace plumbline
