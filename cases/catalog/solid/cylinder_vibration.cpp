// Radial vibration of a solid cylinder: the elastic solid by rings.
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "cases/catalog/solid/collision.hpp"
#include "cases/catalog/solid/manufactured_case.hpp"
#include "cases/harness/description/archive.hpp"
#include "cases/harness/description/fill_solid.hpp"
#include "cases/harness/description/parameters.hpp"
#include "cases/harness/description/schemes.hpp"
#include "cases/harness/description/solid_material.hpp"
#include "cases/harness/judge/gates.hpp"
#include "cases/harness/run/extremes.hpp"
#include "kernel/materials/linear_elastic.hpp"
#include "reference/cylinder_vibration.hpp"

namespace plumbline::cylinder_vibration {
namespace {

// One struct for points and reference.
struct Cylinder : Parameters {
  reference::CylinderVibrationProblem motion{.youngs_modulus = 1e4, .velocity = 1e-3};
  double periods = 0;

  explicit Cylinder(Parameters given = {}) : Parameters(std::move(given)) {
    motion.radius = positive("radius", motion.radius, "m", "R");
    motion.youngs_modulus = positive("youngs_modulus", motion.youngs_modulus, "Pa", "E");
    motion.poisson = number(poisson_key(motion.poisson));
    motion.density = positive("initial_density", motion.density, "kg/m^3", "density");
    motion.velocity = positive("velocity", motion.velocity, "m/s", "V, of the surface at the start");
    motion.mode = integer({.name = "mode", .value = 1.0, .low = 1, .high = 20, .description = "number of the mode"});
    periods = positive("periods", 2.3, "1", "periods to the end");
    text(material_key(false));
  }
};

constexpr int layers = 4;  // cells along the axis, between mirrors

class CylinderVibration final : public Problem {
 public:
  explicit CylinderVibration(const Settings& settings) : settings_(settings), at_(settings), exact_(at_.motion) {
    const Body body = points();
    for (int p = 0; p < body.points.points(); ++p) start_.push_back(body.points(column::position)[p]);
  }

  double end_time() const override { return at_.periods * exact_.period().value; }

  Scene scene() const override {
    Scene scene;
    scene.grid = grid();
    Body body = points();
    const bool affine = settings_.text("transfer") == "apic";
    if (affine) body.points.add(column::affine, 4);
    for (int p = 0; p < body.points.points(); ++p) {
      const double r = start_[static_cast<std::size_t>(p)];
      body.points(column::velocity)[p] = exact_.velocity(r, 0).value;
      if (affine) body.points(column::affine)[p] = slope(r);
    }
    scene.bodies.push_back(std::move(body));
    apply_choices(settings_, scene);
    return scene;
  }

  void observe(const Simulation& simulation) override {
    energy_.observe(simulation);
    const Body& body = simulation.scene().bodies.front();
    double square = 0, size = 0;
    for (int p = 0; p < body.points.points(); ++p) {
      const double r = start_of(body, p), exact = exact_.displacement(r, simulation.time()).value;
      const double error = body.points(column::position)[p] - r - exact, volume = body.points(column::volume)[p];
      square += volume * error * error;
      size += volume * exact * exact;
    }
    largest_ = larger(largest_, std::sqrt(size));
    time_.push_back(simulation.time());
    errors_.push_back(std::sqrt(square));
    mean_velocity_.push_back(motion_of(body, 1).velocity[0]);
  }
  void history(Archive& archive) override {
    archive("energy", energy_);
    archive("largest", largest_);
    archive("time", time_);
    archive("errors", errors_);
    archive("mean_velocity", mean_velocity_);
  }

  std::vector<Measure> measures(const Simulation& simulation) const override {
    const Body& body = simulation.scene().bodies.front();
    std::vector<ErrorSample> displacements, velocities;
    double bound = 0;
    for (int p = 0; p < body.points.points(); ++p) {
      const double r = start_of(body, p), volume = body.points(column::volume)[p];
      const auto add = [&](std::vector<ErrorSample>& to, double computed, const reference::Bounded& exact) {
        to.push_back({volume, std::abs(computed - exact.value), std::abs(exact.value), exact.bound});
      };
      const reference::Bounded u = exact_.displacement(r, simulation.time());
      add(displacements, body.points(column::position)[p] - r, u);
      add(velocities, body.points(column::velocity)[p], exact_.velocity(r, simulation.time()));
      bound += volume * u.bound * u.bound;
    }
    std::vector<Measure> all = error_norms("displacement", "m", displacements);
    for (Measure& m : error_norms("velocity", "m/s", velocities)) all.push_back(std::move(m));
    Measure worst;
    worst.name = "displacement.worst";
    worst.unit = "m^2.5";
    for (const double error : errors_) worst.error = larger(worst.error, error);
    worst.scale = largest_;
    worst.reference_bound = std::sqrt(bound);
    all.push_back(worst);
    const auto period = mean_period(find_extremes(time_, mean_velocity_));
    const reference::Bounded right = exact_.period();
    all.push_back(scalar_measure("period", period.value_or(std::nan("")), right.value, right.bound, "s"));
    all.push_back(scalar_measure("energy_rise", energy_.largest_rise(), 0, 0, "1"));
    all.push_back(scalar_measure("energy_lost", 1 - energy_.kept(), 0, 0, "1"));
    return all;
  }

