// A tube of membrane filled with liquid lies on a floor in its elastica, and must stay.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "cases/catalog/membrane/hydrostatic_load.hpp"
#include "cases/catalog/membrane/string.hpp"
#include "cases/harness/description/archive.hpp"
#include "cases/harness/description/drag.hpp"
#include "cases/harness/description/parameters.hpp"
#include "cases/harness/files/whole.hpp"
#include "cases/harness/judge/gates.hpp"
#include "reference/geo_tube.hpp"

namespace plumbline::geo_tube {
namespace {

constexpr double margin = 0.2;  // m, of the grid beside and above the tube

// One struct for points and reference.
struct FilledTube : Parameters {
  reference::GeoTubeProblem tube;
  std::string strain = text(strain_key());
  double stiffness = positive("stiffness", 2e5, "N/m", "E't: tension per strain");
  double line_density = positive("line_density", 10, "kg/m^2", "mass of the membrane per unstretched length");
  bool from_circle = one_of("start", "elastica", {"elastica", "circle"},
                            "shape at the start: the exact one, or a circle that touches the floor") == "circle";
  double damping = number({.name = "damping",
                           .value = 0.0,
                           .unit = "1/s",
                           .low = 0,
                           .high = 1e6,
                           .description = "alpha of a drag of -alpha v per mass"});
  double rounds = positive("rounds", 1, "1", "end time, in times in which a transverse wave runs around the tube");

  explicit FilledTube(Parameters given = {}) : Parameters(std::move(given)) {
    tube.perimeter = positive("perimeter", tube.perimeter, "m", "of the unstretched membrane");
    tube.specific_weight = positive("specific_weight", tube.specific_weight, "N/m^3",
                                    "density of the liquid times gravity");
    tube.top_pressure = positive("top_pressure", tube.top_pressure, "Pa",
                                 "of the liquid at the top of the tube, none outside");
    tube.compliance = 1 / stiffness;
  }

  bool by_segments() const { return strain == "segments"; }
};

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
        at_(settings_),
        exact_(at_.tube),
        count_(std::max(8, whole(std::round(0.5 * settings.number("cells") * settings.number("ppc"))))) {
    const double half = 0.5 * at_.tube.perimeter;
    for (int p = 0; p <= count_; ++p) {
      const reference::GeoTubePoint at = exact_.at(half * p / count_);
      rest_.push_back({p < count_ ? at.x.value : 0.0, std::max(0.0, at.y.value)});
    }
  }

  double end_time() const override { return at_.rounds * at_.tube.perimeter / wave_speed(); }

  Scene scene() const override {
    Scene scene;
    scene.grid.dim = 2;
    const double h = scene.grid.h = at_.tube.perimeter / settings_.number("cells");
    const double across = larger(0.5 * exact_.width().value, at_.from_circle ? radius() : 0);
    const double up = larger(exact_.height().value, at_.from_circle ? 2 * radius() : 0);
    const auto cells = [h](double size) { return whole(std::ceil((size + margin) / h)) + 1; };
    scene.grid.cells = {cells(across), cells(up), 1};
    scene.grid.walls[0] = {Wall::symmetry, Wall::free};
    scene.grid.walls[1] = {Wall::symmetry, Wall::free};
    Body tube = string_body("tube", at_.strain, {at_.stiffness, 1, at_.line_density, true}, start(), 2);
    tube.load = with_drag(hydrostatic_load(exact_.bottom_pressure().value, at_.tube.specific_weight), at_.damping);
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
      if (p < judged()) pull += at_.stiffness * strain[p] / judged();
    }
    if (!at_.by_segments()) pull /= 1 + exact_.strain().value;
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
    const auto mean = [this](const char* name, std::size_t which, const reference::Bounded& exact, const char* unit) {
      return scalar_measure(name, sums_[which] / sums_[0], exact.value, exact.bound, unit);
    };
    return {share_measure("departure", largest_ / exact_.height().value),
            share_measure("departure_at_end", rows_.back()[1]),
            mean("width", 1, exact_.width(), "m"),
            mean("height", 2, exact_.height(), "m"),
            mean("contact_width", 3, exact_.contact_width(), "m"),
            mean("tension", 4, exact_.tension(), "N/m"),
            drift_measure(simulation)};
  }

  Profile profile(const Simulation& simulation) const override {
    const Columns& points = simulation.scene().bodies.front().points;
    const double *x = points(column::position), *y = points(column::position, 1);
    Profile profile;
    profile.abscissa = "along";
    profile.columns = {{"along", "m", "from the middle of the floor along the unstretched membrane", {}},
                       {"y", "m", "height of the points at the end", {}},
                       {"y_reference", "m", "exact height", {}},
                       {"x", "m", "x of the points at the end", {}},
                       {"x_reference", "m", "exact x", {}}};
    for (int p = 0; p <= count_; ++p) {
      const auto& rest = rest_[static_cast<std::size_t>(p)];
      add_row(profile, {0.5 * at_.tube.perimeter * p / count_, y[p], rest[1], x[p], rest[0]});
    }
    return profile;
  }

 private:
  int judged() const { return count_ + (at_.by_segments() ? 0 : 1); }  // tensions: of segments or of points
  double wave_speed() const { return std::sqrt(exact_.tension().value / at_.line_density); }
  double radius() const { return 0.5 * at_.tube.perimeter * (1 + exact_.strain().value) / pi; }
  // The swings about the rest cancel over the run; what comes from a circle must settle first.
  double averaged_from() const { return at_.from_circle ? 0.9 * end_time() : 0; }

