// A sheet in plane stress that is held from straining across, and York's membrane of the same law.
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "cases/catalog/solid/collision.hpp"
#include "cases/catalog/solid/elastic_bar.hpp"
#include "cases/catalog/solid/manufactured_case.hpp"
#include "cases/harness/description/archive.hpp"
#include "cases/harness/description/fill_solid.hpp"
#include "cases/harness/description/parameters.hpp"
#include "cases/harness/description/schemes.hpp"
#include "cases/harness/judge/gates.hpp"
#include "cases/harness/run/extremes.hpp"
#include "cases/harness/run/judged_at_end.hpp"
#include "kernel/materials/linear_elastic.hpp"
#include "kernel/materials/uniaxial_membrane.hpp"
#include "reference/bar_vibration.hpp"

namespace plumbline::plane_stress {
namespace {

// One struct for points and reference.
struct Strip : Parameters {
  bool sheet = one_of("body", "sheet", {"sheet", "membrane"}, "what vibrates") == "sheet";
  double youngs_modulus = positive("youngs_modulus", 1e6, "Pa", "E");
  double poissons_ratio = number(poisson_key(0.4));
  double density = positive("initial_density", 1, "kg/m^3", "density");
  double length = positive("length", 1, "m", "L");
  double velocity = positive("velocity", 0.01, "m/s", "largest velocity at the start");
  double end_time = positive("t_end", 0.0085, "s", "end time");

  explicit Strip(Parameters given = {}) : Parameters(std::move(given)) {}

  reference::BarVibration exact() const {
    return reference::BarVibration(
        {.youngs_modulus = youngs_modulus / (1 - poissons_ratio * poissons_ratio),  // [York 5.14]
         .density = density,
         .length = length,
         .velocity = velocity});
  }
};

class PlaneStressRun final : public Problem, public JudgedAtEnd {
 public:
  explicit PlaneStressRun(const Settings& settings) : settings_(settings), at_(settings), exact_(at_.exact()) {
    const Body body = points();
    for (int p = 0; p < body.points.points(); ++p) start_.push_back(body.points(column::position)[p]);
  }

  double end_time() const override { return at_.end_time; }

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
      if (affine) body.points(column::affine)[p] = at_.velocity * k * std::cos(k * x);
    }
    scene.bodies.push_back(std::move(body));
    apply_choices(settings_, scene);
    return scene;
  }

  void observe(const Simulation& simulation) override {
    energy_.observe(simulation);
    const Body& body = simulation.scene().bodies.front();
    times_.push_back(simulation.time());
    mean_velocity_.push_back(motion_of(body, 1).velocity[0]);
    if (at_.sheet) watch_ratio(body);
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
    const double t = simulation.time();
    std::vector<Measure> all = bar_norms(
        body, start_,
        [&](double x) {
          return BarSample{exact_.displacement(x, t), exact_.velocity(x, t), exact_.stress(x, t)};
        },
        [&](int p) { return body.points(column::stress)[p]; });
    const auto period = mean_period(find_extremes(times_, mean_velocity_));
    all.push_back(
        scalar_measure("period", period.value_or(std::nan("")), exact_.period().value, exact_.period().bound, "s"));
    all.push_back(scalar_measure("energy_rise", energy_.largest_rise(), 0, 0, "1"));
    if (at_.sheet) all.push_back(scalar_measure("across_error", across_, 0, 0, "1"));
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
      const double off = body.points(column::stress, 1)[p] - at_.poissons_ratio * body.points(column::stress)[p];
      across_ = larger(across_, std::abs(off) / largest);
    }
  }

  GridSpec grid() const {
    GridSpec grid;
    grid.dim = at_.sheet ? 2 : 1;
    grid.h = at_.length / settings_.number("cells");
    grid.cells = {settings_.integer("cells") + 3, width, 1};
    grid.walls[0] = {Wall::symmetry, Wall::free};
    if (at_.sheet) grid.walls[1] = {Wall::symmetry, Wall::symmetry};
    return grid;
  }

  Body points() const {
    const GridSpec grid = this->grid();
    const auto filled = [&](const char* name, auto material, double across) {
      material->youngs_modulus = at_.youngs_modulus;
      material->poissons_ratio = at_.poissons_ratio;
      material->density = at_.density;
      return fill_solid(name, material, {.low = {0, 0, 0}, .high = {at_.length, across, 0}}, at_.density,
                        settings_.integer("ppc"), grid);
    };
    if (at_.sheet) {
      const auto material = std::make_shared<LinearElastic>();
      material->plane_stress = true;
      return filled("sheet", material, width * grid.h);
    }
    const auto material = std::make_shared<PlaneStressMembrane>();
    material->one_way = false;
    return filled("membrane", material, 0);
  }

  static constexpr int width = 2;  // cells of the sheet across

  Settings settings_;
  Strip at_;
  reference::BarVibration exact_;
  std::vector<double> start_;  // X by the point's number
  EnergyWatch energy_;
  double across_ = 0;
  std::vector<double> times_, mean_velocity_;
};

std::vector<StudyPlan> studies() {
  const std::vector<double> coarse{8, 12, 16, 24, 32}, fine{8, 16, 32, 64, 128};
  const std::string smooth = "Everything is smooth: second order.";
  const Override membrane{"body", "membrane"};
  return {study("sheet", "default, sheet", smooth, coarse).in_full(fine),
          study("membrane", "default, membrane", smooth, coarse).with({membrane}).in_full(fine),
          study("york1997", "york1997, membrane", "One mesh.", {32}).of_york().with({membrane})};
}

std::vector<CaseGate> gates() {
  const double period = 4 * 0.916515138991168e-3;  // 4 L/c, c = 1000/sqrt(1 - 0.16)
  const Because second = theory("second order; 0.2 for the coarsest mesh");
  const Because first = theory(
      "gradients are those of the cell's centre, a quarter of a cell off the point: first order; 0.1 for the "
      "coarsest mesh");
  std::vector<CaseGate> all;
  for (const std::string study : {"sheet", "membrane"}) {
    all.push_back(gate(study + "/period-order", fitted_order_of("period"), at_least(1.8), second));
    all.push_back(gate(study + "/displacement.L2-order", fitted_order_of("displacement.L2"), at_least(1.8), second));
    all.push_back(gate(study + "/stress.L2-order", fitted_order_of("stress.L2"), at_least(0.9), first));
    all.push_back(energy_monotone_gate(study));
  }
  all.push_back(gate("sheet/across", value_at("across_error", 32), at_most(1e-12),
                     identity("nothing moves across: sigma_2 = nu sigma_1 at every point and step, but for rounding")));
  all.push_back(gate("york1997/period", value_at("period", 32), between(0.99 * period, 1.01 * period),
                     requirement("within 1 %, an eighth of what the uniaxial law would be off by")));
  return all;
}

Case plane_stress() {
  return {.name = "plane-stress",
          .kind = Kind::solid,
          .keys = Strip().keys(),
          .sets = {{"cells", 16.0}},
          .york_step = courant_number(0.2),
          .problem = run_of<PlaneStressRun>,
          .studies = studies(),
          .gates = gates(),
          .levels = {8, 12, 16, 24, 32}};
}
PLUMBLINE_CASE(plane_stress);

}  // namespace
}  // namespace plumbline::plane_stress
