// An infinite (periodic) string, taut or slack, along the grid or across it.
#include <algorithm>
#include <cmath>

#include "cases/catalog/membrane/string.hpp"
#include "cases/catalog/stability/map_scheme.hpp"
#include "cases/harness/files/errors.hpp"
#include "cases/harness/laboratory/problem.hpp"

namespace plumbline {
namespace {

// One period of a string of rational slope: `across` cells along x, `up` cells along y.
struct Period {
  int across = 1, up = 0;
  double length() const { return std::hypot(across, up); }
};

Period period_of(double slope) {
  for (int across = 1; across <= 4; ++across) {
    const double up = slope * across;
    if (std::abs(up - std::round(up)) < 1e-9) return {across, static_cast<int>(std::round(up))};
  }
  throw UsageError("slope", to_text(slope), "a fraction of 1, 2, 3 or 4", {},
                   "a string of the slope " + to_text(slope) + " does not repeat after 4 cells");
}

int points_of(const Settings& s) {
  const Period period = period_of(s.number("slope"));
  return std::max(1, static_cast<int>(std::round(s.integer("ppc") * period.length())));
}

constexpr double weak_growth = 2e-3;  // per step

class MembraneProblem final : public StabilityProblem {
 public:
  std::string name() const override { return "membrane"; }
  Kind kind() const override { return Kind::membrane; }
  std::vector<Key> keys() const override {
    return {
        {.name = "slope",
         .value = 0.0,
         .low = 0,
         .high = 1,
         .description = "of the string to the grid: a fraction of 1, 2, 3 or 4"},
        {.name = "strain", .value = 0.01, .low = -0.5, .high = 0.5, .description = "of the string; negative: slack"},
        {.name = "offset",
         .value = 0.25,
         .low = 0,
         .high = 1,
         .high_open = true,
         .description = "of the string above a node, in cells"},
        {.name = "place",
         .value = 0.5,
         .low = 0,
         .high = 1,
         .low_open = true,
         .high_open = true,
         .description = "of the points in their shares of the string"},
        {.name = "model",
         .value = "segments",
         .choices = {"segments", "accumulated"},
         .description = "of strain: the stretch of the segments between points, or summed from rates at the points"}};
  }
  std::vector<Override> choices(const std::string& scheme) const override {
    if (scheme == "york1997") return {{"model", "accumulated"}, {"ppc", 2.0}};
    return {{"ppc", 2.0}};
  }
  Patch patch(const Settings& s, const Extent& extent) const override {
    const Period period = period_of(s.number("slope"));
    const int count = points_of(s), periods = extent.core + 2 * extent.margin;
    const double strain = s.number("strain");
    constexpr int beside = 3;  // cells between the string and the ends of the grid
    Patch patch;
    GridSpec& grid = patch.scene.grid;
    grid.dim = 2;
    grid.cells = {periods * period.across + 2 * beside, periods * period.up + 2 * beside, 1};
    apply_choices(s, patch.scene);
    const auto at = [&](double share) {
      return std::array<double, 2>{beside + share * period.across, beside + s.number("offset") + share * period.up};
    };
    const int points = periods * count;
    const double first = s.number("place") / count;
    const StringState state = straight_string(at(first), at(first + static_cast<double>(points - 1) / count), points,
                                              strain);
    patch.scene.bodies.push_back(string_body("string", s.text("model"), {.youngs_modulus = 1, .area = 1, .density = 1},
                                             state, 2, StringEnds::whole));
    // Tension throws the ends where their nodes are light; what lies beyond the margin may as well be heavy.
    double* mass = patch.scene.bodies[0].points(column::mass);
    mass[0] *= 1e6;
    mass[points - 1] *= 1e6;
    patch.directions = 1;
    patch.step[0] = {1.0 * period.across, 1.0 * period.up, 0};
    patch.places.emplace_back();
    for (int p = 0; p < points; ++p) patch.places[0].push_back({{p / count - extent.margin, 0}, p % count});
    return patch;
  }
  Scan scan(const Settings&) const override { return {.low = 0.1, .high = 3, .steps = 9}; }
  // Growth of less than `weak` a step is not counted: long waves across the string have it at every step, or from half the limit on.
  Prediction predicted(const Settings& settings, const Scan& scan, double width) const override {
    const Experiment experiment = experiment_of(*this, settings);
    constexpr int reach = 4;
    const Patch patch = experiment.patch({1, reach});
    Prediction prediction = predict(
        [&](double dt, const std::vector<WaveNumber>& hints) -> Growth {
          const Amplification a(patch, experiment.integrator, experiment.positions, dt);
          const WorstWave worst = worst_wave(a, 1, hints);
          return {dt, worst.radius <= 1 + weak_growth ? std::min(1.0, worst.radius) : worst.radius, worst.theta};
        },
        scan, std::max(width, 1e-5));
    prediction.reach = reach;
    return prediction;
  }
  // A slack string drifts: its points go on with the velocity they have.
  Watch watch(const Settings&) const override { return {.core = 24, .steps = 1500, .slowest = weak_growth}; }
  std::optional<ClosedForm> closed_form(const Settings& s) const override {
    const auto scheme = map_scheme(s);
    const bool along = s.number("slope") == 0, accumulated = s.text("model") == "accumulated";
    if (!scheme || !along || !accumulated || s.number("strain") <= 0) return std::nullopt;
    const int ppc = s.integer("ppc");
    const auto points = reference::regular_points(ppc, (s.number("place") - 0.5) / ppc);
    return ClosedForm{reference::periodic_courant_limit(*scheme, points).value,
                      "that of a bar, reference/mpm_amplification.hpp"};
  }
  bool quickly_listed(bool explicit_step) const override { return explicit_step; }
  std::vector<std::vector<Override>> listed() const override { return {{{"slope", 0.0}, {"offset", 0.25}}}; }
  // Along the grid at all sampled places; across it, where these matter little, at one.
  std::vector<Occurrence> occurrences(const SceneContents& scene) const override {
    std::vector<Occurrence> all;
    for (const SceneContents::Part& chain : scene.of(SceneContents::Matter::chain)) {
      const auto add = [&](double slope, double place) {
        all.push_back({{{"model", chain.segments ? "segments" : "accumulated"},
                        {"ppc", 1.0 * chain.per_cell},
                        {"slope", slope},
                        {"offset", place},
                        {"place", place}}});
      };
      for (const double place : sampled_places) add(0, place);
      if (scene.dim > 1) add(1, sampled_places.front());
    }
    return all;
  }
  std::vector<MapPlan> maps(Tier tier) const override {
    const bool full = tier == Tier::full;
    const std::vector<double> offsets = full ? std::vector<double>{0.05, 0.2, 0.35, 0.5}
                                             : std::vector<double>{0.05, 0.5};
    std::vector<MapPlan> all;
    for (const char* scheme : {"default", "york1997"}) {
      all.push_back({.kind = "limit",
                     .title = "largest stable step over slope and offset",
                     .scheme = scheme,
                     .x = {"offset", "offset of the string above a node", offsets},
                     .y = {"slope", "slope of the string to the grid", {0, 0.5, 1}}});
      all.push_back({.kind = "limit",
                     .title = "largest stable step over strain and points per cell",
                     .scheme = scheme,
                     .x = {"strain", "strain of the string",
                           full ? std::vector<double>{0.001, 0.01, 0.05, 0.2} : std::vector<double>{0.01, 0.1}},
                     .y = {"ppc", "points per cell", full ? std::vector<double>{1, 2, 4} : std::vector<double>{1, 2}}});
    }
    return all;
  }
};

PLUMBLINE_STABILITY_PROBLEM(MembraneProblem);

}  // namespace
}  // namespace plumbline