  Profile profile(const Simulation&) const override {
    Profile profile;
    profile.kind = "history";
    profile.abscissa = "time";
    profile.columns = {{"time", "s", "time", time_},
                       {"displacement_error", "1", "norm of the displacement's error", errors_}};
    return profile;
  }

 private:
  double start_of(const Body& body, int p) const {
    return start_[static_cast<std::size_t>(body.id[static_cast<std::size_t>(p)])];
  }

  // dv/dr at the start, by central differences of the exact velocity: right to 1e-8 of V/R.
  double slope(double r) const {
    const double step = 1e-4 * std::min(r, at_.motion.radius - r);
    return (exact_.velocity(r + step, 0).value - exact_.velocity(r - step, 0).value) / (2 * step);
  }

  GridSpec grid() const {
    GridSpec grid;
    grid.dim = 2;
    grid.axisymmetric = true;
    grid.h = at_.motion.radius / settings_.number("cells");
    grid.cells = {settings_.integer("cells") + 3, layers, 1};
    grid.walls[0] = {Wall::symmetry, Wall::free};
    grid.walls[1] = {Wall::symmetry, Wall::symmetry};
    return grid;
  }

  Body points() const {
    auto material = std::make_shared<LinearElastic>();
    material->youngs_modulus = at_.motion.youngs_modulus;
    material->poissons_ratio = at_.motion.poisson;
    material->density = at_.motion.density;
    const GridSpec on = grid();
    return fill_solid("cylinder", chosen_material(settings_, material),
                      {.low = {0, 0, 0}, .high = {at_.motion.radius, layers * on.h, 0}}, at_.motion.density,
                      settings_.integer("ppc"), on);
  }

  Settings settings_;
  Cylinder at_;
  reference::CylinderVibration exact_;
  std::vector<double> start_;  // r at rest by the point's number
  EnergyWatch energy_;
  double largest_ = 0;
  std::vector<double> time_, errors_, mean_velocity_;
};

const std::vector<std::string> second_order{"default", "neo-hookean", "boxes"};

std::vector<StudyPlan> studies() {
  const std::vector<double> levels{8, 12, 16, 24, 32}, all_levels{8, 16, 32, 64, 128};
  const std::string why = "Everything is smooth, and the hoops' forces are the adjoint of their strains: second order.";
  return {study("default", "default", why, levels).in_full(all_levels),
          study("neo-hookean", "neo-Hookean, strains of 1e-5", why, levels)
              .with({{"material", "neo_hookean"}})
              .in_full(all_levels),
          study("boxes", "boxes that stretch along the axes", why, levels)
              .with({{"shape", "contiguous-gimp"}})
              .in_full(all_levels)};
}

std::vector<CaseGate> gates() {
  std::vector<CaseGate> all;
  for (const std::string& study : second_order) {
    for (const std::string measure : {"period", "displacement.worst"}) {
      all.push_back(gate(study + "/" + measure + "-order", fitted_order_of(measure), at_least(1.8),
                         theory("second order; 0.2 for the coarsest mesh")));
    }
    all.push_back(gate(study + "/energy_lost-order", fitted_order_of("energy_lost"), at_least(2.8),
                       theory("(kh)^4 of a wave a step, h^-1 steps: 3; 0.2 for the coarsest mesh")));
    all.push_back(
        gate(study + "/period-32", error_at("period", 32), at_most(1e-3 * 0.0254754),
             requirement("a thousandth of the period at 32 cells; a hundredth of a modulus is five times that")));
  }
  all.push_back(energy_monotone_gate("default"));
  return all;
}

Case cylinder_vibration() {
  return {.name = "cylinder-vibration",
          .kind = Kind::solid,
          .keys = Cylinder().keys(),
          .sets = {{"cells", 16.0}, {"shape", "cpdi"}},
          .york1997 = {{"shape", "linear"}},
          .york_step = courant_number(published_courant),
          .problem = run_of<CylinderVibration>,
          .studies = studies(),
          .gates = gates(),
          .levels = {8, 12, 16, 24, 32}};
}
PLUMBLINE_CASE(cylinder_vibration);

}  // namespace
}  // namespace plumbline::cylinder_vibration
