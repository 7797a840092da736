// Two round sheets in space, sewn together at their rims and blown up: wrinkled nearly everywhere.
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "cases/catalog/membrane/surface_case.hpp"
#include "cases/harness/description/archive.hpp"
#include "cases/harness/description/schemes.hpp"
#include "cases/harness/files/whole.hpp"
#include "cases/harness/judge/gates.hpp"
#include "reference/circular_membrane.hpp"

namespace plumbline::mylar_balloon {
namespace {

// One struct for points and reference. Times are in radii at rest over the speed of waves at rest.
struct SewnSheets : SurfaceCase {
  double load, drag, end;

  explicit SewnSheets(Parameters given = {}) : SurfaceCase(std::move(given)) {
    choice.law.one_way = true;
    load = within("load", 0.01, "1", 0, 0.2, "q = p a / (E t)");
    drag = not_negative("drag", 1, "1", "against the velocity, over the speed of waves and the radius");
    end = positive("end", 8, "1", "time of the end");
  }
};

class MylarBalloonRun final : public Problem {
 public:
  explicit MylarBalloonRun(const Settings& settings)
      : settings_(settings),
        at_(settings_),
        exact_({at_.load, at_.choice.law.poissons_ratio, at_.size}) {
    const Columns points = scene().bodies.front().points;
    for (int p = 0; p < points.points(); ++p) rings_[ring_of(points, p)].push_back(p);
    volume_ = volume(points);
  }

  double end_time() const override { return at_.end * at_.size / at_.speed(); }

  Scene scene() const override {
    Scene scene;
    scene.grid = surface_grid(at_, settings_, exact_.rim_radius().value, exact_.half_height().value);
    const double h = scene.grid.h;
    Body balloon = surface_body("balloon", at_.choice, points(), h);
    press(
        balloon, at_, [p = at_.pressure(at_.load)](double, const Columns&) { return p; },
        at_.drag * at_.speed() / at_.size);
    scene.bodies.push_back(std::move(balloon));
    apply_choices(settings_, scene);
    return scene;
  }

  void observe(const Simulation& simulation) override {
    const Columns& points = simulation.scene().bodies.front().points;
    rows_.push_back({simulation.time(), rim(points), pole(points), volume(points)});
  }
  void history(Archive& archive) override { archive("rows", rows_); }

  std::vector<Measure> measures(const Simulation& simulation) const override {
    const Columns& points = simulation.scene().bodies.front().points;
    const auto against = [](const char* name, double value, const reference::Bounded& exact, const char* unit) {
      return scalar_measure(name, value, exact.value, exact.bound, unit);
    };
    std::vector<Measure> all = error_norms("shape", "m", off_shape(points));
    all.push_back(against("rim", rim(points), exact_.rim_radius(), "m"));
    all.push_back(against("height", pole(points), exact_.half_height(), "m"));
    all.push_back(
        scalar_measure("volume", rows_.back()[3] / volume_, 1, exact_.volume().bound / exact_.volume().value, "1"));
    return all;
  }

  Profile profile(const Simulation&) const override {
    return history_profile({{"time", "s", "time", {}},
                            {"rim", "m", "radius of the seam", {}},
                            {"height", "m", "half height", {}},
                            {"volume", "m^3", "volume", {}}},
                           rows_);
  }

 private:
  // Both sheets in rings of equal width at rest, where the exact solution has
  // them. What is wrinkled is put together around the axis: the length of the
  // second tangent is r/s. Across the seam the surface goes on, so that its neighbours do.
  std::vector<SurfacePoint> points() const {
    const int rings = ring_count();
    const double wide = ring_width();
    std::vector<SurfacePoint> all;
    for (const double side : {1.0, -1.0}) {
      for (int k = 0; k < rings; ++k) {
        const double s = (k + 0.5) * wide;
        const reference::MembranePoint here = exact_.at(s), in = exact_.at(s - 0.01 * wide),
                                       out = exact_.at(s + 0.01 * wide);
        const double r = here.radius.value, z = side * here.height.value;
        const double dr = (out.radius.value - in.radius.value), dz = side * (out.height.value - in.height.value);
        const double along = here.meridian_stretch.value / std::hypot(dr, dz);
        const int count = std::max(3, whole(std::round(2 * std::numbers::pi * (k + 0.5))));
        for (int j = 0; j < count; ++j) {
          const double angle = 2 * std::numbers::pi * (j + 0.5 * (k % 2)) / count, c = std::cos(angle),
                       sn = std::sin(angle);
          const Vec3 meridian{along * dr * c, along * dr * sn, along * dz}, hoop{-r / s * sn, r / s * c, 0};
          const double area = 2 * std::numbers::pi * s * wide / count;
          // Outwards is up on the upper sheet: the meridian from the middle times the way around, turned over below.
          all.push_back(side > 0 ? SurfacePoint{{r * c, r * sn, z}, meridian, hoop, area}
                                 : SurfacePoint{{r * c, r * sn, z}, hoop, meridian, area});
        }
      }
    }
    return all;
  }

  // Of the start, where r/s is the length of the tangent around the axis.
  int ring_of(const Columns& points, int p) const {
    const bool above = points(column::position, 2)[p] > 0;
    const int around = above ? 3 : 0;
    const double r = std::hypot(points(column::position, 0)[p], points(column::position, 1)[p]);
    const double s = r / std::hypot(points(column::tangents, around)[p], points(column::tangents, around + 1)[p]);
    const int ring = static_cast<int>(std::lround(std::floor(s / ring_width())));
    return above ? ring : 2 * ring_count() - 1 - ring;
  }
  int ring_count() const {
    const double spacing = at_.size / (settings_.number("cells") * std::sqrt(settings_.number("ppc")));
    return std::max(4, whole(std::round(at_.size / spacing)));
  }
  double ring_width() const { return at_.size / ring_count(); }

