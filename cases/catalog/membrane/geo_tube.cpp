// A tube of membrane filled with liquid lies on a floor in its elastica, and must stay.
#include <cmath>
#include <numbers>

#include "cases/catalog/membrane/hydrostatic_load.hpp"
#include "cases/catalog/membrane/string.hpp"
#include "cases/harness/description/archive.hpp"
#include "cases/harness/files/whole.hpp"
#include "cases/harness/judge/gates.hpp"
#include "reference/geo_tube.hpp"

namespace plumbline {
namespace {

constexpr double room = 0.2;  // m, of the grid beside and above the tube

reference::GeoTubeProblem tube_from(const Settings& s) {
  reference::GeoTubeProblem p;
  p.perimeter = s.number("perimeter");
  p.specific_weight = s.number("specific_weight");
  p.top_pressure = s.number("top_pressure");
  p.compliance = 1 / s.number("stiffness");
  return p;
}

// Where the largest of the values would be between the points: the top of the parabola through it and its neighbours.
double largest_of(const double* values, int count) {
  int top = 0;
  for (int p = 1; p < count; ++p) {
    if (values[p] > values[top]) top = p;
  }
  if (top == 0 || top == count - 1) return values[top];
  const double before = values[top - 1], after = values[top + 1], bend = before - 2 * values[top] + after;
  return bend < 0 ? values[top] - (after - before) * (after - before) / (8 * bend) : values[top];
}

class GeoTubeRun final : public Problem {
 public:
  explicit GeoTubeRun(const Settings& settings)
      : settings_(settings),
        exact_(tube_from(settings)),
        count_(std::max(8, whole(std::round(0.5 * settings.number("cells") * settings.number("ppc"))))),
        from_circle_(settings.text("start") == "circle") {
    const double half = 0.5 * exact_.problem().perimeter;
    for (int p = 0; p <= count_; ++p) {
      const reference::GeoTubePoint at = exact_.at(half * p / count_);
      rest_.push_back({p < count_ ? at.x.value : 0.0, std::max(0.0, at.y.value)});
    }
  }

  double end_time() const override { return settings_.number("rounds") * exact_.problem().perimeter / wave_speed(); }

  Scene scene() const override {
    Scene scene;
    scene.grid.dim = 2;
    const double h = scene.grid.h = exact_.problem().perimeter / settings_.number("cells");
    const double across = larger(0.5 * exact_.width().value, from_circle_ ? radius() : 0);
    const double up = larger(exact_.height().value, from_circle_ ? 2 * radius() : 0);
    const auto cells = [h](double size) { return whole(std::ceil((size + room) / h)) + 1; };
    scene.grid.cells = {cells(across), cells(up), 1};
    scene.grid.walls[0] = {Wall::symmetry, Wall::free};
    scene.grid.walls[1] = {Wall::symmetry, Wall::free};
    Body tube = string_body("tube", settings_.text("strain"),
                            {settings_.number("stiffness"), 1, settings_.number("line_density"), true}, start(), 2);
    tube.load = hydrostatic_load(exact_.bottom_pressure().value, exact_.problem().specific_weight,
                                 settings_.number("damping"));
    scene.bodies.push_back(std::move(tube));
    apply_choices(settings_, scene);
    return scene;
  }

  void observe(const Simulation& simulation) override {
    const Columns& points = simulation.scene().bodies.front().points;
    const double *x = points(column::position), *y = points(column::position, 1), *strain = points(column::strain);
    const double time = simulation.time(), dt = time - time_;
    double departure = 0, pull = 0;
    for (int p = 0; p <= count_; ++p) {
      const auto& rest = rest_[static_cast<std::size_t>(p)];
      departure = larger(departure, std::hypot(x[p] - rest[0], y[p] - rest[1]));
      if (p < judged()) pull += settings_.number("stiffness") * strain[p] / judged();
    }
    if (!by_segments()) pull /= 1 + exact_.strain().value;
    const double width = 2 * largest_of(x, count_ + 1), height = y[count_], contact = 2 * contact_of(points);
    const double shares[] = {1, width, height, contact, pull};
    for (std::size_t k = 0; k < 5 && time > averaged_from(); ++k) sums_[k] += dt * shares[k];
    time_ = time;
    largest_ = larger(largest_, departure);
    rows_.push_back({time, departure / exact_.height().value, width, height, pull});
  }
  void history(Archive& archive) override {
    archive("rows", rows_);
    archive("sums", sums_);
    archive("largest", largest_);
    archive("time", time_);
  }

