// A sphere of bands of membrane around the axis, blown up by a pressure: it comes to rest, or breathes.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "cases/catalog/coupled/coupled_gates.hpp"
#include "cases/catalog/coupled/membrane.hpp"
#include "cases/catalog/membrane/string.hpp"
#include "cases/harness/description/archive.hpp"
#include "cases/harness/description/drag.hpp"
#include "cases/harness/description/parameters.hpp"
#include "cases/harness/description/schemes.hpp"
#include "cases/harness/files/whole.hpp"
#include "cases/harness/judge/gates.hpp"
#include "cases/harness/run/extremes.hpp"
#include "kernel/materials/segment_membrane.hpp"

namespace plumbline::pressurised_bands {
namespace {

constexpr int beyond = 3;  // cells of the grid outside the sphere: the kernel reaches two

// One struct for points and closed form.
struct Bands : Parameters {
  using Parameters::Parameters;
  MembraneMaterial skin{.youngs_modulus = positive("youngs_modulus", 1, "Pa", "Young's modulus"),
                        .poissons_ratio = number({.name = "poisson",
                                                  .value = 0.3,
                                                  .low = 0,
                                                  .high = 0.5,
                                                  .high_open = true,
                                                  .description = "Poisson's ratio"}),
                        .density = positive("initial_density", 1, "kg/m^3", "density at rest"),
                        .thickness = positive("thickness", 0.01, "m", "at rest")};
  double radius = positive("radius", 1, "m", "of the sphere without pressure");
  double strain = within("strain", 0.05, "1", 0, 0.5, "of the sphere under its pressure, along and around");
  double start = number(
      {.name = "start", .value = 0.5, .low = 0, .high = 2, .description = "strain at the start over that at rest"});
  double drag = not_negative("drag", 2, "1", "against the velocity, over the speed of waves and the radius");
  double end = positive("end", 16, "1", "time of the end, in radii over the speed of waves");

  bool given =
      method(
          "connectivity", "given", {"given", "found"},
          "who follows whom along the meridian: said, or found from where its points stand, which come in no order") ==
      "given";

  double speed() const { return std::sqrt(skin.plane_modulus() / skin.density); }
  // Both stresses, force per section at rest: sigma_m = sigma_h = E' (1 + nu) eps.
  double stress() const { return skin.youngs_modulus * strain / (1 - skin.poissons_ratio); }
  // A great circle of the length 2 pi R0 at rest holds the halves together: p pi R^2 = 2 pi R0 t sigma.
  double pressure() const {
    const double stretch = 1 + strain;
    return 2 * skin.thickness * stress() / (radius * stretch * stretch);
  }
  // Small, about rest: rho t R0^2 e'' = -2 t E e/(1 - nu) + p R0 (1 + e)^2.
  double period() const {
    const double squared = 2 * skin.youngs_modulus / ((1 - skin.poissons_ratio) * skin.density * radius * radius);
    return 2 * std::numbers::pi / std::sqrt(squared * (1 - 2 * strain / (1 + strain)));
  }
};

// The pressure inside a chain from the axis to the plane y = 0 or back, counter-clockwise, pushes with p dV/dx on its points, V the
// volume per radian of the cones between them.
Load pressure_on_bands(double pressure) {
  return [=](double, Columns& points, std::span<const int>) {
    const double *r = points(column::position), *y = points(column::position, 1), *mass = points(column::mass);
    double *radial = points(column::body_force), *axial = points(column::body_force, 1);
    const int n = points.points();
    for (double* component : {radial, axial}) std::fill_n(component, n, 0.0);
    for (int a = 0; a + 1 < n; ++a) {  // V = (r_a^2 + r_a r_b + r_b^2)/6 (y_b - y_a)
      const int b = a + 1;
      const double rise = y[b] - y[a], area = (r[a] * r[a] + r[a] * r[b] + r[b] * r[b]) / 6;
      radial[a] += pressure * (2 * r[a] + r[b]) / 6 * rise / mass[a];
      radial[b] += pressure * (r[a] + 2 * r[b]) / 6 * rise / mass[b];
      axial[a] -= pressure * area / mass[a];
      axial[b] += pressure * area / mass[b];
    }
  };
}

class PressurisedBands final : public Problem {
 public:
  explicit PressurisedBands(const Settings& settings) : settings_(settings), at_(settings_) {}

