// A neo-Hookean membrane in space, closed to a sphere around a gas, comes to rest.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "cases/catalog/membrane/surface_case.hpp"
#include "cases/harness/description/archive.hpp"
#include "cases/harness/description/schemes.hpp"
#include "cases/harness/judge/gates.hpp"
#include "cases/harness/verify/restart_gate.hpp"
#include "reference/pressurised_sphere.hpp"

namespace plumbline::balloon {
namespace {

// One struct for points and reference. Times are in radii at rest over sqrt(E / ((1 - nu^2) rho)), the speed of waves at rest.
struct Balloon : SurfaceCase {
  double stretch, excess, drag, early, end, jitter;
  std::string areas;

  explicit Balloon(Parameters given = {}) : SurfaceCase(std::move(given), true) {
    choose_weights();
    stretch = number(
        {.name = "stretch", .value = 1.2, .low = 1, .high = 4, .low_open = true, .description = "at the start"});
    excess = not_negative("excess", 3e-3, "1", "by which the stretch at the start is larger than at rest");
    drag = not_negative("drag", 2, "1", "against the velocity, over the speed of waves and the radius");
    early = positive("early", 8, "1", "time at which the pressure is read first");
    end = positive("end", 16, "1", "time of the end");
    jitter = number({.name = "jitter",
                     .value = 0.0,
                     .low = 0,
                     .high = 0.5,
                     .description = "how far points are moved at random along the sphere, over their spacing"});
    areas = one_of("areas", "swept", {"swept", "equal"},
                   "that points moved at random stand for: by the density of points, or all alike");
  }

  double seconds(double time) const { return time * size / speed(); }
  reference::PressurisedSphereProblem problem() const {
    const SurfaceLaw& law = choice.law;
    return {.youngs_modulus = law.youngs_modulus,
            .poisson_ratio = law.poissons_ratio,
            .thickness = law.thickness,
            .density = law.density,
            .radius = size,
            .stretch = stretch,
            .neo_hookean = true};
  }
};

class BalloonRun final : public Problem {
 public:
  explicit BalloonRun(const Settings& settings) : settings_(settings), at_(settings_), exact_(at_.problem()) {}

  double end_time() const override { return at_.seconds(at_.end); }

  Scene scene() const override { return scene_of(at_.choice); }
  Scene unprepared() const override { return scene_of(with_fitted_weights(at_.choice)); }

  void observe(const Simulation& simulation) override {
    const Columns& points = simulation.scene().bodies.front().points;
    if (simulation.time() <= at_.seconds(at_.early)) early_ = pressure(points);
    rows_.push_back({simulation.time(), mean_radius(points) / at_.size, pressure(points)});
  }
  void history(Archive& archive) override {
    archive("early", early_);
    archive("rows", rows_);
  }

  std::vector<Measure> measures(const Simulation& simulation) const override {
    const Columns& points = simulation.scene().bodies.front().points;
    const double radius = mean_radius(points), stretch = radius / at_.size, p = pressure(points);
    const std::vector<double> pulls = resultants(points, at_.choice.law);
    double mean = 0, scatter = 0, worst = 0;
    for (const double pull : pulls) mean += pull / static_cast<double>(pulls.size());
    for (const double pull : pulls) {
      scatter += std::pow(pull / mean - 1, 2) / static_cast<double>(pulls.size());
      worst = larger(worst, std::abs(pull / mean - 1));
    }
    const reference::Bounded at_rest = exact_.pressure(stretch);
    const SphereTangents tangents = tangents_of_sphere(points, at_.size);
    return {scalar_measure("pressure", p / at_rest.value, 1, at_rest.bound / at_rest.value, "1"),
            scalar_measure("resultant", mean / (0.5 * p * radius), 1, 0, "1"),
            share_measure("tangents", std::abs(tangents.mean)),
            share_measure("tangents.rms", tangents.rms),
            share_measure("scatter", std::sqrt(scatter)),
            share_measure("scatter.worst", worst),
            share_measure("creep", std::abs(p / early_ - 1))};
  }

  Profile profile(const Simulation&) const override {
    return history_profile({{"time", "s", "time", {}},
                            {"stretch", "1", "mean radius over that at rest", {}},
                            {"pressure", "Pa", "pressure of the gas", {}}},
                           rows_);
  }

