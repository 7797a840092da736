// A flat round sheet in space, clamped at its rim, is blown up by a pressure.
#include <algorithm>
#include <cmath>

#include "cases/catalog/membrane/surface_case.hpp"
#include "cases/harness/description/archive.hpp"
#include "cases/harness/description/schemes.hpp"
#include "cases/harness/judge/gates.hpp"
#include "reference/circular_membrane.hpp"

namespace plumbline::circular_membrane {
namespace {

// One struct for points and reference. Times are in radii over the speed of waves at rest.
struct CircularSheet : SurfaceCase {
  double load, drag, end, rows;

  explicit CircularSheet(Parameters given = {}) : SurfaceCase(std::move(given)) {
    load = within("load", 0.05, "1", 0, 0.5, "q = p a / (E t)");
    drag = not_negative("drag", 1, "1", "against the velocity, over the speed of waves and the radius");
    end = positive("end", 30, "1", "time of the end");
    rows = number({.name = "clamped_rows",
                   .value = 3.0,
                   .low = 0,
                   .high = 10,
                   .description = "points this many spacings from the rim have images behind it"});
  }
};

class CircularSheetRun final : public Problem {
 public:
  explicit CircularSheetRun(const Settings& settings)
      : settings_(settings),
        at_(settings_),
        exact_({at_.load, at_.choice.law.poissons_ratio, at_.size}) {}

  double end_time() const override { return at_.end * at_.size / at_.speed(); }

  Scene scene() const override {
    Scene scene;
    scene.grid = surface_grid(at_, settings_, at_.size, 1.5 * exact_.height().value);
    const double h = scene.grid.h, spacing = h / std::sqrt(settings_.number("ppc"));
    Body sheet = surface_body("sheet", at_.choice, disk_points(at_.size, spacing, 1), h, [&](const Columns& points) {
      return images_behind_rim(points, at_.size, at_.rows * spacing);
    });
    press(
        sheet, at_, [p = at_.pressure(at_.load)](double, const Columns&) { return p; },
        at_.drag * at_.speed() / at_.size);
    scene.bodies.push_back(std::move(sheet));
    apply_choices(settings_, scene);
    return scene;
  }

  void observe(const Simulation& simulation) override {
    rows_.push_back({simulation.time(), middle_height(simulation.scene().bodies.front().points)});
  }
  void history(Archive& archive) override { archive("rows", rows_); }

  std::vector<Measure> measures(const Simulation& simulation) const override {
    const Body& body = simulation.scene().bodies.front();
    const reference::Bounded height = exact_.height();
    std::vector<ErrorSample> samples;
    for (int p = 0; p < body.points.points(); ++p) samples.push_back(off_shape(body, p));
    std::vector<Measure> all = error_norms("shape", "m", samples);
    all.push_back(scalar_measure("height", middle_height(body.points), height.value, height.bound, "m"));
    return all;
  }

  Profile profile(const Simulation& simulation) const override {
    const Body& body = simulation.scene().bodies.front();
    Profile profile;
    profile.abscissa = "radius";
    std::vector<std::pair<double, int>> order;
    for (int p = 0; p < body.points.points(); ++p) order.emplace_back(distance(body.points, p), p);
    std::sort(order.begin(), order.end());
    std::vector<double> radius, height, exact;
    for (const auto& [r, p] : order) {
      radius.push_back(r);
      height.push_back(body.points(column::position, 2)[p]);
      exact.push_back(exact_.at(rest_of(body, p)).height.value);
    }
    profile.columns = {{"radius", "m", "distance from the middle", radius},
                       {"height", "m", "height", height},
                       {"exact", "m", "exact height of the same point", exact}};
    return profile;
  }

 private:
  static double distance(const Columns& points, int p) {
    return std::hypot(points(column::position, 0)[p], points(column::position, 1)[p]);
  }
  // Where the point was at rest.
  double rest_of(const Body& body, int p) const {
    return rest_.at(static_cast<std::size_t>(body.id[static_cast<std::size_t>(p)]));
  }

  ErrorSample off_shape(const Body& body, int p) const {
    const reference::MembranePoint exact = exact_.at(rest_of(body, p));
    const double off = std::hypot(distance(body.points, p) - exact.radius.value,
                                  body.points(column::position, 2)[p] - exact.height.value);
    return {body.points(column::volume)[p], off, exact.height.value, exact.radius.bound + exact.height.bound};
  }

  // By the parabola w_0 + c r^2 closest to the points of the inner sixth of the radius, where r^4 adds some 1e-5 of it.
  double middle_height(const Columns& points) const {
    std::vector<std::array<double, 2>> pairs;
    for (int p = 0; p < points.points(); ++p) {
      const double r = distance(points, p);
      if (r <= at_.size / 6) pairs.push_back({r, points(column::position, 2)[p]});
    }
    return parabola_vertex(pairs);
  }

  std::vector<double> rests() const {
    const Body start = scene().bodies.front();
    std::vector<double> all;
    for (int p = 0; p < start.points.points(); ++p) all.push_back(distance(start.points, p));
    return all;
  }

  Settings settings_;
  CircularSheet at_;
  reference::CircularMembrane exact_;
  std::vector<double> rest_ = rests();
  std::vector<std::array<double, 2>> rows_;
};

std::vector<CaseGate> gates() {
  const auto relative = [](double level) {
    return number_at("relative error of the height", "height", level, [](const RunResult&, const Measure& height) {
      return Measured::of(std::abs(height.error / *height.reference));
    });
  };
  const Because height = requirement(
      "a thousandth of the height in the middle, at the load of "
      "the run: at no load it is 1.3 % lower");
  return {gate("default/height-8", relative(8), at_most(1e-3), height),
          gate("default/height-16", relative(16), at_most(1e-3), height).in(Tier::full),
          gate("shifted/height-8", relative(8), at_most(1e-3), height).in(Tier::full)};
}

Case circular_membrane() {
  return {
      .name = "circular-membrane",
      .kind = Kind::membrane,
      .keys = CircularSheet().keys(),
      .sets = {{"cells", 8.0}},
      .york_step = courant_number(0.3),
      .problem = run_of<CircularSheetRun>,
      .studies =
          {study("default", "default", "At rest; no order: what is left is of the rim.", {8})
               .in_full({8, 16})
               .pictured(2, 8),
           study("shifted", "the grid moved by a part of a cell", "At rest.", {8}).with(shifted_grid()).in(Tier::full)},
      .gates = gates(),
      .levels = {8, 16}};
}
PLUMBLINE_CASE(circular_membrane);

}  // namespace
}  // namespace plumbline::circular_membrane
