// York's circular membrane under gas pressure, held or not by the normals of each method. [York section 7.5.2]
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "cases/catalog/coupled/membrane.hpp"
#include "cases/catalog/gas/ideal_gas.hpp"
#include "cases/catalog/normals/marked_points.hpp"
#include "cases/harness/description/archive.hpp"
#include "cases/harness/description/parameters.hpp"
#include "cases/harness/files/whole.hpp"
#include "cases/harness/run/extremes.hpp"
#include "cases/harness/verify/restart_gate.hpp"
#include "kernel/materials/segment_membrane.hpp"
#include "reference/released_ring.hpp"

namespace plumbline::cylinder {
namespace {

constexpr int york_cells = 10;
constexpr double domain = 1.5;  // m, a side of York's grid; the radius is 1

struct Cylinder : Parameters {
  reference::ReleasedRingProblem ring;
  int points = 179;  // chords of the quarter
  double end_time = 0.05;

  explicit Cylinder(Parameters given = {}) : Parameters(std::move(given)) {
    ring.pressure = positive("gas_pressure", ring.pressure, "Pa", "of the gas at the start");
    ring.gas_density = positive("gas_density", ring.gas_density, "kg/m^3", "of the gas at the start");
    points = integer({.name = "membrane_points",
                      .value = static_cast<double>(points),
                      .low = 4,
                      .high = 1e5,
                      .description = "chords of the quarter circle: York's points stand at their middles"});
    end_time = positive("t_end", end_time, "s", "end time");
  }
};

Curve quarter_circle(double radius, int chords) {
  Curve curve;
  for (int k = 0; k <= chords; ++k) {
    const double a = 0.5 * std::numbers::pi * k / chords;
    curve.push_back({k == chords ? 0.0 : radius * std::cos(a), k == 0 ? 0.0 : radius * std::sin(a)});
  }
  return curve;
}

// Mean distance from the axis of the points at 0, 45 and 90 degrees. [York section 7.5.2, his footnote]
double radius_of_three(const Columns& points) {
  const double *x = points(column::position), *y = points(column::position, 1);
  const int last = points.points() - 1;
  const auto radius = [&](int p) { return std::hypot(x[p], y[p]); };
  const double middle = 0.5 * (radius(last / 2) + radius((last + 1) / 2));
  return (radius(0) + middle + radius(last)) / 3;
}

// Angles between normals and radii, degrees: of segments the normals of the chords at their middles.
std::vector<double> angles_of(const Body& membrane) {
  const Columns& points = membrane.points;
  const double *x = points(column::position), *y = points(column::position, 1);
  std::vector<double> angles;
  if (points.has(column::rest_length)) {
    for (int p = 0; p + 1 < points.points(); ++p) {
      const double mx = 0.5 * (x[p] + x[p + 1]), my = 0.5 * (y[p] + y[p + 1]);
      angles.push_back(angle_between(y[p + 1] - y[p], x[p] - x[p + 1], mx, my));
    }
    return angles;
  }
  const double *tx = points(column::tangent), *ty = points(column::tangent, 1);
  for (int p = 0; p < points.points(); ++p) angles.push_back(angle_between(-ty[p], tx[p], x[p], y[p]));
  return angles;
}

class CylinderRun final : public Problem {
 public:
  explicit CylinderRun(const Settings& settings)
      : settings_(settings),
        at_(settings),
        exact_(at_.ring),
        start_(radius_of_three(membrane().points)) {}

  double end_time() const override { return at_.end_time; }

  Scene scene() const override {
    const int cells = settings_.integer("cells");
    Scene scene;
    scene.grid.dim = 2;
    scene.grid.h = at_.ring.radius / cells;
    scene.grid.cells[0] = scene.grid.cells[1] = whole(std::round(domain * cells));
    for (std::size_t d = 0; d < 2; ++d) scene.grid.walls[d] = {Wall::symmetry, Wall::no_slip};
    auto gas = chosen_gas(settings_, at_.ring.gamma);
    Curve polygon = quarter_circle(at_.ring.radius, at_.points);
    polygon.push_back({0, 0});
    const double energy = at_.ring.pressure / ((at_.ring.gamma - 1) * at_.ring.gas_density);
    scene.bodies.push_back(
        fill_polygon("gas", gas, scene.grid, settings_.integer("ppc"), polygon, at_.ring.gas_density, energy));
    scene.bodies.push_back(membrane());
    apply_choices(settings_, scene);
    return scene;
  }

  void observe(const Simulation& simulation) override {
    if (rows_.empty()) rows_.push_back({0, 0, exact_.radius_change(0).value});
    const double change = radius_of_three(simulation.scene().bodies[1].points) - start_;
    rows_.push_back({simulation.time(), change, exact_.radius_change(simulation.time()).value});
  }
  void history(Archive& archive) override { archive("rows", rows_); }