 private:
  Scene scene_of(const SurfaceChoice& choice) const {
    Scene scene;
    const double radius = at_.size * at_.stretch;
    scene.grid = surface_grid(at_, settings_, radius, radius);
    const double h = scene.grid.h;
    const int count = surface_points_on(4 * std::numbers::pi * at_.size * at_.size, settings_, h);
    std::vector<SurfacePoint> points = sphere_points(count, at_.size, at_.stretch + at_.excess);
    if (at_.jitter > 0) move_at_random(points, at_.jitter);
    if (at_.jitter > 0 && at_.areas == "swept") sweep_areas(points);
    Body balloon = surface_body("balloon", choice, std::move(points), h);
    press(
        balloon, at_, [this](double, const Columns& of) { return pressure(of); }, at_.drag * at_.speed() / at_.size);
    scene.bodies.push_back(std::move(balloon));
    apply_choices(settings_, scene);
    return scene;
  }

  // Of a gas of one temperature that holds the balloon at the start: steeper than the balloon's own at any stretch, so that
  // also beyond its highest pressure the balloon is at rest in one place only.
  double pressure(const Columns& points) const {
    const double radius = at_.size * at_.stretch, volume = 4 * std::numbers::pi / 3 * radius * radius * radius;
    return exact_.pressure(at_.stretch).value * volume / enclosed_volume(points, at_.thickness());
  }

