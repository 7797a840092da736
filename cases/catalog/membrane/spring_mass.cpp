// A mass on a spring of membrane points, gravity suddenly applied. [York section 5.5]
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "cases/catalog/membrane/mass_watch.hpp"
#include "cases/catalog/membrane/string.hpp"
#include "cases/harness/description/parameters.hpp"
#include "cases/harness/files/whole.hpp"
#include "cases/harness/judge/gates.hpp"
#include "cases/harness/run/extremes.hpp"
#include "kernel/materials/uniaxial_membrane.hpp"
#include "reference/heavy_spring.hpp"

namespace plumbline::spring_mass {
namespace {

// One struct for points and references.
struct Spring : Parameters {
  reference::SpringProblem spring;
  // York's: the first point a third of a spacing below the support, whole points throughout.
  std::string layout = one_of("layout", "ends", {"ends", "york", "ten"},
                              "points at both ends with half a spacing's share; York's whole points; or York's ten "
                              "whatever the mesh");
  bool york_points = layout != "ends";
  bool with_mass = one_of("reference", "distributed", {"distributed", "massless"}, "spring with or without mass") ==
                   "distributed";
  double end_time = positive("t_end", 0.1, "s", "end time");

  explicit Spring(Parameters given = {}) : Parameters(std::move(given)) {
    spring.youngs_modulus = positive("youngs_modulus", spring.youngs_modulus, "Pa", "E of the spring");
    spring.area = positive("area", spring.area, "m^2", "section of the spring");
    spring.length = within("length", spring.length, "m", 0, 1.5, "length of the spring");
    spring.mass = positive("mass", spring.mass, "kg", "the hanging mass");
    spring.density = positive("spring_density", spring.density, "kg/m^3", "density of the spring");
    spring.gravity = positive("gravity", spring.gravity, "m/s^2", "gravity");
  }
};

class SpringMassRun final : public Problem {
 public:
  explicit SpringMassRun(const Settings& settings)
      : settings_(settings),
        at_(settings_),
        massless_(at_.spring),
        watch_(spring_body()) {
    if (at_.with_mass) heavy_.emplace(at_.spring);
  }

  double end_time() const override { return at_.end_time; }

  Scene scene() const override {
    Scene scene = scene_below_support(h(), at_.spring.gravity);
    scene.bodies.push_back(spring_body());
    apply_choices(settings_, scene);
    return scene;
  }

  void observe(const Simulation& simulation) override { watch_.observe(simulation); }
  void history(Archive& archive) override { watch_.history(archive); }

  std::vector<Measure> measures(const Simulation& simulation) const override {
    const auto extremes = find_extremes(watch_.times, watch_.displacement);
    const double period = mean_period(extremes).value_or(std::nan("")), largest = largest_maximum(extremes);
    const reference::Bounded exact_period = heavy_ ? heavy_->period() : massless_.period();
    const reference::Bounded exact_largest = heavy_ ? heavy_->max_displacement() : massless_.max_displacement();
    const double free_fall = 0.5 * at_.spring.gravity * at_.end_time * at_.end_time;
    std::vector<Measure> all{scalar_measure("fallen", watch_.displacement.back() / free_fall, 0, 0, "1"),
                             drift_measure(simulation)};
    if (at_.end_time < exact_period.value) return all;
    all.push_back(scalar_measure("period", period, exact_period.value, exact_period.bound, "s"));
    all.push_back(scalar_measure("max_displacement", largest, exact_largest.value, exact_largest.bound, "m"));
    return all;
  }

