#include "kernel/integrator_traits.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <mutex>
#include <utility>

#include "kernel/materials/ideal_gas.hpp"
#include "kernel/points/column_names.hpp"
#include "kernel/shapes/shape.hpp"
#include "kernel/transfers/transfer.hpp"

namespace plumbline {
namespace {

// Passes every stage on and notes what it implies. Stages state here what they need.
class RecordedStages final : public Stages {
 public:
  RecordedStages(Stages& stages, IntegratorTraits& traits) : to_(stages), traits_(traits) {}

  void begin_step() {
    stress_is_fresh_ = false;
    force_evaluations_ = maps_ = 0;
  }

  void locate_points() override { to_.locate_points(); }
  void map_mass_and_momentum() override { to_.map_mass_and_momentum(); }
  void map_forces() override {
    use_stress();
    count_forces();
    to_.map_forces();
  }
  void advance_momentum(double dt) override { to_.advance_momentum(over(dt)); }
  void move_points(double dt, NodalVelocity carrying) override {
    count_maps();
    to_.move_points(over(dt), carrying);
  }
  void drift_points(double dt) override {
    traits_.drifts = true;
    traits_.needs.insert(Trait::constant_inertia);  // where points have affine parts, these would change their energy
    to_.drift_points(over(dt));
  }
  void kick_points(double dt) override {
    count_maps();
    to_.kick_points(over(dt));
  }
  void map_momentum() override { to_.map_momentum(); }
  void strain_points(double dt, NodalVelocity velocity) override {
    use_stress();  // its power is what strains store
    to_.strain_points(over(dt), velocity);
  }
  void evaluate_stress(NodalVelocity velocity) override {
    stress_is_fresh_ = true;
    to_.evaluate_stress(velocity);
  }
  void predict_stress(double ahead, NodalVelocity velocity) override {
    stress_is_fresh_ = true;
    to_.predict_stress(ahead, velocity);
  }
  bool reverse_cooling() override {
    use_stress();
    return to_.reverse_cooling();
  }
  void return_transfer_loss() override {
    traits_.needs.insert({Trait::returnable_loss, Trait::smooth_gradients, Trait::constant_inertia});
    traits_.offers.insert(Trait::returned_loss);
    to_.return_transfer_loss();
  }
  State state() const override { return to_.state(); }
  void set_state(const State& state) override { to_.set_state(state); }
  State rate() override {
    traits_.needs.insert(Trait::unfiltered_velocities);
    stress_is_fresh_ = true;
    count_forces();
    return to_.rate();
  }
  State velocities_of(State state) const override { return to_.velocities_of(std::move(state)); }

 private:
  double over(double dt) {
    if (dt < 0) traits_.offers.erase(Trait::forward_steps);
    return dt;
  }
  void use_stress() {
    if (!stress_is_fresh_) traits_.evaluates_stress_first = false;
  }

  void count_maps() { traits_.maps = std::max(traits_.maps, ++maps_); }
  void count_forces() { traits_.force_evaluations = std::max(traits_.force_evaluations, ++force_evaluations_); }