  std::vector<Measure> measures(const Simulation& simulation) const override {
    const double bound = exact_.radius_change(0).bound;
    const History ours = history(1), exact = history(2);
    const auto against = [&](const char* name, double value, double reference) {
      return scalar_measure(name, value, reference, bound, "m");
    };
    std::vector<Measure> all{against("radius_change_max", ours.most, exact.most),
                             against("radius_change_first", ours.first, exact.first),
                             against("radius_change_mean", ours.mean, exact.mean)};
    add_angles(all, "", angles_of(simulation.scene().bodies[1]), 0);
    return all;
  }

  Profile profile(const Simulation&) const override {
    return history_profile({{"time", "s", "time", {}},
                            {"radius_change", "m", "mean change of the radii at 0, 45 and 90 degrees", {}},
                            {"radius_change_reference", "m", "ring and gas in small motion", {}}},
                           rows_);
  }

 private:
  // Largest and mean value over time, and the first maximum.
  struct History {
    double most = 0, mean = 0, first = 0;
  };

  History history(std::size_t column) const {
    History h;
    std::vector<double> times, values;
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      times.push_back(rows_[k][0]);
      values.push_back(rows_[k][column]);
      h.most = larger(h.most, values.back());
      if (k > 0) h.mean += 0.5 * (values[k] + values[k - 1]) * (times[k] - times[k - 1]) / at_.end_time;
    }
    const auto extremes = find_extremes(times, values);
    h.first = extremes.empty() ? std::nan("") : extremes.front().value;
    return h;
  }

  Body membrane() const {
    const reference::ReleasedRingProblem& ring = at_.ring;
    return membrane_body(settings_, "membrane",
                         {ring.youngs_modulus, ring.poisson_ratio, ring.membrane_density, ring.thickness, true},
                         quarter_circle(ring.radius, at_.points));
  }