  Profile profile(const Simulation&) const override {
    std::vector<ProfileColumn> columns{{"time", "s", "time", {}},
                                       {"displacement", "m", "displacement of the mass, positive downwards", {}},
                                       {"displacement_reference", "m", "exact displacement", {}},
                                       {"kinetic_energy", "J", "kinetic energy", {}},
                                       {"elastic_energy", "J", "spring energy", {}}};
    if (!heavy_) {
      columns.push_back({"kinetic_energy_reference", "J", "exact kinetic energy", {}});
      columns.push_back({"elastic_energy_reference", "J", "exact spring energy", {}});
    }
    return thinned_history(std::move(columns), watch_.times.size(), 1500, [this](std::size_t k) {
      const double t = watch_.times[k];
      const reference::Bounded exact = heavy_ ? heavy_->displacement(t) : massless_.displacement(t);
      std::vector<double> row{t, watch_.displacement[k], exact.value, watch_.kinetic[k], watch_.elastic[k]};
      if (!heavy_) row.insert(row.end(), {massless_.kinetic_energy(t).value, massless_.spring_energy(t).value});
      return row;
    });
  }

 private:
  double h() const { return 1.0 / settings_.number("cells"); }

  // The points hang below the support; the last one carries the mass.
  Body spring_body() const {
    const reference::SpringProblem& s = at_.spring;
    auto membrane = std::make_shared<UniaxialMembrane>();
    membrane->youngs_modulus = s.youngs_modulus;
    membrane->density = s.density;
    membrane->one_way = false;
    const int by_cells = std::max(2, whole(std::round(s.length / h() * settings_.number("ppc"))));
    const int segments = at_.layout == "ten" ? 9 : by_cells;
    const int points = segments + 1;
    Body body = make_body("spring", membrane, points, 1);
    const double spacing = s.length / segments;
    const double first = at_.york_points ? 0.3 * spacing : 0.0;  // y = 1.99 with a spacing of 0.0333 [York 5.5]
    double* mass = body.points(column::mass);
    for (int p = 0; p < points; ++p) {
      const bool end = p == 0 || p == points - 1;
      body.points(column::position)[p] = support - first - p * spacing;
      body.points(column::volume)[p] = s.area * spacing * (end && !at_.york_points ? 0.5 : 1.0);
      mass[p] = s.density * body.points(column::volume)[p];
    }
    mass[points - 1] = at_.york_points ? s.mass : s.mass + mass[points - 1];
    return body;
  }