  Settings settings_;
  Balloon at_;
  reference::PressurisedSphere exact_;
  double early_ = 0;
  std::vector<std::array<double, 3>> rows_;
};

const std::string stamp = "2026-11-26 43deee6";

std::vector<StudyPlan> studies() {
  std::vector<StudyPlan> all{
      study("default", "default", "At rest; no order: what is left is of irregular points.", {8}).in_full({4, 8, 16}),
      study("large", "stretched to twice its size", "At rest, beyond the highest pressure.", {8})
          .with({{"stretch", 2.0}})
          .pictured(2),
      study("large-fitted", "the same with fitted weights", "Forces of a uniform tension are left, a little.", {8})
          .with({{"stretch", 2.0}, {"weights", "fitted"}})
          .in(Tier::full),
      study("shifted", "the grid moved by a part of a cell", "At rest.", {8}).with(shifted_grid()).in(Tier::full),
      study("long", "to four times the first reading", "At rest.", {8}).with({{"end", 32.0}}).in(Tier::full),
      study("jittered", "points moved at random by .3 of their spacing", "At rest.", {8})
          .with({{"jitter", 0.3}, {"end", 8.0}})
          .in(Tier::full),
      study("jittered-fitted", "the same with fitted weights", "Forces of a uniform tension are left.", {8})
          .with({{"jitter", 0.3}, {"weights", "fitted"}, {"end", 8.0}})
          .in(Tier::full),
      study("equal-areas", "points moved at random that have equal areas", "At rest, whatever areas points stand for.",
            {8})
          .with({{"jitter", 0.3}, {"areas", "equal"}, {"end", 8.0}})
          .in(Tier::full),
      study("equal-areas-fitted", "the same with fitted weights", "Areas that are not those of the points.", {8})
          .with({{"jitter", 0.3}, {"areas", "equal"}, {"weights", "fitted"}, {"end", 8.0}})
          .in(Tier::full)};
  for (StudyPlan& wrong : wrong_tangents({8}))
    all.push_back(std::move(wrong).with({{"tangents", wrong.id}, {"end", 8.0}}));
  return all;
}

// The generic gate measures against what moves, and with balanced weights next to nothing does: against the pressure's impulse
// on one half.
const Number drift = number_of(
    "largest residual of momentum over the pressure's impulse on one half", [](const StudyResult& s) {
      double largest = 0;
      for (const StudyLevel& at : s.levels) {
        const Balloon balloon{Parameters(at.run.settings)};
        const double radius = balloon.size * balloon.stretch;
        const double push = reference::PressurisedSphere(balloon.problem()).pressure(balloon.stretch).value *
                            std::numbers::pi * radius * radius;
        for (const Account& direction : at.run.ledger.momentum)
          largest = larger(largest, direction.largest_residual() / (push * at.run.end_time));
      }
      return Measured::of(largest);
    });

std::vector<CaseGate> gates() {
  std::vector<CaseGate> all;
  const Because follows = requirement("the stretch of the tangents is that of the radius, to a ten-thousandth");
  const auto judged = [&](const std::string& study, Tier tier) {
    const auto add = [&](CaseGate made) { all.push_back(std::move(made).in(tier)); };
    add(gate(study + "/pressure-8", error_at("pressure", 8), at_most(1e-4),
             requirement("a ten-thousandth: stresses of a membrane at rest are exact but for irregular points")));
    add(gate(study + "/resultant-8", error_at("resultant", 8), at_most(1e-4),
             requirement("Laplace's law, 2 N = p R, as the pressure")));
    add(gate(study + "/scatter-8", value_at("scatter", 8), at_most(1e-3),
             requirement("root mean square: a thousandth of the mean, which fitted weights miss")));
    add(gate(study + "/scatter-worst-8", value_at("scatter.worst", 8), at_most(1e-2),
             requirement("of the worst point: a hundredth of the mean")));
    add(gate(study + "/tangents-8", value_at("tangents", 8), at_most(1e-4), follows));
  };
  judged("default", Tier::quick);
  judged("large", Tier::quick);
  judged("shifted", Tier::full);
  const Number tangents = value_at("tangents", 8);
  all.push_back(
      gate("large-fitted/tangents-8", tangents, at_most(1e-4), follows)
          .in(Tier::full)
          .fails("points twice as far apart as at rest: one to the square of the cell size is left, and fitted weights "
                 "leave forces of their uniform tension",
                 {1.01e-4, 1.33e-4}, stamp));
  all.push_back(gate("large/momentum", drift, at_most(1e-12),
                     identity("forces between points are opposite: exact but for rounding of what the pressure pushes "
                              "one half with over the run")));
  const Because as_default = requirement("as of the default");
  const std::string relaxes =
      "irregular points are no exact quadrature of a uniform tension: points slip, and carried tangents relax a "
      "little at each step";
  all.push_back(gate("carried/tangents-8", tangents, at_most(1e-4), as_default)
                    .fails(relaxes, {2.4e-3, 3.2e-3}, "2026-11-30 eac60cb"));
  all.push_back(gate("refitted/tangents-8", tangents, at_most(1e-4), as_default)
                    .in(Tier::full)
                    .fails(relaxes + "; what is lost is in the stretch, not in the direction", {2.9e-3, 3.9e-3},
                           "2026-11-30 eac60cb"));
  const Because stays = requirement(
      "the pressure of a balloon at rest stays: strain is a function of where points stand");
  all.push_back(gate("default/creep-8", value_at("creep", 8), at_most(5e-5), stays));
  all.push_back(gate("long/creep-8", value_at("creep", 8), at_most(5e-5), stays).in(Tier::full));
  const Because of_jitter = requirement(
      "points moved by .3 of their spacing: areas by their density give the stretch to half a per cent");
  all.push_back(gate("jittered/tangents-8", tangents, at_most(5e-3), of_jitter).in(Tier::full));
  all.push_back(
      gate("jittered-fitted/tangents-8", tangents, at_most(5e-3), of_jitter)
          .in(Tier::full)
          .fails(
              "a random sheet is held out of its shape by its own irregular forces; areas by kernels of 1.6, 2.2 and 3 "
              "spacings, least squares of the forces of a uniform tension, and 2.2 to 4.5 spacings of neighbours "
              "leave 6 to 12 thousandths",
              {6.8e-3, 9.0e-3}, stamp));
  all.push_back(gate("equal-areas-fitted/tangents-8", tangents, at_most(5e-3), of_jitter)
                    .in(Tier::full)
                    .fails("the areas are not those that the points stand for", {0.0124, 0.0165}, stamp));
  all.push_back(
      gate(
          "equal-areas/tangents-8", tangents, at_most(1e-3),
          requirement("points moved by .3 of their spacing give the stretch to a thousandth, whatever areas they have"))
          .in(Tier::full));
  all.push_back(gate("equal-areas/scatter-8", value_at("scatter", 8), at_most(0.01),
                     requirement("resultants of such points scatter by a hundredth, root mean square"))
                    .in(Tier::full));
  all.push_back(restart_gate("default", "runs of a membrane in space"));
  return all;
}

Case balloon() {
  return {.name = "balloon",
          .kind = Kind::membrane,
          .keys = Balloon().keys(),
          .sets = {{"cells", 8.0}},
          .york_step = courant_number(0.3),
          .problem = run_of<BalloonRun>,
          .studies = studies(),
          .gates = gates(),
          .levels = {4, 8, 16}};
}
PLUMBLINE_CASE(balloon);

}  // namespace
}  // namespace plumbline::balloon
