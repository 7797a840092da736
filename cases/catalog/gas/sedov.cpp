// Sedov's blast: energy set free on an axis or at a point of cold gas.
#include <algorithm>
#include <cmath>
#include <memory>

#include "cases/catalog/gas/fill_ball.hpp"
#include "cases/catalog/gas/gas_case.hpp"
#include "cases/catalog/gas/radial.hpp"
#include "cases/catalog/gas/shock_front.hpp"
#include "cases/harness/description/parameters.hpp"
#include "reference/sedov.hpp"

namespace plumbline::sedov {
namespace {

constexpr double domain = 1.2;  // m
constexpr double deposit = 2;   // cells: the energy is set free within this radius

struct Blast : Parameters {
  RadialGeometry geometry;
  reference::SedovProblem sedov;
  double pressure;
  bool graded;
  double shock_radius;

  explicit Blast(int dimension, Parameters given = {}) : Parameters(std::move(given)) {
    const bool line = dimension == 2;
    geometry = radial_geometry(dimension, text(geometry_key(dimension)));
    sedov.dimension = dimension;
    sedov.gamma = number(
        {.name = "gamma", .value = 1.4, .low = 1.1, .high = 3, .description = "ratio of specific heats"});
    // Of Kamm and Timmes's size: alpha rho, so that the shock is at 1 m after 1 s.
    sedov.energy = line ? positive("energy", 0.9840740, "J/m", "set free per length of the whole axis")
                        : positive("energy", 0.8510719, "J", "set free, in the whole sphere");
    pressure = number({.name = "pressure",
                       .value = 0.0,
                       .unit = "Pa",
                       .low = 0,
                       .high = 1e-3,
                       .description = "of the cold gas; the reference has none"});
    graded = one_of("layout", "graded", {"graded", "lattice"},
                    "points close together near the centre, or of one mass everywhere") == "graded";
    shock_radius = number({.name = "shock_radius",
                           .value = 1.0,
                           .unit = "m",
                           .low = 0.1,
                           .high = 1.1,
                           .description = "where the exact shock is at the end"});
  }
};

// All energy in the points within `radius` of the centre, the same for each unit of their mass. Their momentum is zero.
void set_free(Body& body, const RadialGeometry& geometry, double radius, double energy, double gamma) {
  Columns& points = body.points;
  std::vector<int> inside;
  double mass = 0;
  for (int p = 0; p < points.points(); ++p) {
    Position x{};
    for (int d = 0; d < geometry.dim; ++d) x[static_cast<std::size_t>(d)] = points(column::position, d)[p];
    if (radius_of(geometry, x) > radius) continue;
    inside.push_back(p);
    mass += points(column::mass)[p];
  }
  for (const int p : inside) {
    points(column::energy)[p] += energy / mass;
    points(column::pressure)[p] = (gamma - 1) * points(column::density)[p] * points(column::energy)[p];  // [York 4.4]
  }
}

std::vector<Measure> blast_measures(const reference::Sedov& exact, const std::vector<GasSample>& points, double h,
                                    double time) {
  double peak = 0;
  for (const GasSample& p : points) peak = larger(peak, p.density);
  const double ahead = exact.problem().density;
  const reference::Bounded radius = exact.shock_radius(time), behind = exact.behind(time).density;
  return {scalar_measure("shock_position", shock_place(points, h, (ahead + peak) / 2), radius.value, radius.bound, "m"),
          scalar_measure("peak_density", peak, behind.value, behind.bound, "kg/m^3")};
}

GasFlow blast_flow(int dimension, const Settings& settings) {
  const Blast blast(dimension, settings);
  const RadialGeometry& geometry = blast.geometry;
  const reference::SedovProblem& problem = blast.sedov;
  const auto exact = std::make_shared<const reference::Sedov>(problem);
  GasFlow flow;
  flow.cells_along = domain;
  set_geometry(flow, geometry, domain, settings);
  flow.gamma = problem.gamma;
  flow.end_time = exact->time_of_radius(blast.shock_radius);
  flow.judged = Interval{0, domain};
  flow.initial = [start = reference::GasState{problem.density, 0, blast.pressure}](double) { return start; };
  flow.exact = [exact](double r, double t) { return exact->sample(r, t); };
  const double h = cell_size(flow, settings);
  flow.fill = [geometry, graded = blast.graded, end = blast.shock_radius, initial = flow.initial, gamma = problem.gamma,
               energy = problem.energy * share_of_whole(geometry, h)](std::shared_ptr<const IdealGas> gas,
                                                                      const PointRule& rule, const GridSpec& grid) {
    GasBall ball{geometry, domain, initial, true, {}};
    if (graded) {
      ball.spacing = [=, least = 1e-6 * domain](double r) {
        return grid.h / rule.ppc * std::min(1.0, gamma / (gamma - 1) * std::pow(std::max(r, least) / end, 1 / gamma));
      };
    }
    Body body = fill_ball(std::move(gas), ball, rule, grid);
    set_free(body, geometry, deposit * grid.h, energy, gamma);
    return body;
  };
  flow.further = [exact, geometry, h](const std::vector<GasSample>& points, double time) {
    std::vector<Measure> all = blast_measures(*exact, points, h, time);
    all.push_back(coverage_within(geometry, points, domain, h));
    return all;
  };
  return flow;
}

// The first study is by rings; `whole` is of another geometry, all of whose directions are the grid's.
Case sedov_case(std::string name, int dimension, StudyPlan rings, StudyPlan whole) {
  const double finest = rings.values.back();
  const std::string geometry = whole.id;
  return {.name = std::move(name),
          .kind = Kind::gas,
          .keys = Blast(dimension).keys(),
          .sets = {{"ppc", 2.0}},
          .york1997 = york_points,
          .york_step = york_step,
          .problem = gas_run([dimension](const Settings& settings) { return blast_flow(dimension, settings); }),
          .studies = {std::move(rings), std::move(whole).with({{"geometry", geometry}}).in(Tier::full)},
          .gates = {energy_gate("default"), shock_position_gate("default", finest, domain / finest),
                    energy_gate(geometry).in(Tier::full)},
          .levels = {30, 42, 60, 84, 120},
          .needs = {Trait::returned_loss}};  // a cold gas has no energy to lose
}

std::vector<Case> sedov() {
  const std::string why = "The shock, and a kernel's mean of a profile as steep as a cell is wide: order 1 at most.";
  const auto by_rings = [&](std::vector<double> levels) { return study("default", "default, by rings", why, levels); };
  return {sedov_case("sedov-cylindrical", 2, by_rings({30, 42, 60, 84, 120}).in_full({60, 84, 120, 168, 240}),
                     study("plane", "default, a quarter in the plane", why, {30})),
          sedov_case("sedov-spherical", 3, by_rings({16, 20, 24, 28, 36}).in_full({20, 28, 36, 48, 60}),
                     study("3d", "default, an octant", why, {20}))};
}
PLUMBLINE_CASE(sedov);

}  // namespace
}  // namespace plumbline::sedov
