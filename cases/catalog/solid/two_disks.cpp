// Two elastic disks meet and part. [Sulsky, Chen, Schreyer 1994]
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "cases/catalog/solid/collision.hpp"
#include "cases/harness/description/archive.hpp"
#include "cases/harness/description/fill_solid.hpp"
#include "cases/harness/description/solid_material.hpp"
#include "cases/harness/judge/gates.hpp"
#include "kernel/materials/linear_elastic.hpp"

namespace plumbline::two_disks {
namespace {

constexpr double radius = 0.2, density = 1000, youngs_modulus = 1000, poisson = 0.3, speed = 0.1;

class TwoDisks final : public Problem {
 public:
  explicit TwoDisks(const Settings& settings) : settings_(settings) {}

  double end_time() const override { return settings_.number("t_end"); }

  Scene scene() const override {
    Scene scene;
    scene.grid.dim = 2;
    scene.grid.h = 1 / settings_.number("cells");
    for (std::size_t d = 0; d < 2; ++d) scene.grid.cells[d] = settings_.integer("cells");
    scene.bodies.push_back(disk("lower", 0.2, speed, scene.grid));
    scene.bodies.push_back(disk("upper", 0.8, -speed, scene.grid));
    apply_choices(settings_, scene);
    return scene;
  }

  void observe(const Simulation& simulation) override {
    energy_.observe(simulation);
    along_x_.observe(simulation);
    along_y_.observe(simulation);
    const EnergyStores& stores = simulation.ledger().stores;
    if (history_.empty()) least_ = simulation.ledger().initial_stores.kinetic;
    least_ = smaller(least_, stores.kinetic);
    most_ = larger(most_, stores.elastic);
    const BodyMotion lower = motion_of(simulation.scene().bodies[0], 2);
    history_.push_back({simulation.time(), stores.kinetic, stores.elastic, lower.position[0], lower.velocity[0]});
  }
  void history(Archive& archive) override {
    archive("energy", energy_);
    archive("along_x", along_x_);
    archive("along_y", along_y_);
    archive("least", least_);
    archive("most", most_);
    archive("rows", history_);
  }

  std::vector<Measure> measures(const Simulation& simulation) const override {
    const Ledger& ledger = simulation.ledger();
    const double start = ledger.initial_stores.kinetic;
    const BodyMotion lower = motion_of(simulation.scene().bodies[0], 2),
                     upper = motion_of(simulation.scene().bodies[1], 2);
    const double along = (upper.velocity[0] - lower.velocity[0] + upper.velocity[1] - lower.velocity[1]) / (4 * speed);
    return {scalar_measure("kinetic_start", start, 2.6, 0, "J"),
            scalar_measure("kinetic_end", ledger.stores.kinetic, start, 0, "J"),
            share_measure("kinetic_least", least_ / start, 0),
            share_measure("elastic_most", most_ / start, 1),
            share_measure("restitution", along, 1),
            share_measure("energy_kept", energy_.kept(), 1),
            share_measure("energy_rise", energy_.largest_rise()),
            share_measure("momentum_error", larger(along_x_.largest_error(), along_y_.largest_error()), 0)};
  }

  Profile profile(const Simulation&) const override {
    return history_profile({{"time", "s", "time", {}},
                            {"kinetic_energy", "J", "kinetic energy", {}},
                            {"elastic_energy", "J", "strain energy", {}},
                            {"position", "m", "x of the lower disk's centre of mass", {}},
                            {"velocity", "m/s", "its velocity along x", {}}},
                           history_);
  }

 private:
  Body disk(const std::string& name, double centre, double velocity, const GridSpec& grid) const {
    auto elastic = std::make_shared<LinearElastic>();
    elastic->youngs_modulus = youngs_modulus;
    elastic->poissons_ratio = poisson;
    elastic->density = density;
    const SolidShape shape{
        {centre - radius, centre - radius, 0},
        {centre + radius, centre + radius, 0},
        [=](const std::array<double, 3>& x) { return std::hypot(x[0] - centre, x[1] - centre) < radius; }};
    Body body = fill_solid(name, chosen_material(settings_, elastic), shape, density, settings_.integer("ppc"), grid);
    for (int d = 0; d < 2; ++d) std::fill_n(body.points(column::velocity, d), body.points.points(), velocity);
    return body;
  }

  Settings settings_;
  EnergyWatch energy_;
  MomentumWatch along_x_{0}, along_y_{1};
  double least_ = 0, most_ = 0;
  std::vector<std::array<double, 5>> history_;
};

std::vector<StudyPlan> studies() {
  const std::string one = "One mesh, the published one.";
  return {
      study("default", "default", "What the maps take falls with refinement.", {20, 40})
          .in_full({20, 40, 80})
          .pictured(25),
      study("published", "linear shapes, FLIP, one velocity for both", one, {20}).of_york().with({{"contact", "none"}}),
      study("york1997", "York's criterion 9.7", one, {20}).of_york()};
}

std::vector<CaseGate> gates() {
  const Number rise = number_of("least rise of the energy kept from level to level", [](const StudyResult& s) {
    return Measured::of(least_rise(values_of(s, "energy_kept")));
  });
  std::vector<CaseGate> all{
      gate("published/start", value_at("kinetic_start", 20), between(2.5995, 2.6005),
           literature("2.600 J: the same points")),
      gate("published/end", value_at("kinetic_end", 20), between(0.97 * 2.391, 1.03 * 2.391),
           literature("2.391 J; 3 % for the order of the step, which the publication leaves open")),
      gate("published/least", value_at("kinetic_least", 20), between(0, 0.05),
           literature("0.064 J of 2.600, 2.5 %, and as much again")),
      gate("default/kept-rises", rise, at_least(0), theory("what the maps take falls with refinement"))};
  for (CaseGate& gate : conservation_gates("default", {20, 40})) all.push_back(std::move(gate));
  return all;
}

Case two_disks() {
  return {.name = "two-disks",
          .kind = Kind::solid,
          .keys = {positive_key("t_end", 4, "s", "end time"), material_key(false)},
          .sets = {{"cells", 20.0}},
          .york_step = step_over_cells(1e-3 * 20),  // Sulsky's step
          .problem = run_of<TwoDisks>,
          .studies = studies(),
          .gates = gates(),
          .levels = {20, 40, 80}};
}
PLUMBLINE_CASE(two_disks);

}  // namespace
}  // namespace plumbline::two_disks