  double end_time() const override { return at_.end * at_.radius / at_.speed(); }

  Scene scene() const override {
    Scene scene;
    const double far = at_.radius * (1 + at_.strain * std::max(1.0, at_.start));
    scene.grid.dim = 2;
    scene.grid.axisymmetric = true;
    scene.grid.h = at_.radius / settings_.number("cells");
    const int cells = whole(std::ceil(far / scene.grid.h)) + beyond;
    scene.grid.cells = {cells, cells, 1};
    for (std::size_t d = 0; d < 2; ++d) scene.grid.walls[d] = {Wall::symmetry, Wall::free};
    Body sphere = revolved_body("sphere", at_.skin, quarter());
    for (int d = 0; d < 2; ++d) {
      double* x = sphere.points(column::position, d);
      for (int p = 0; p < sphere.points.points(); ++p) x[p] *= 1 + at_.start * at_.strain;
    }
    sphere.load = with_drag(pressure_on_bands(at_.pressure()), at_.drag * at_.speed() / at_.radius);
    scene.bodies.push_back(std::move(sphere));
    apply_choices(settings_, scene);
    return scene;
  }

  void observe(const Simulation& simulation) override {
    rows_.push_back({simulation.time(), mean_strain(simulation.scene().bodies.front().points)});
  }
  void history(Archive& archive) override { archive("rows", rows_); }

  std::vector<Measure> measures(const Simulation& simulation) const override {
    const Columns& points = simulation.scene().bodies.front().points;
    const double exact = at_.stress();
    double along = 0, around = 0, area = 0, uneven = 0;
    for (const Band& band : bands(simulation.scene().bodies.front())) {
      area += band.area;
      along += band.area * band.stress.along;
      around += band.area * band.stress.around;
    }
    const double mean = mean_strain(points);
    for (int p = 0; p < points.points(); ++p)
      uneven = larger(uneven, std::abs(strain_at(points, p) - mean) / at_.strain);
    return {share_measure("strain", mean / at_.strain, 1), share_measure("stress_along", along / area / exact, 1),
            share_measure("stress_around", around / area / exact, 1), share_measure("uneven", uneven),
            share_measure("period", measured_period() / at_.period(), 1)};
  }

  Profile profile(const Simulation& simulation) const override {
    const Body& sphere = simulation.scene().bodies.front();
    Profile profile;
    profile.abscissa = "angle";
    profile.columns = {{"angle", "rad", "of the middle of a band from the plane y = 0", {}},
                       {"stress_along", "Pa", "along the meridian", {}},
                       {"stress_around", "Pa", "around the axis", {}},
                       {"stress_reference", "Pa", "closed form of either", {}}};
    for (const Band& band : bands(sphere))
      add_row(profile, {band.angle, band.stress.along, band.stress.around, at_.stress()});
    return profile;
  }

 private:
  double measured_period() const {
    if (at_.drag > 0) return std::nan("");
    std::vector<double> times, strains;
    for (const auto& row : rows_) {
      times.push_back(row[0]);
      strains.push_back(row[1]);
    }
    return mean_period(find_extremes(times, strains)).value_or(std::nan(""));
  }

  struct Band {
    double area, angle;  // at rest per radian, of its middle
    SegmentMembrane::BandState stress;
  };

  // Vertices on the sphere without pressure, from the plane y = 0 to the axis.
  Curve quarter() const {
    const double arc = 0.5 * std::numbers::pi;
    const int n = std::max(4, whole(std::round(arc * settings_.number("cells") * settings_.number("ppc"))));
    Curve curve;
    for (int k = 0; k <= n; ++k)
      curve.push_back(
          {k == n ? 0.0 : at_.radius * std::cos(arc * k / n), k == 0 ? 0.0 : at_.radius * std::sin(arc * k / n)});
    return at_.given ? curve : in_order(out_of_order(curve), {{0, 0}});
  }