  // Half the width. Where it leaves the floor the membrane is y = u^2, x = b/2 + a u + c u^3 + ...: followed back from
  // the first three points that are clearly off the floor.
  double contact_of(const Columns& points) const {
    const double *x = points(column::position), *y = points(column::position, 1);
    const double clear = 0.05 * at_.tube.perimeter / settings_.number("cells");
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
    if (at_.from_circle) {
      for (std::size_t p = 1; p + 1 < points; ++p) {
        const double angle = pi * static_cast<double>(p) / count_;
        state.place[p] = {radius() * std::sin(angle), radius() * (1 - std::cos(angle))};
      }
      state.place.back() = {0, 2 * radius()};
    }
    state.strain.assign(points, at_.by_segments() ? strain : strain * (1 + strain));
    state.segment_strain.assign(points - 1, strain);
    state.segment_length.assign(points - 1, 0.5 * at_.tube.perimeter / count_);
    return state;
  }

  static constexpr double pi = std::numbers::pi;
  Settings settings_;
  FilledTube at_;
  reference::GeoTube exact_;
  int count_;  // segments
  std::vector<std::array<double, 2>> rest_;
  std::vector<std::array<double, 5>> rows_;
  std::array<double, 5> sums_{};  // over the time averaged: of time, width, height, contact, tension
  double largest_ = 0, time_ = 0;
};

std::vector<StudyPlan> studies() {
  const std::vector<double> finer{20, 40, 80, 160, 320};
  return {study("default", "at rest in its shape", "Order 2 of the tension, between 1 and 2 of the shape.",
                {40, 56, 80, 112, 160})
              .in_full(finer),
          study("accumulated", "at rest, strain summed from rates",
                "No order: strains of single points drift in null-space modes of the maps.", {40, 80})
              .with({york_strain()})
              .in_full(finer),
          study("from-circle", "from a circle, with drag", "As at rest, once it has settled.", {28, 40, 56})
              .with({{"start", "circle"}, {"damping", 40.0}, {"rounds", 10.0}})
              .in_full({20, 28, 40, 56, 80})
              .pictured(25)};
}

std::vector<CaseGate> gates() {
  const reference::GeoTube tube(FilledTube().tube);
  const double tension = tube.tension().value, height = tube.height().value, width = tube.width().value,
               contact = tube.contact_width().value;
  const auto required = [](std::string study, std::string measure, double level, double error, const char* why) {
    return gate(study + "/" + measure + "-" + to_text(level), error_at(measure, level), at_most(error),
                requirement(why));
  };
  return {
      required("default", "departure", 80, 1e-4,
               "at rest: no point leaves its place by more than 1e-4 of the height, 0.002 cells"),
      gate("default/departure-order", fitted_order_of("departure"), at_least(1),
           theory("the jump of curvature at the end of the contact, spread over a cell, allows 1")),
      gate("default/tension-40", error_at("tension", 40), at_most(1e-3 * tension),
           theory("chords of h/4 over the smallest radius T/p0 = 0.25 m: (l/R)^2/24 = 4e-4, and the same share for "
                  "the maps")),
      gate("default/tension-order", fitted_order_of("tension"), at_least(1.8),
           theory("chords of an arc: order 2; 0.2 for the swing about the rest")),
      required("default", "height", 80, 1e-4 * height,
               "within 0.01 % of the exact height, 0.002 cells, as its points at rest"),
      required("default", "width", 80, 1e-4 * width,
               "within 0.01 % of the exact width, a few thousandths of a cell, as its points at rest"),
      gate("default/contact-80", error_at("contact_width", 80), at_most(1e-3 * contact),
           requirement("within 0.1 % of the exact width in contact, whose ends stand anywhere in a cell: 0.02 cells")),
      gate("from-circle/departure-56", error_at("departure_at_end", 56), at_most(3.1e-3),
           theory("where it leaves the floor nodes bend the membrane over a cell; in half a cell its curvature p0/T "
                  "makes a height of p0 h^2/8T, 0.0031 of the tube's")),
      gate("from-circle/contact-56", error_at("contact_width", 56), at_most(2 * 4.0 / 56),
           theory("a cell at either end: the kernel feels the floor from there")),
      required("from-circle", "tension", 56, 1e-3 * tension, "within 0.1 % of the exact tension, as at rest"),
      required("from-circle", "height", 56, 1e-3 * height, "within 0.1 % of the exact height, a hundredth of a cell"),
      required("accumulated", "tension", 80, 1e-3 * tension,
               "within 0.1 % of the exact tension in the mean over the points, as with segments"),
      required("accumulated", "departure", 80, 1e-4,
               "at rest: no point leaves its place by more than 1e-4 of the height, as with segments")
          .fails("nodes feel only what a cell's points pull together: strains of single points drift apart in "
                 "null-space modes of the maps, and points with them",
                 {2.8e-4, 3.7e-4}, "2026-11-30 eac60cb"),
      gate("from-circle/departure-order", fitted_order_of("departure_at_end"), at_least(1),
           theory("a height of p0 h^2/8T at the end of the contact: order 2, 1 while it still lies down"))
          .in(Tier::full)};
}

// York's Courant number counts cells of a metre.
Override york_step(const Settings& settings) {
  const FilledTube at(settings);
  return york_string_step(settings, std::sqrt(at.stiffness / at.line_density) / at.tube.perimeter);
}

Case geo_tube() {
  return {.name = "geo-tube",
          .kind = Kind::membrane,
          .keys = FilledTube().keys(),
          .sets = {{"cells", 80.0}},
          .york1997 = {york_strain()},
          .york_step = york_step,
          .problem = run_of<GeoTubeRun>,
          .studies = studies(),
          .gates = gates(),
          .levels = {40, 56, 80, 112, 160}};
}
PLUMBLINE_CASE(geo_tube);

}  // namespace
}  // namespace plumbline::geo_tube
