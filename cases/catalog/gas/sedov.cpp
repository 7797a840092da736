// Sedov's blast: energy set free on an axis or at a point of cold gas.
#include "reference/sedov.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "cases/catalog/gas/fill_ball.hpp"
#include "cases/catalog/gas/gas_case.hpp"
#include "cases/catalog/gas/radial.hpp"
#include "cases/catalog/gas/shock_front.hpp"

namespace plumbline {
namespace {

constexpr double domain = 1.2;  // m
constexpr double deposit = 2;   // cells: the energy is set free within this radius
struct SedovText {
  std::string name, energy_of;
  int dimension;
  double energy;
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
  const RadialGeometry geometry = radial_geometry(dimension, settings.text("geometry"));
  reference::SedovProblem problem;
  problem.dimension = dimension;
  problem.gamma = settings.number("gamma");
  problem.energy = settings.number("energy");
  const auto exact = std::make_shared<const reference::Sedov>(problem);
  GasFlow flow;
  flow.cells_along = domain;
  set_geometry(flow, geometry, domain, settings);
  flow.gamma = problem.gamma;
  flow.end_time = exact->time_of_radius(settings.number("shock_radius"));
  flow.judged = Interval{0, domain};
  flow.initial = [problem, p = settings.number("pressure")](double) {
    return reference::GasState{problem.density, 0, p};
  };
  flow.exact = [exact](double r, double t) { return exact->sample(r, t); };
  const double h = cell_size(flow, settings), energy = problem.energy * share_of_whole(geometry, h);
  const bool graded = settings.text("layout") == "graded";
  flow.fill = [=, end = settings.number("shock_radius"), state = flow.initial(0)](
                  std::shared_ptr<const IdealGas> gas, const PointRule& rule, const GridSpec& grid) {
    GasBall ball{geometry, domain, [state](double) { return state; }, true, {}};
    if (graded) {
      ball.spacing = [=, gamma = problem.gamma, least = 1e-6 * domain](double r) {
        return grid.h / rule.ppc * std::min(1.0, gamma / (gamma - 1) * std::pow(std::max(r, least) / end, 1 / gamma));
      };
    }
    Body body = fill_ball(std::move(gas), ball, rule, grid);
    set_free(body, geometry, deposit * grid.h, energy, problem.gamma);
    return body;
  };
  flow.further = [exact, geometry, h](const std::vector<GasSample>& points, double time) {
    std::vector<Measure> all = blast_measures(*exact, points, h, time);
    all.push_back(coverage_within(geometry, points, domain, h));
    return all;
  };
  return flow;
}

class SedovCase final : public Case {
 public:
  explicit SedovCase(SedovText text) : text_(std::move(text)), registered_(this) {}

  std::string name() const override { return text_.name; }

  Kind kind() const override { return Kind::gas; }

  Traits needs() const override { return {Trait::returned_loss}; }  // a cold gas has no energy to lose
  std::vector<Key> keys() const override {
    return {geometry_key(text_.dimension),
            {.name = "gamma", .value = 1.4, .low = 1.1, .high = 3, .description = "ratio of specific heats"},
            {.name = "energy",
             .value = text_.energy,
             .unit = text_.dimension == 2 ? "J/m" : "J",
             .low = 0,
             .low_open = true,
             .description = text_.energy_of},
            {.name = "pressure",
             .value = 0.0,
             .unit = "Pa",
             .low = 0,
             .high = 1e-3,
             .description = "of the cold gas; the reference has none"},
            {.name = "layout",
             .value = "graded",
             .choices = {"graded", "lattice"},
             .description = "points close together near the centre, or of one mass everywhere"},
            {.name = "shock_radius",
             .value = 1.0,
             .unit = "m",
             .low = 0.1,
             .high = 1.1,
             .description = "where the exact shock is at the end"}};
  }

  std::vector<Override> points_and_end(const std::string& scheme) const override {
    return scheme == "york1997" ? york_points(scheme) : std::vector<Override>{{"ppc", 2.0}};
  }
  void derive(Settings& settings, const std::string& scheme) const override { york_step(settings, scheme); }
  std::unique_ptr<Problem> problem(const Settings& settings) const override {
    return gas_problem(blast_flow(text_.dimension, settings), settings);
  }
  std::vector<double> default_levels() const override { return {30, 42, 60, 84, 120}; }
  std::vector<StudyPlan> studies() const override {
    StudyPlan plan{.id = "default",
                   .title = "default, by rings",
                   .why = "The shock, and a kernel's mean of a profile as steep as a cell is wide: order 1 at most.",
                   .values = {30, 42, 60, 84, 120},
                   .full_values = {60, 84, 120, 168, 240}};
    StudyPlan other = plan;
    other.id = text_.dimension == 2 ? "plane" : "3d";
    other.title = text_.dimension == 2 ? "default, a quarter in the plane" : "default, an octant";
    other.overrides = {{"geometry", other.id}};
    other.values = {30};
    other.full_values = {};
    other.tier = Tier::full;
    if (text_.dimension == 3) {
      plan.values = {16, 20, 24, 28, 36};
      plan.full_values = {20, 28, 36, 48, 60};
      other.values = {20};
    }
    return {plan, other};
  }
  std::vector<CaseGate> gates() const override {
    const double level = text_.dimension == 2 ? 120 : 36;
    std::vector<CaseGate> all{energy_gate("default"), shock_gates("default", level, domain / level, 6).front()};
    CaseGate other = energy_gate(text_.dimension == 2 ? "plane" : "3d");
    other.tier = Tier::full;
    all.push_back(other);
    return all;
  }
  // The plane has one angular momentum, space has three, rings none.

 private:
  SedovText text_;
  RegisterCase registered_;
};

// Energies of Kamm and Timmes's size: alpha rho, so that the shock is at 1 m after 1 s.
const SedovCase cylindrical{{"sedov-cylindrical", "set free per length of the whole axis", 2, 0.9840740}};
const SedovCase spherical{{"sedov-spherical", "set free, in the whole sphere", 3, 0.8510719}};

}  // namespace
}  // namespace plumbline