  std::vector<Measure> measures(const Simulation& simulation) const override {
    const auto ratio = [](const char* name, double value) {
      Measure m = scalar_measure(name, value, 0, 0, "1");
      m.scale = 1;
      return m;
    };
    const auto mean = [this](const char* name, std::size_t which, const reference::Bounded& exact, const char* unit) {
      return scalar_measure(name, sums_[which] / sums_[0], exact.value, exact.bound, unit);
    };
    return {ratio("departure", largest_ / exact_.height().value),
            ratio("departure_at_end", rows_.back()[1]),
            mean("width", 1, exact_.width(), "m"),
            mean("height", 2, exact_.height(), "m"),
            mean("contact_width", 3, exact_.contact_width(), "m"),
            mean("tension", 4, exact_.tension(), "N/m"),
            ratio("energy_drift", energy_drift(simulation.ledger().energy))};
  }

  Profile profile(const Simulation& simulation) const override {
    const Columns& points = simulation.scene().bodies.front().points;
    Profile profile;
    profile.abscissa = "along";
    profile.columns = {{"along", "m", "from the middle of the floor along the unstretched membrane", {}},
                       {"y", "m", "height of the points at the end", {}},
                       {"y_reference", "m", "exact height", {}},
                       {"x", "m", "x of the points at the end", {}},
                       {"x_reference", "m", "exact x", {}}};
    for (int p = 0; p <= count_; ++p) {
      const auto& rest = rest_[static_cast<std::size_t>(p)];
      const double row[] = {0.5 * exact_.problem().perimeter * p / count_, points(column::position, 1)[p], rest[1],
                            points(column::position)[p], rest[0]};
      for (std::size_t c = 0; c < profile.columns.size(); ++c) profile.columns[c].values.push_back(row[c]);
    }
    return profile;
  }

 private:
  bool by_segments() const { return settings_.text("strain") == "segments"; }
  int judged() const { return count_ + (by_segments() ? 0 : 1); }  // tensions: of segments or of points
  double wave_speed() const { return std::sqrt(exact_.tension().value / settings_.number("line_density")); }
  double radius() const { return 0.5 * exact_.problem().perimeter * (1 + exact_.strain().value) / pi; }
  // The swings about the rest cancel over the run; what comes from a circle must settle first.
  double averaged_from() const { return from_circle_ ? 0.9 * end_time() : 0; }

  // Half the width. Where it leaves the floor the membrane is y = u^2, x = b/2 + a u + c u^3 + ...: followed back from
  // the first three points that are clearly off the floor.
  double contact_of(const Columns& points) const {
    const double *x = points(column::position), *y = points(column::position, 1);
    const double clear = 0.05 * exact_.problem().perimeter / settings_.number("cells");
    int p = 0;
    while (p + 3 < points.points() && y[p] < clear) ++p;
    const double u[] = {std::sqrt(y[p]), std::sqrt(y[p + 1]), std::sqrt(y[p + 2])};
    const double first = (x[p + 1] - x[p]) / (u[1] - u[0]), second = (x[p + 2] - x[p + 1]) / (u[2] - u[1]);
    const double q = u[0] * u[0] + u[0] * u[1] + u[1] * u[1],
                 c = (second - first) / ((u[2] - u[0]) * (u[0] + u[1] + u[2]));
    return x[p] - u[0] * (first - c * q) - c * u[0] * u[0] * u[0];
  }