  std::vector<Band> bands(const Body& sphere) const {
    const auto& law = dynamic_cast<const SegmentMembrane&>(*sphere.material);
    const Columns& points = sphere.points;
    const double *r = points(column::position), *y = points(column::position, 1);
    std::vector<Band> all;
    for (int p = 0; p + 1 < points.points(); ++p) {
      const double length = points(column::rest_length)[p], radius = points(column::rest_radius)[p];
      const double along = std::hypot(r[p + 1] - r[p], y[p + 1] - y[p]) / length - 1;
      all.push_back({length * radius, std::atan2(y[p] + y[p + 1], r[p] + r[p + 1]),
                     law.band(along, 0.5 * (r[p] + r[p + 1]) / radius - 1)});
    }
    return all;
  }

  double strain_at(const Columns& points, int p) const {
    return std::hypot(points(column::position)[p], points(column::position, 1)[p]) / at_.radius - 1;
  }
  // Of the distances from the centre, by mass.
  double mean_strain(const Columns& points) const {
    double sum = 0, mass = 0;
    for (int p = 0; p < points.points(); ++p) {
      mass += points(column::mass)[p];
      sum += points(column::mass)[p] * strain_at(points, p);
    }
    return sum / mass;
  }

  Settings settings_;
  Bands at_;
  std::vector<std::array<double, 2>> rows_;
};

std::vector<StudyPlan> studies() {
  const std::vector<double> levels{6, 8, 10, 12, 16}, all_levels{6, 8, 12, 16, 24};
  return {
      study("default", "at rest under its pressure", "Chords of an arc and maps: order 2.", levels).in_full(all_levels),
      study("breathing", "breathing by a hundredth of its strain", "The same, and the step's second order.", levels)
          .with({{"drag", 0.0}, {"start", 1.01}, {"end", 12.0}})
          .in_full(all_levels),
      study("found", "the same at rest, who follows whom found", "One mesh: the points come in no order.", {6})
          .with({{"connectivity", "found"}})};
}

std::vector<CaseGate> gates() {
  const Because second = theory("chords, maps and step are of second order; 0.2 for the coarsest mesh");
  const Because fine = requirement(
      "a ten-thousandth at 16 cells; a hundredth of a modulus, of a radius or of a weight is a hundred times that");
  std::vector<CaseGate> all;
  for (const std::string measure : {"strain", "stress_along", "stress_around"}) {
    all.push_back(gate("default/" + measure + "-order", fitted_order_of(measure), at_least(1.8), second));
    all.push_back(gate("default/" + measure + "-16", error_at(measure, 16), at_most(1e-4), fine));
  }
  all.push_back(gate("default/uneven-16", value_at("uneven", 16), at_most(5e-3),
                     requirement("every point is on the sphere to half a per cent of its way, those at the pole too")));
  all.push_back(gate("breathing/period-order", fitted_order_of("period"), at_least(1.8), second));
  all.push_back(gate("breathing/period-16", error_at("period", 16), at_most(1e-3),
                     requirement("a thousandth at 16 cells; a hundredth of a mass or a modulus is five times that")));
  const Because same = requirement("a fifth of a per cent of what it is with the order given");
  for (const std::string measure : {"strain", "stress_along", "stress_around"}) {
    all.push_back(gate("found/" + measure + "-6",
                       over_that_of("default", measure, 6, measure + " over that with the order given"),
                       between(0.998, 1.002), same)
                      .beside({"default"}));
  }
  return all;
}

// The Courant number of his bag, for waves along a bar of the skin. [York A.4]
Override york_step(const Settings& settings) {
  const Bands at(settings);
  return {"dt", 0.3 * at.radius / settings.number("cells") / at.speed()};
}

Case pressurised_bands() {
  return {.name = "pressurised-bands",
          .kind = Kind::membrane,
          .keys = Bands().keys(),
          .sets = {{"cells", 16.0}},
          .york_step = york_step,
          .problem = run_of<PressurisedBands>,
          .studies = studies(),
          .gates = gates(),
          .levels = {6, 8, 10, 12, 16},
          .may_be_undefined = {{"period", "a run with drag comes to rest"}}};
}
PLUMBLINE_CASE(pressurised_bands);

}  // namespace
}  // namespace plumbline::pressurised_bands