  Settings settings_;
  Spring at_;
  reference::MasslessSpring massless_;
  std::optional<reference::HeavySpring> heavy_;  // judged against the spring with distributed mass
  MassWatch watch_;
};

std::vector<StudyPlan> studies() {
  return {
      study("york1997", "York's ten points", "One mesh, as in Fig. 26.", {10}).of_york(),
      study("york-load", "default under York's load", "One mesh, as in Fig. 26.", {10})
          .with({{"reference", "massless"}}),
      study("default", "default, small stretch",
            "The mass is smeared over its kernel. With the affine transfer the kernel moves as v (x - wall)/L and "
            "adds the inertia m D/L^2, D = h^2/4: the period is too long by the share h^2/(8 L^2), order 2. "
            "Without it the mass would shift the spring's end by a share of h, order 1. Gravity is 1e-5 of York's: "
            "at his the spring stretches by 1.7 %, which the linear reference does not know.",
            {10, 20, 40, 80, 160})
          .with({{"gravity", 0.0025}})
          .in_full({10, 20, 40, 80, 160, 320}),
      study("york-spacing", "York's spring with points a third to a tenth of a cell apart",
            "The spacing within a cell must not matter.", {3, 5, 10})
          .of_york()
          .over(Vary::ppc)
          .with({{"cells", 10.0}}),
      study("york-apart", "York's ten points on a mesh finer than their spacing",
            "One mesh: points one and a third cells apart.", {40})
          .of_york()
          .with({{"layout", "ten"}, {"t_end", 0.015}}),
      study("step", "musl, step refined alone",
            "Symplectic in time for an oscillator: the period's error is of second order in dt, the drift's of first.",
            {1, 0.5, 0.25, 0.125, 0.0625})
          .over(Vary::dt)
          .with({{"integrator", "musl"}, {"cells", 20.0}, {"gravity", 0.0025}})};
}

// The theoretical constant: T h^2/(8 L^2).
const Number period_constant = number_at(
    "error of the period over T h^2/(8 L^2) at 80 cells", "period", 80,
    [](const RunResult& run, const Measure& period) {
      const double length = run.settings.number("length");
      return Measured::of(period.error * 8 * length * length / (*period.reference * run.h * run.h));
    });

CaseGate spacing_gate(double points) {
  return gate("york-spacing/period-" + to_text(points), error_at("period", points), at_most(0.002 * 0.0198592),
              literature("York, section 5.4.4: spacings of a third to a tenth of a cell have been used; the period as "
                         "that of his spring, within 0.2 %"));
}

std::vector<CaseGate> gates() {
  const std::string stamp = "2026-11-21 a97e456",
                    smooth = "own measurement of a smooth motion: nothing but a change of the step moves it";
  return {
      gate("york1997/period", error_at("period", 10), at_most(0.002 * 0.0198592),
           literature("within 0.2 % of 0.0198592 s: York reads no difference off Fig. 26")),
      gate("york1997/displacement", error_at("max_displacement", 10), at_most(0.01 * 0.004995),
           literature("within 1 % of 0.004995 m: York reads no difference off Fig. 26")),
      spacing_gate(3), spacing_gate(5), spacing_gate(10),
      gate("york-apart/falls", value_at("fallen", 40), at_least(0.9),
           literature("York, section 5.4.4: membrane points further than a cell apart break the membrane. A mass on a "
                      "broken spring falls freely, g t^2/2, 28 mm; a whole one holds it within 5 mm. A tenth for what "
                      "the last whole piece carries")),
      recorded("york1997/period-frozen", value_at("period", 10), 0.0198624785, 2e-5, stamp, smooth),
      recorded("york1997/drift-frozen", value_at("energy_drift", 10), -0.0022352659, 0.02, stamp, smooth),
      gate("default/period-order", order_of("period"), at_least(1.8),
           theory("added inertia h^2/(8 L^2): order 2, and 0.2 for the interval")),
      gate("default/period-constant", period_constant, between(0.95, 1.05),
           theory("the period is too long by T h^2/(8 L^2), to the share of a second order in h/L: 5 % at h = L/24")),
      gate("default/displacement-40", error_at("max_displacement", 40),
           at_most(1e-3 * 2 * 3.33 * 0.0025 * 0.3 / (1e6 * 0.1)),
           theory("inertia does not change how deep the mass falls, 2 m g/k; 0.1 % is left for the string's own mass "
                  "at the wall and the step")),
      gate(
          "default/drift-order", order_of("energy_drift"), at_least(2.8),
          theory("the affine maps lose (k h)^4 a step, and steps follow h: order 3, and 0.2 for the interval; the step "
                 "itself, centred in time, less")),
      gate("default/drift-20", error_at("energy_drift", 20), at_most(1e-3),
           requirement("a thousandth of the energy, a tenth of what a step of first order drifts by")),
      gate("step/drift-order", order_of("energy_drift"), at_least(0.8),
           theory("stress at one end of the step, strain over the step: order 1 in dt")),
      // The energy-conserving step holds its stress over the step.
      gate("integrator/energy/finite", stopped_run(), exactly(0),
           identity("every run arrives at its end with admissible values"))
          .on("integrator/energy")
          .fails("the stress of the start of the step, strained with the midpoint velocity, amplifies elastic "
                 "oscillations by 1 + (omega dt)^2/4 a step",
                 {})
          .or_stops({1000, 6000, "position"})};
}

Case spring_mass() {
  return {.name = "spring-mass",
          .kind = Kind::membrane,
          .keys = Spring().keys(),
          .sets = {{"cells", 10.0}},
          .york1997 = {{"ppc", 3.0}, {"layout", "york"}, {"reference", "massless"}},
          .york_step = step_over_cells(1.8e-5),  // 1.8e-6 s at h = 0.1 [York 5.5]
          .problem = run_of<SpringMassRun>,
          .studies = studies(),
          .gates = gates(),
          .levels = {10, 20, 40, 80, 160},
          .any_integrator = true};
}
PLUMBLINE_CASE(spring_mass);

}  // namespace
}  // namespace plumbline::spring_mass
