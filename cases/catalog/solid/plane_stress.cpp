// A sheet in plane stress that is held from straining across, and York's membrane of the same law.
#include <cmath>
#include <utility>

#include "cases/catalog/solid/collision.hpp"
#include "cases/catalog/solid/fill_solid.hpp"
#include "cases/catalog/solid/manufactured_case.hpp"
#include "cases/harness/description/archive.hpp"
#include "cases/harness/description/schemes.hpp"
#include "cases/harness/judge/gates.hpp"
#include "cases/harness/run/extremes.hpp"
#include "cases/harness/run/judged_at_end.hpp"
#include "kernel/materials/linear_elastic.hpp"
#include "kernel/materials/uniaxial_membrane.hpp"
#include "reference/bar_vibration.hpp"

namespace plumbline {
namespace {

reference::BarVibrationProblem problem_from(const Settings& settings) {
  const double nu = settings.number("poissons_ratio");
  reference::BarVibrationProblem problem;
  problem.youngs_modulus = settings.number("youngs_modulus") / (1 - nu * nu);  // [York 5.14]
  problem.density = settings.number("initial_density");
  problem.length = settings.number("length");
  problem.velocity = settings.number("velocity");
  return problem;
}

class PlaneStressProblem final : public Problem, public JudgedAtEnd {
 public:
  explicit PlaneStressProblem(const Settings& settings)
      : settings_(settings),
        exact_(problem_from(settings)),
        sheet_(settings.text("body") == "sheet") {
    const Body body = points();
    for (int p = 0; p < body.points.points(); ++p) start_.push_back(body.points(column::position)[p]);
  }

  double end_time() const override { return settings_.number("t_end"); }

  Scene scene() const override {
    Scene scene;
    scene.grid = grid();
    Body body = points();
    const double k = exact_.wavenumber().value;
    const bool affine = settings_.text("transfer") == "apic";
    if (affine) body.points.add(column::affine, scene.grid.dim * scene.grid.dim);
    for (int p = 0; p < body.points.points(); ++p) {
      const double x = start_[static_cast<std::size_t>(p)];
      body.points(column::velocity)[p] = exact_.velocity(x, 0).value;
      if (affine) body.points(column::affine)[p] = settings_.number("velocity") * k * std::cos(k * x);
    }
    scene.bodies.push_back(std::move(body));
    apply_choices(settings_, scene);
    return scene;
  }

  void observe(const Simulation& simulation) override {
    energy_.observe(simulation);
    const Body& body = simulation.scene().bodies.front();
    double momentum = 0, mass = 0;
    for (int p = 0; p < body.points.points(); ++p) {
      momentum += body.points(column::mass)[p] * body.points(column::velocity)[p];
      mass += body.points(column::mass)[p];
    }
    times_.push_back(simulation.time());
    mean_velocity_.push_back(momentum / mass);
    if (sheet_) watch_ratio(body);
  }
  void history(Archive& archive) override {
    archive("energy", energy_);
    archive("times", times_);
    archive("mean_velocity", mean_velocity_);
    archive("across", across_);
  }

  std::vector<std::string> seen_on_the_way() const override { return {"period", "energy_rise", "across_error"}; }

  std::vector<Measure> measures(const Simulation& simulation) const override {
    const Body& body = simulation.scene().bodies.front();
    std::vector<FieldSample> displacement, velocity, stress;
    for (int p = 0; p < body.points.points(); ++p) {
      const double x = start_[static_cast<std::size_t>(body.id[static_cast<std::size_t>(p)])];
      const double t = simulation.time(), here = body.points(column::position)[p];
      const auto add = [&](std::vector<FieldSample>& to, double computed, const reference::Bounded& right) {
        to.push_back({body.points(column::volume)[p], here, computed, right.value, right.bound});
      };
      add(displacement, here - x, exact_.displacement(x, t));
      add(velocity, body.points(column::velocity)[p], exact_.velocity(x, t));
      add(stress, body.points(column::stress)[p], exact_.stress(x, t));
    }
    std::vector<Measure> all;
    const auto add = [&](const char* name, const char* unit, const std::vector<FieldSample>& samples) {
      for (Measure& m : field_norms(name, unit, samples)) all.push_back(std::move(m));
    };
    add("displacement", "m", displacement);
    add("velocity", "m/s", velocity);
    add("stress", "Pa", stress);
    const auto period = mean_period(find_extremes(times_, mean_velocity_));
    all.push_back(
        scalar_measure("period", period.value_or(std::nan("")), exact_.period().value, exact_.period().bound, "s"));
    all.push_back(scalar_measure("energy_rise", energy_.largest_rise(), 0, 0, "1"));
    if (sheet_) all.push_back(scalar_measure("across_error", across_, 0, 0, "1"));
    return all;
  }

  Profile profile(const Simulation&) const override {
    Profile profile;
    profile.kind = "history";
    profile.abscissa = "time";
    profile.columns = {{"time", "s", "time", times_},
                       {"mean_velocity", "m/s", "mean velocity", mean_velocity_},
                       {"mean_velocity_reference", "m/s", "exact mean velocity", {}}};
    for (const double t : times_) profile.columns[2].values.push_back(exact_.mean_velocity(t).value);
    return profile;
  }