  // Of each point, the distance in its meridian's plane from where the exact solution has it.
  std::vector<ErrorSample> off_shape(const Columns& points) const {
    std::vector<ErrorSample> samples;
    for (const auto& [ring, own] : rings_) {
      const bool above = ring < ring_count();
      const double s = ((above ? ring : 2 * ring_count() - 1 - ring) + 0.5) * ring_width();
      const reference::MembranePoint exact = exact_.at(s);
      for (const int p : own) {
        const double r = std::hypot(points(column::position, 0)[p], points(column::position, 1)[p]);
        const double z = (above ? 1 : -1) * points(column::position, 2)[p];
        samples.push_back({points(column::volume)[p], std::hypot(r - exact.radius.value, z - exact.height.value),
                           exact.radius.value, exact.radius.bound + exact.height.bound});
      }
    }
    return samples;
  }

  // Frustums between the means of the rings. Their error is of second order and the same at the start.
  double volume(const Columns& points) const {
    double sum = 0, radius = 0, height = 0;
    for (const auto& [ring, own] : rings_) {
      double r = 0, z = 0;
      for (const int p : own) {
        r += std::hypot(points(column::position, 0)[p], points(column::position, 1)[p]) /
             static_cast<double>(own.size());
        z += points(column::position, 2)[p] / static_cast<double>(own.size());
      }
      if (ring > 0) sum += std::numbers::pi / 3 * (r * r + r * radius + radius * radius) * (height - z);
      radius = r;
      height = z;
    }
    return sum;
  }

  // By parabolas: of the seam distances from the axis by heights, of the poles heights by distances from the axis.
  double rim(const Columns& points) const { return vertex(points, true); }
  double pole(const Columns& points) const { return vertex(points, false); }

  double vertex(const Columns& points, bool seam) const {
    // Two rings at least, or there is no parabola.
    const double near = larger(seam ? 0.25 * exact_.half_height().value : at_.size / 6, 2 * ring_width());
    std::vector<std::array<double, 2>> pairs;
    for (int p = 0; p < points.points(); ++p) {
      const double r = std::hypot(points(column::position, 0)[p], points(column::position, 1)[p]);
      const double z = std::abs(points(column::position, 2)[p]);
      if ((seam ? z : r) > near || (seam && r < 0.5 * exact_.rim_radius().value)) continue;
      pairs.push_back(seam ? std::array{z, r} : std::array{r, z});
    }
    return parabola_vertex(pairs);
  }

  Settings settings_;
  SewnSheets at_;
  reference::MylarBalloon exact_;
  // Points by sheet and ring, from the upper pole to the lower.
  std::map<int, std::vector<int>> rings_;
  double volume_ = 0;  // of the exact shape, by the same sum
  std::vector<std::array<double, 4>> rows_;
};

const std::vector<double> meshes{6, 8, 11, 16, 22};

std::vector<CaseGate> gates() {
  const auto relative = [](const char* measure, double level) {
    return number_at("relative error", measure, level, [](const RunResult&, const Measure& of) {
      return Measured::of(std::abs(of.error / *of.reference));
    });
  };
  std::vector<CaseGate> all;
  for (const Tier tier : {Tier::quick, Tier::full}) {
    const std::string study = tier == Tier::quick ? "default" : "shifted";
    all.push_back(
        gate(study + "/rim-8", relative("rim", 8), at_most(5e-4), requirement("half a thousandth of the seam's radius"))
            .in(tier));
    all.push_back(gate(study + "/volume-8", relative("volume", 8), at_most(4e-4),
                       requirement("four ten-thousandths of the volume"))
                      .in(tier));
    all.push_back(
        gate(study + "/height-8", relative("height", 8), at_most(2.5e-3),
             requirement("a four-hundredth of the half height: at the poles alone the sheet is taut both ways"))
            .in(tier)
            .fails(
                "the poles sink as the wrinkled sheet relaxes towards its own rest; nine points to the square of the "
                "cell size, or neighbours within 2.4 spacings, leave half of it",
                {2.55e-3, 3.4e-3}, "2026-11-26 cc07b92"));
  }
  all.push_back(gate("default/shape-order", fitted_order_of("shape.L1"), at_least(1.8),
                     theory("maps, neighbours and rings of equal width are of second order, and so is how fast points "
                            "move off the exact shape; 0.2 for the coarsest mesh"))
                    .in(Tier::full));
  all.push_back(gate("default/rim-order", fitted_order_of("rim"), at_least(1.7),
                     requirement("second order; the parabola read off the exact points is wrong by up to 5e-5 at any "
                                 "cell size, a third of the error at the finest, which takes up to 0.3"))
                    .in(Tier::full));
  return all;
}

Case mylar_balloon() {
  return {
      .name = "mylar-balloon",
      .kind = Kind::membrane,
      .keys = SewnSheets().keys(),
      .sets = {{"cells", 8.0}},
      .york_step = courant_number(0.3),
      .problem = run_of<MylarBalloonRun>,
      .studies =
          {study("default", "default", "Order 2: each point from its place on the exact shape.", {8})
               .in_full(meshes)
               .pictured(2, 8),
           study("shifted", "the grid moved by a part of a cell", "At rest.", {8}).with(shifted_grid()).in(Tier::full)},
      .gates = gates(),
      .levels = meshes};
}
PLUMBLINE_CASE(mylar_balloon);

}  // namespace
}  // namespace plumbline::mylar_balloon