  // Points evenly along half the unstretched membrane, from the middle of the floor to the top. Each stands for an
  // unstretched length: a point's stress of E eps (1 + eps) on that volume is the tension E A eps on the stretched one.
  StringState start() const {
    StringState state;
    const double strain = exact_.strain().value;
    const auto points = static_cast<std::size_t>(count_) + 1;
    state.place = rest_;
    if (from_circle_) {
      for (std::size_t p = 1; p + 1 < points; ++p) {
        const double angle = pi * static_cast<double>(p) / count_;
        state.place[p] = {radius() * std::sin(angle), radius() * (1 - std::cos(angle))};
      }
      state.place.back() = {0, 2 * radius()};
    }
    state.strain.assign(points, by_segments() ? strain : strain * (1 + strain));
    state.segment_strain.assign(points - 1, strain);
    state.segment_length.assign(points - 1, 0.5 * exact_.problem().perimeter / count_);
    return state;
  }

  static constexpr double pi = std::numbers::pi;
  Settings settings_;
  reference::GeoTube exact_;
  int count_;  // segments
  bool from_circle_;
  std::vector<std::array<double, 2>> rest_;
  std::vector<std::array<double, 5>> rows_;
  std::array<double, 5> sums_{};  // over the time averaged: of time, width, height, contact, tension
  double largest_ = 0, time_ = 0;
};

class GeoTubeCase final : public Case {
 public:
  std::string name() const override { return "geo-tube"; }

  Kind kind() const override { return Kind::membrane; }

  std::vector<Key> keys() const override {
    const reference::GeoTubeProblem p;
    return {strain_key(),
            positive_key("perimeter", p.perimeter, "m", "of the unstretched membrane"),
            positive_key("specific_weight", p.specific_weight, "N/m^3", "density of the liquid times gravity"),
            positive_key("top_pressure", p.top_pressure, "Pa", "of the liquid at the top of the tube, none outside"),
            positive_key("stiffness", 2e5, "N/m", "E't: tension per strain"),
            positive_key("line_density", 10, "kg/m^2", "mass of the membrane per unstretched length"),
            {.name = "start",
             .value = "elastica",
             .choices = {"elastica", "circle"},
             .description = "shape at the start: the exact one, or a circle that touches the floor"},
            {.name = "damping",
             .value = 0.0,
             .unit = "1/s",
             .low = 0,
             .high = 1e6,
             .description = "alpha of a drag of -alpha v per mass"},
            positive_key("rounds", 1, "1", "end time, in times in which a transverse wave runs around the tube")};
  }

  std::vector<Override> points_and_end(const std::string& scheme) const override {
    if (scheme == "york1997") return {{"cells", 80.0}, york_strain()};
    return {{"cells", 80.0}};
  }

  // York's Courant number counts cells of a metre.
  void derive(Settings& settings, const std::string& scheme) const override {
    const double speed = std::sqrt(settings.number("stiffness") / settings.number("line_density"));
    york_string_step(settings, scheme, speed / settings.number("perimeter"));
  }

  std::unique_ptr<Problem> problem(const Settings& settings) const override {
    return std::make_unique<GeoTubeRun>(settings);
  }

  std::vector<double> default_levels() const override { return {40, 56, 80, 112, 160}; }

  std::vector<StudyPlan> studies() const override {
    return {{.id = "default",
             .title = "at rest in its shape",
             .why = "Order 2 of the tension, between 1 and 2 of the shape.",
             .values = {40, 56, 80, 112, 160},
             .full_values = {20, 40, 80, 160, 320}},
            {.id = "accumulated",
             .title = "at rest, strain summed from rates",
             .why = "No order: strains of single points drift in patterns that no node sees.",
             .overrides = {york_strain()},
             .values = {40, 80},
             .full_values = {20, 40, 80, 160, 320}},
            {.id = "from-circle",
             .title = "from a circle, with drag",
             .why = "As at rest, once it has settled.",
             .overrides = {{"start", "circle"}, {"damping", 40.0}, {"rounds", 10.0}},
             .values = {28, 40, 56},
             .full_values = {20, 28, 40, 56, 80},
             .frames = 25}};
  }

