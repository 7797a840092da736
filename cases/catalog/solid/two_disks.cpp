// Two elastic disks meet and part. [Sulsky, Chen, Schreyer 1994]
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "cases/catalog/solid/collision.hpp"
#include "cases/catalog/solid/fill_solid.hpp"
#include "cases/harness/description/archive.hpp"
#include "cases/harness/judge/gates.hpp"
#include "kernel/materials/linear_elastic.hpp"

namespace plumbline {
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
    const auto share = [](std::string name, double value, double reference) {
      Measure measure = scalar_measure(std::move(name), value, reference, 0, "1");
      measure.scale = 1;
      return measure;
    };
    return {scalar_measure("kinetic_start", start, 2.6, 0, "J"),
            scalar_measure("kinetic_end", ledger.stores.kinetic, start, 0, "J"),
            share("kinetic_least", least_ / start, 0),
            share("elastic_most", most_ / start, 1),
            share("restitution", along, 1),
            share("energy_kept", energy_.kept(), 1),
            share("energy_rise", energy_.largest_rise(), 0),
            share("momentum_error", larger(along_x_.largest_error(), along_y_.largest_error()), 0)};
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
    Body body = fill_solid(name, elastic, shape, density, settings_.integer("ppc"), grid);
    for (int d = 0; d < 2; ++d) std::fill_n(body.points(column::velocity, d), body.points.points(), velocity);
    return body;
  }

  Settings settings_;
  EnergyWatch energy_;
  MomentumWatch along_x_{0}, along_y_{1};
  double least_ = 0, most_ = 0;
  std::vector<std::array<double, 5>> history_;
};

class TwoDisksCase final : public Case {
 public:
  std::string name() const override { return "two-disks"; }

  Kind kind() const override { return Kind::solid; }

  std::vector<Key> keys() const override {
    return {{.name = "t_end", .value = 4.0, .unit = "s", .low = 0, .low_open = true, .description = "end time"}};
  }

  std::vector<Override> points_and_end(const std::string&) const override { return {{"cells", 20.0}}; }

  void derive(Settings& settings, const std::string& scheme) const override {
    if (scheme == "york1997" && !settings.is_set("dt") && !settings.is_set("cfl")) {
      settings.set("dt", 1e-3 * 20 / settings.number("cells"), "two-disks");  // Sulsky's step
    }
  }

  std::unique_ptr<Problem> problem(const Settings& settings) const override {
    return std::make_unique<TwoDisks>(settings);
  }

  std::vector<double> default_levels() const override { return {20, 40, 80}; }
  std::vector<StudyPlan> studies() const override {
    const std::string one = "One mesh, the published one.";
    return {{.id = "default",
             .title = "default",
             .why = "What the maps take falls with refinement.",
             .values = {20, 40},
             .full_values = {20, 40, 80},
             .frames = 25},
            {.id = "published",
             .title = "linear shapes, FLIP, one velocity for both",
             .why = one,
             .scheme = "york1997",
             .overrides = {{"contact", "none"}},
             .values = {20}},
            {.id = "york1997", .title = "York's criterion 9.7", .why = one, .scheme = "york1997", .values = {20}}};
  }

  std::vector<CaseGate> gates() const override {
    const auto literature = [](const std::string& id, Range range, const std::string& why) {
      return declare(id, range, Origin::literature, why);
    };
    std::vector<CaseGate> all{
        value_gate("published", "kinetic_start", 20,
                   literature("published/start", {2.5995, 2.6005}, "2.600 J: the same points")),
        value_gate("published", "kinetic_end", 20,
                   literature("published/end", {0.97 * 2.391, 1.03 * 2.391},
                              "2.391 J; 3 % for the order of the step, which the publication leaves open")),
        value_gate("published", "kinetic_least", 20,
                   literature("published/least", {0, 0.05}, "0.064 J of 2.600, 2.5 %, and as much again")),
        kept_more_gate()};
    for (const double level : {20.0, 40.0}) {
      const std::string at = "-" + to_text(level);
      all.push_back(value_gate("default", "energy_rise", level,
                               declare("default/energy-rise" + at, {{}, 1e-13}, Origin::theory,
                                       "no step of the midpoint rule raises the energy of a linear elastic body, "
                                       "contact included; sums over points round at 1e-15")));
      all.push_back(value_gate("default", "momentum_error", level,
                               declare("default/momentum-kept" + at, {{}, 1e-12}, Origin::identity,
                                       "equal and opposite impulses at each node")));
    }
    return all;
  }

 private:
  static CaseGate kept_more_gate() {
    Gate gate = declare("default/kept-rises", {0, {}}, Origin::theory, "what the maps take falls with refinement");
    gate.quantity = "least rise of the energy kept from level to level";
    return study_gate("default", gate, [](const StudyResult& s) {
      Measured measured;
      double least = HUGE_VAL, last = std::nan("");
      for (const StudyLevel& level : s.levels) {
        const Measure* found = level.run.find("energy_kept");
        const double now = found ? *found->value : std::nan("");
        if (&level != &s.levels.front()) least = smaller(least, now - last);
        last = now;
      }
      measured.value = least;
      measured.scale = 1;
      return measured;
    });
  }
};

PLUMBLINE_CASE(TwoDisksCase);

}  // namespace
}  // namespace plumbline