  Stages& to_;
  IntegratorTraits& traits_;
  bool stress_is_fresh_ = false;
  int force_evaluations_ = 0, maps_ = 0;
};

// Gas between two walls, in slow motion.
Scene small_scene(const std::string& transfer) {
  constexpr int cells = 4, per_cell = 2;
  IdealGas law;
  law.gamma = 1.4;
  Scene scene;
  scene.grid.cells[0] = cells;
  scene.grid.walls[0] = {Wall::symmetry, Wall::symmetry};
  scene.shape = "quadratic";
  scene.transfer = transfer;
  Body body = make_body("gas", std::make_shared<IdealGas>(law), cells * per_cell, 1);
  for (int p = 0; p < cells * per_cell; ++p) {
    body.points(column::position)[p] = (p + 0.5) / per_cell;
    body.points(column::velocity)[p] = 1e-3 * (1 + p % 3);
    body.points(column::mass)[p] = body.points(column::volume)[p] = 1.0 / per_cell;
    body.points(column::density)[p] = body.points(column::energy)[p] = 1;
  }
  scene.bodies.push_back(std::move(body));
  return scene;
}

IntegratorTraits found_by_steps(const IntegratorEntry& entry) {
  IntegratorTraits traits;
  traits.offers = {Trait::forward_steps};
  traits.evaluates_stress_first = true;
  for (const char* transfer : {"flip", "apic"}) {
    traits.failure.clear();
    try {
      Scene scene = small_scene(transfer);
      Ledger ledger;
      const auto engine = make_engine(scene, ledger, {.keep_loss = true});
      engine->initialise();
      ledger.open(engine->totals());
      RecordedStages recorded(*engine, traits);
      const auto integrator = entry.make();
      for (const double dt : {0.1, 0.07}) {
        recorded.begin_step();
        integrator->step(recorded, dt);
      }
      break;
    } catch (const std::exception& error) {
      traits.failure = error.what();
    }
  }
  return traits;
}

// Which part of a scheme answers for a trait.
bool is_of_shape(Trait trait) { return trait == Trait::smooth_gradients || trait == Trait::constant_inertia; }

}  // namespace

const IntegratorTraits& traits_of(const IntegratorEntry& entry) {
  static std::mutex guard;
  static std::map<std::string, IntegratorTraits> known;
  const std::lock_guard lock(guard);
  const auto found = known.find(entry.name);
  return found != known.end() ? found->second : known.emplace(entry.name, found_by_steps(entry)).first->second;
}

EngineOptions engine_options(const IntegratorEntry& entry, int threads) {
  const IntegratorTraits& traits = traits_of(entry);
  return {traits.offers.count(Trait::returned_loss) > 0, traits.evaluates_stress_first,
          traits.needs.count(Trait::unfiltered_velocities) > 0, threads};
}

std::vector<Lack> lacks(const IntegratorEntry& entry, const std::string& shape, const std::string& transfer) {
  const IntegratorTraits& own = traits_of(entry);
  const Choice *shape_choice = find_named(shapes(), shape), *transfer_choice = find_named(transfers(), transfer);
  const std::string integrator = "integrator " + entry.name;
  std::vector<Lack> all;
  for (const Trait trait : own.needs) {
    const Choice* of = is_of_shape(trait) ? shape_choice : transfer_choice;
    if (of && of->offers.count(trait) > 0) continue;
    all.push_back({trait, integrator, is_of_shape(trait) ? "shape " + shape : "transfer " + transfer});
  }
  if (transfer_choice) {
    for (const Trait trait : transfer_choice->needs) {
      if (own.offers.count(trait) == 0) all.push_back({trait, "transfer " + transfer, integrator});
    }
  }
  return all;
}

std::vector<Lack> lacks(const IntegratorEntry& entry, const Scene& scene) {
  std::vector<Lack> all = lacks(entry, scene.shape, scene.transfer);
  const Traits& offers = traits_of(entry).offers;
  const auto needs = [&](Trait trait, const std::string& part) {
    if (offers.count(trait) == 0) all.push_back({trait, part, "integrator " + entry.name});
  };
  const Choice* transfer = find_named(transfers(), scene.transfer);
  if (!scene.pistons.empty() && transfer && transfer->offers.count(Trait::returnable_loss) == 0) {
    all.push_back({Trait::returnable_loss, "a piston", "transfer " + scene.transfer});
  }
  if (scene.loss_to_gas) needs(Trait::returned_loss, "giving losses to the gas");
  if (scene.contact != "none") needs(Trait::forward_steps, "contact");
  if (!scene.filter.none()) needs(Trait::forward_steps, "a filter at a rate");
  if (scene.heat_exchange > 0) needs(Trait::forward_steps, "exchange of heat");
  if (scene.chain_relaxation > 0 || scene.strain_smoothing > 0) needs(Trait::forward_steps, "relaxation of membranes");
  for (const Body& body : scene.bodies) {
    for (const Trait trait : body.material->needs()) needs(trait, "material " + body.material->name());
  }
  return all;
}

}  // namespace plumbline