 private:
  // Largest |sigma_2 - nu sigma_1| of a point over the largest sigma_1 that occurs.
  void watch_ratio(const Body& body) {
    const double largest = exact_.problem().youngs_modulus * exact_.amplitude().value * exact_.wavenumber().value;
    for (int p = 0; p < body.points.points(); ++p) {
      const double off = body.points(column::stress, 1)[p] -
                         settings_.number("poissons_ratio") * body.points(column::stress)[p];
      across_ = larger(across_, std::abs(off) / largest);
    }
  }

  GridSpec grid() const {
    GridSpec grid;
    grid.dim = sheet_ ? 2 : 1;
    grid.h = settings_.number("length") / settings_.number("cells");
    grid.cells = {settings_.integer("cells") + 3, width, 1};
    grid.walls[0] = {Wall::symmetry, Wall::free};
    if (sheet_) grid.walls[1] = {Wall::symmetry, Wall::symmetry};
    return grid;
  }

  Body points() const {
    const double modulus = settings_.number("youngs_modulus"), nu = settings_.number("poissons_ratio");
    const double density = settings_.number("initial_density"), length = settings_.number("length");
    const GridSpec grid = this->grid();
    if (sheet_) {
      auto material = std::make_shared<LinearElastic>();
      material->youngs_modulus = modulus;
      material->poissons_ratio = nu;
      material->density = density;
      material->plane_stress = true;
      return fill_solid("sheet", material, {.low = {0, 0, 0}, .high = {length, width * grid.h, 0}}, density,
                        settings_.integer("ppc"), grid);
    }
    auto material = std::make_shared<PlaneStressMembrane>();
    material->youngs_modulus = modulus;
    material->poissons_ratio = nu;
    material->density = density;
    material->one_way = false;
    return fill_solid("membrane", material, {.low = {0, 0, 0}, .high = {length, 0, 0}}, density,
                      settings_.integer("ppc"), grid);
  }

  static constexpr int width = 2;  // cells of the sheet across

  Settings settings_;
  reference::BarVibration exact_;
  bool sheet_;
  std::vector<double> start_;  // X by the point's number
  EnergyWatch energy_;
  double across_ = 0;
  std::vector<double> times_, mean_velocity_;
};

class PlaneStress final : public Case {
 public:
  std::string name() const override { return "plane-stress"; }

  Kind kind() const override { return Kind::solid; }

  std::vector<Key> keys() const override {
    return {{.name = "body", .value = "sheet", .choices = {"sheet", "membrane"}, .description = "what vibrates"},
            positive_key("youngs_modulus", 1e6, "Pa", "E"),
            poisson_key(0.4),
            positive_key("initial_density", 1, "kg/m^3", "density"),
            positive_key("length", 1, "m", "L"),
            positive_key("velocity", 0.01, "m/s", "largest velocity at the start"),
            positive_key("t_end", 0.0085, "s", "end time")};
  }

  std::vector<Override> points_and_end(const std::string&) const override { return {{"cells", 16.0}}; }
  void derive(Settings& settings, const std::string& scheme) const override {
    if (scheme == "york1997" && !settings.is_set("dt") && !settings.is_set("cfl")) {
      settings.set("cfl", 0.2, "plane-stress");
    }
  }
  std::unique_ptr<Problem> problem(const Settings& settings) const override {
    return std::make_unique<PlaneStressProblem>(settings);
  }
  std::vector<double> default_levels() const override { return {8, 12, 16, 24, 32}; }

  std::vector<StudyPlan> studies() const override {
    const std::vector<double> coarse{8, 12, 16, 24, 32}, fine{8, 16, 32, 64, 128};
    const std::string why = "Everything is smooth: second order.";
    return {{.id = "sheet", .title = "default, sheet", .why = why, .values = coarse, .full_values = fine},
            {.id = "membrane",
             .title = "default, membrane",
             .why = why,
             .overrides = {{"body", "membrane"}},
             .values = coarse,
             .full_values = fine},
            {.id = "york1997",
             .title = "york1997, membrane",
             .why = "One mesh.",
             .scheme = "york1997",
             .overrides = {{"body", "membrane"}},
             .values = {32}}};
  }

  std::vector<CaseGate> gates() const override {
    std::vector<CaseGate> all;
    for (const std::string study : {"sheet", "membrane"}) {
      for (const char* measure : {"period", "displacement.L2"}) {
        all.push_back(fitted_order_gate(study, measure,
                                        declare(study + "/" + measure + "-order", {1.8, {}}, Origin::theory,
                                                "second order; 0.2 for the coarsest mesh")));
      }
      all.push_back(fitted_order_gate(study, "stress.L2",
                                      declare(study + "/stress.L2-order", {0.9, {}}, Origin::theory,
                                              "gradients are those of the cell's centre, a quarter of a cell off the "
                                              "point: first order; 0.1 for the coarsest mesh")));
      all.push_back(energy_monotone_gate(study));
    }
    all.push_back(value_gate("sheet", "across_error", 32,
                             declare("sheet/across", {{}, 1e-12}, Origin::identity,
                                     "nothing moves across: sigma_2 = nu sigma_1 at every point and step, but for "
                                     "rounding")));
    all.push_back(value_gate("york1997", "period", 32,
                             declare("york1997/period", {0.99 * exact_period, 1.01 * exact_period}, Origin::requirement,
                                     "within 1 %, an eighth of what the uniaxial law would be off by")));
    return all;
  }

 private:
  static constexpr double exact_period = 4 * 0.916515138991168e-3;  // 4 L/c, c = 1000/sqrt(1 - 0.16)
};

PLUMBLINE_CASE(PlaneStress);

}  // namespace
}  // namespace plumbline
