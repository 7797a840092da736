// Two square sheets in space, sewn together at their edges and blown up. Shown, not judged against a figure.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "cases/catalog/membrane/surface_case.hpp"
#include "cases/harness/description/archive.hpp"
#include "cases/harness/description/schemes.hpp"
#include "cases/harness/files/whole.hpp"
#include "cases/harness/judge/gates.hpp"
#include "cases/harness/verify/restart_gate.hpp"

namespace plumbline::square_airbag {
namespace {

// Lengths are over half an edge at rest, `size`; times over that and the speed of waves at rest.
struct SquareBag : SurfaceCase {
  double load, drag, end;

  explicit SquareBag(Parameters given = {}) : SurfaceCase(std::move(given)) {
    choice.law.one_way = true;
    load = within("load", 0.006, "1", 0, 0.2, "q = p a / (E t), a half of an edge");
    drag = not_negative("drag", 0.2, "1", "against the velocity, over the speed of waves and half an edge");
    end = positive("end", 60, "1", "time of the end");
  }
};

class SquareAirbagRun final : public Problem {
 public:
  explicit SquareAirbagRun(const Settings& settings) : settings_(settings), at_(settings_) {}

  double end_time() const override { return at_.end * at_.size / at_.speed(); }

  Scene scene() const override {
    Scene scene;
    scene.grid = surface_grid(at_, settings_, at_.size, 0.7 * at_.size);
    Body bag = surface_body("bag", at_.choice, points(scene.grid.h), scene.grid.h);
    press(
        bag, at_, [p = at_.pressure(at_.load)](double, const Columns&) { return p; },
        at_.drag * at_.speed() / at_.size);
    scene.bodies.push_back(std::move(bag));
    apply_choices(settings_, scene);
    return scene;
  }

  void observe(const Simulation& simulation) override {
    const Columns& points = simulation.scene().bodies.front().points;
    rows_.push_back({simulation.time(), height(points), enclosed_volume(points, at_.thickness())});
  }
  void history(Archive& archive) override { archive("rows", rows_); }

  std::vector<Measure> measures(const Simulation& simulation) const override {
    const Columns& points = simulation.scene().bodies.front().points;
    return {scalar_measure("height", height(points), 0, 0, "m"), scalar_measure("pull", pull(points), 0, 0, "m"),
            scalar_measure("volume", enclosed_volume(points, at_.thickness()), 0, 0, "m^3"),
            share_measure("wrinkled", wrinkled(points))};
  }

  Profile profile(const Simulation&) const override {
    return history_profile(
        {{"time", "s", "time", {}}, {"height", "m", "half height in the middle", {}}, {"volume", "m^3", "volume", {}}},
        rows_);
  }

 private:
  // Both sheets are flat at rest and stand a little apart, since what lies on the same nodes is not pushed apart. Along the edges
  // a row of points sews them, neighbours of both, with next to no area.
  std::vector<SurfacePoint> points(double h) const {
    constexpr double of_seam = 1e-3;  // of the area of others: their mass is not to be none
    constexpr double apart = 0.05;    // in the middle
    const int rows = std::max(4, whole(std::round(2 * at_.size / h * std::sqrt(settings_.number("ppc")))));
    const double spacing = 2 * at_.size / rows, area = spacing * spacing;
    const Vec3 x{1, 0, 0}, y{0, 1, 0};
    std::vector<SurfacePoint> all;
    const auto at = [&](int k) { return (k + 0.5) * spacing - at_.size; };
    for (int i = 0; i < rows; ++i) {
      for (int j = 0; j < rows; ++j) {
        const double u = at(i) / at_.size, v = at(j) / at_.size;
        const double up = apart * at_.size * (1 - u * u) * (1 - v * v);
        all.push_back({{at(i), at(j), up}, x, y, area, 0});
        all.push_back({{at(i), at(j), -up}, y, x, area, 1});
      }
      for (const double side : {-at_.size, at_.size}) {
        all.push_back({{at(i), side, 0}, x, y, of_seam * area, -1});
        all.push_back({{side, at(i), 0}, x, y, of_seam * area, -1});
      }
    }
    return all;
  }

  // Half of how far the sheets are apart in the middle.
  double height(const Columns& points) const {
    double sum = 0;
    int count = 0;
    for (int p = 0; p < points.points(); ++p) {
      if (std::max(std::abs(points(column::position, 0)[p]), std::abs(points(column::position, 1)[p])) > 0.1 * at_.size)
        continue;
      sum += std::abs(points(column::position, 2)[p]);
      ++count;
    }
    return sum / count;
  }
  // How far the middles of the edges have moved inward.
  double pull(const Columns& points) const {
    double widest = 0;
    for (int p = 0; p < points.points(); ++p) {
      if (std::abs(points(column::position, 1)[p]) < 0.1 * at_.size)
        widest = larger(widest, std::abs(points(column::position, 0)[p]));
    }
    return at_.size - widest;
  }
  // Of the points.
  double wrinkled(const Columns& points) const {
    double count = 0;
    for (int p = 0; p < points.points(); ++p)
      count += at_.choice.law.principal_stresses(metric_of(points, p)).least <= 0;
    return count / points.points();
  }

  Settings settings_;
  SquareBag at_;
  std::vector<std::array<double, 3>> rows_;
};

Case square_airbag() {
  return {.name = "square-airbag",
          .kind = Kind::membrane,
          .keys = SquareBag().keys(),
          .sets = {{"cells", 8.0}},
          .york_step = courant_number(0.3),
          .problem = run_of<SquareAirbagRun>,
          .studies = {study("default", "default", "None is judged: there are no two tables to compare with.", {8})
                          .with({{"poissons_ratio", 0.4}})
                          .pictured(8, 8)},
          .gates = {restart_gate("default", "runs of sheets that are sewn together")},
          .levels = {8}};
}
PLUMBLINE_CASE(square_airbag);

}  // namespace
}  // namespace plumbline::square_airbag