  std::vector<CaseGate> gates() const override {
    const reference::GeoTube tube(reference::GeoTubeProblem{.compliance = 1 / 2e5});
    return {
        error_gate("default", "departure", 80,
                   declare("default/departure-80", {{}, 1e-4}, Origin::requirement,
                           "at rest: no point leaves its place by more than 1e-4 of the height, 0.002 cells")),
        fitted_order_gate("default", "departure",
                          declare("default/departure-order", {1, {}}, Origin::theory,
                                  "the jump of curvature at the end of the contact, spread over a cell, allows 1")),
        error_gate("default", "tension", 40,
                   declare("default/tension-40", {{}, 1e-3 * tube.tension().value}, Origin::theory,
                           "chords of h/4 over the smallest radius T/p0 = 0.25 m: (l/R)^2/24 = 4e-4, and the same "
                           "share for the maps")),
        fitted_order_gate("default", "tension",
                          declare("default/tension-order", {1.8, {}}, Origin::theory,
                                  "chords of an arc: order 2; 0.2 for the swing about the rest")),
        error_gate("default", "height", 80,
                   declare("default/height-80", {{}, 1e-4 * tube.height().value}, Origin::requirement,
                           "within 0.01 % of the exact height, 0.002 cells, as its points at rest")),
        error_gate("default", "width", 80,
                   declare("default/width-80", {{}, 1e-4 * tube.width().value}, Origin::requirement,
                           "within 0.01 % of the exact width, a few thousandths of a cell, as its points at rest")),
        error_gate(
            "default", "contact_width", 80,
            declare("default/contact-80", {{}, 1e-3 * tube.contact_width().value}, Origin::requirement,
                    "within 0.1 % of the exact width in contact, whose ends stand anywhere in a cell: 0.02 cells")),
        error_gate("from-circle", "departure_at_end", 56,
                   declare("from-circle/departure-56", {{}, 3.1e-3}, Origin::theory,
                           "where it leaves the floor nodes bend the membrane over a cell; in half a cell its "
                           "curvature p0/T makes a height of p0 h^2/8T, 0.0031 of the tube's")),
        error_gate("from-circle", "contact_width", 56,
                   declare("from-circle/contact-56", {{}, 2 * 4.0 / 56}, Origin::theory,
                           "a cell at either end: the kernel feels the floor from there")),
        error_gate("from-circle", "tension", 56,
                   declare("from-circle/tension-56", {{}, 1e-3 * tube.tension().value}, Origin::requirement,
                           "within 0.1 % of the exact tension, as at rest")),
        error_gate("from-circle", "height", 56,
                   declare("from-circle/height-56", {{}, 1e-3 * tube.height().value}, Origin::requirement,
                           "within 0.1 % of the exact height, a hundredth of a cell")),
        error_gate("accumulated", "tension", 80,
                   declare("accumulated/tension-80", {{}, 1e-3 * tube.tension().value}, Origin::requirement,
                           "within 0.1 % of the exact tension in the mean over the points, as with segments")),
        error_gate("accumulated", "departure", 80,
                   expected_failure(
                       declare("accumulated/departure-80", {{}, 1e-4}, Origin::requirement,
                               "at rest: no point leaves its place by more than 1e-4 of the height, as with segments"),
                       "nodes feel only what a cell's points pull together: strains of single points drift "
                       "apart in patterns that no node sees, and points with them",
                       {4.3e-4, 5.3e-4}, "2026-11-23 5825b24")),
        fitted_order_gate(
            "from-circle", "departure_at_end",
            declare("from-circle/departure-order", {1, {}}, Origin::theory,
                    "a height of p0 h^2/8T at the end of the contact: order 2, 1 while it still lies down"),
            Tier::full)};
  }
};

PLUMBLINE_CASE(GeoTubeCase);

}  // namespace
}  // namespace plumbline