  Settings settings_;
  Cylinder at_;
  reference::ReleasedRing exact_;
  double start_;
  std::vector<std::array<double, 3>> rows_;
};

std::string study_of(const std::string& scheme, const std::string& method) {
  return (scheme == "default" ? "" : scheme + "-") + method;
}

StudyPlan carried(const std::string& scheme, const std::string& method, const std::string& title) {
  StudyPlan plan = study(study_of(scheme, method), scheme + ", carried strain, " + title, "York's one mesh.",
                         {york_cells});
  plan.scheme = scheme;
  return std::move(plan).with({{"membrane.strain", "accumulated"}, {"normals", method}}).pictured(25);
}

std::vector<StudyPlan> studies() {
  const char *mass = "York's mass matrix", *nine = "York's quadratic mass matrix",
             *quadratic = "York's quadratic method", *cubic = "York's cubic method", *circles = "fitted circles";
  return {
      study("default", "default: segments", "Sound and the ring's smeared mass.", {york_cells})
          .in_full({10, 20, 40})
          .pictured(25, york_cells),
      carried("default", "connectivity", "connectivity"),
      carried("default", "modern", circles),
      carried("default", "york-mass-matrix", mass),
      carried("default", "york-mass-matrix-quadratic", nine).in(Tier::full),
      carried("default", "york-quadratic", quadratic),
      carried("default", "york-cubic", cubic),
      carried("york1997", "connectivity", "connectivity"),
      carried("york1997", "york-mass-matrix", mass),
      carried("york1997", "york-quadratic", quadratic),
      carried("york1997", "york-cubic", cubic),
      carried("york1997", "york-mass-matrix-quadratic", nine).in(Tier::full),
      carried("york1997", "york-mass-matrix-kept", "York's mass matrix, normals of points alone kept").in(Tier::full),
      carried("york1997", "modern", circles).in(Tier::full)};
}

double way_to_rest() {  // m
  static const double way = reference::ReleasedRing({}).strain();
  return way;
}

CaseGate held(const std::string& study) {
  return gate(
      study + "/held", value_at("radius_change_max", york_cells), at_most(2.2 * way_to_rest()),
      theory("a ring let go swings to twice its way to rest, 2 x 0.0089 m; a tenth more for what the grid adds"));
}
CaseGate bursts(const std::string& study, Range band) {
  return held(study).fails(
      "the gradient of a smoothed colour is not normal to the membrane: its stress does not act along it, and "
      "it flies on to the held sides (York's Figs. 73 to 75: 0.2 m and more)",
      band, "2026-11-23 5825b24");
}

CaseGate first(const std::string& study) {
  return gate(study + "/first", error_at("radius_change_first", york_cells), at_most(0.05 * 2 * way_to_rest()),
              theory("5 % of twice the way to rest: (kh)^2/12 = 3 % for sound of the ring's frequency on this "
                     "mesh, and the strain, 0.9 %, and as much again for the ring's smeared mass"));
}
CaseGate mean(const std::string& study) {
  return gate(study + "/mean", error_at("radius_change_mean", york_cells), at_most(0.02 * way_to_rest()),
              theory("2 % of the way to rest: twice the strain, which small motions do not know"));
}
// York's mass matrix stays with connectivity as far as Fig. 73 shows: its axis spans 0.2 m, and lines are a hundredth
// of it.
CaseGate mean_as_drawn(const std::string& study) {
  return gate(study + "/mean", error_at("radius_change_mean", york_cells), at_most(0.002),
              literature("as connectivity, in Fig. 73: a hundredth of its axis of 0.2 m"));
}

// Of the mean growths of the radius in two studies on York's mesh.
Number growths(std::string quantity, const std::string& other, double (*number)(double here, double there)) {
  const auto growth = [](const StudyResult& s) {
    const StudyLevel* at = s.level(york_cells);
    if (!at || !at->run.finished) throw std::runtime_error("a run did not arrive");
    return *at->run.find("radius_change_mean")->value;
  };
  return number_of(std::move(quantity),
                   [=](const StudyResult& s) { return Measured::of(number(growth(s), growth(*s.sibling(other)))); },
                   {york_cells});
}

std::vector<CaseGate> gates() {
  std::vector<CaseGate> all;
  for (const char* study : {"default", "connectivity", "modern"}) {
    for (const auto made : {held, first, mean}) all.push_back(made(study));
  }
  for (const char* scheme : {"default", "york1997"}) {
    for (const Tier tier : {Tier::quick, Tier::full}) {
      const std::string method = tier == Tier::quick ? "york-mass-matrix" : "york-mass-matrix-quadratic";
      for (const auto made : {held, mean_as_drawn}) all.push_back(made(study_of(scheme, method)).in(tier));
    }
  }
  const std::vector<CaseGate> rows{
      held("york1997-connectivity"),
      mean_as_drawn("york1997-connectivity"),
      held("york1997-york-mass-matrix-kept").in(Tier::full),
      gate("york1997-york-mass-matrix-kept/as-ghost-cell",
           growths("difference of the mean radius from that with a ghost cell for points alone",
                   "york1997-york-mass-matrix", [](double here, double there) { return std::abs(here - there); }),
           at_most(0.002),
           literature("York, section 7.8, names both as answers to a point alone; as close as Fig. 73 shows"))
          .beside({"york1997-york-mass-matrix"})
          .in(Tier::full),
      bursts("york-quadratic", {0.52, 0.64}),
      bursts("york-cubic", {0.50, 0.61}),
      bursts("york1997-york-quadratic", {0.61, 0.74}),
      bursts("york1997-york-cubic", {0.385, 0.475}),
      gate("modern/angle", error_at("max_angle_error_deg", york_cells), at_most(0.5),
           theory("as close to the radii as the angle between two points, 90/179 degrees")),
      gate("modern/as-connectivity",
           growths("difference of the mean radius from that with connectivity, over the way to rest", "connectivity",
                   [](double here, double there) { return std::abs(here - there) / way_to_rest(); }),
           at_most(0.005),
           requirement("within 0.5 % of the way to rest of connectivity's radius, a quarter of what either may "
                       "be off from the exact mean"))
          .beside({"connectivity"}),
      gate("york-quadratic/worse-than-cubic",
           growths("mean growth of the radius over that with the cubic method", "york-cubic",
                   [](double here, double there) { return here / there; }),
           at_least(1), literature("York: the quadratic method is worse than the cubic (Fig. 73)"))
          .beside({"york-cubic"}),
      gate("default/first-10-40", ratio_of("radius_change_first", 10, 40), at_least(2.5),
           theory("order 1 in h: 4 from h = 0.1 to 0.025, less what the strain leaves"))
          .in(Tier::full),
      restart_gate("modern", "runs with fitted normals", {{"t_end", 2e-3}})};
  all.insert(all.end(), rows.begin(), rows.end());
  return all;
}

Case normals_cylinder() {
  return {.name = "normals-cylinder",
          .kind = Kind::coupled,
          .keys = Cylinder().keys(),
          .sets = {{"cells", static_cast<double>(york_cells)}, {"ppc", 16.0}},
          // The Courant number of his bag: 3.5e-5 s at h = 0.05. [York section 6.2]
          .york_step = step_over_cells(7e-4),
          .problem = run_of<CylinderRun>,
          .studies = studies(),
          .gates = gates(),
          .levels = {10}};
}
PLUMBLINE_CASE(normals_cylinder);

}  // namespace
}  // namespace plumbline::cylinder
