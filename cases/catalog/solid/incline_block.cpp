// A block on an incline with Coulomb friction: slides or sticks. The axes are those of the incline; gravity is tilted.
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "cases/catalog/solid/collision.hpp"
#include "cases/catalog/solid/incline_gravity.hpp"
#include "cases/harness/description/archive.hpp"
#include "cases/harness/description/fill_solid.hpp"
#include "cases/harness/description/parameters.hpp"
#include "cases/harness/judge/gates.hpp"
#include "kernel/contact/pair_potential.hpp"
#include "kernel/materials/linear_elastic.hpp"
#include "reference/incline.hpp"

namespace plumbline::incline_block {
namespace {

constexpr double length = 1, height = 0.5, floor_height = 0.125, density = 1, poisson = 0.3;
constexpr double usual_modulus = 200, slope_that_holds = 0.2;  // Pa; tan(theta) of the study `sticks`
constexpr double typical_friction = 0.3;                       // in whose force deviations without friction are told
constexpr double behind = 0.25, before = 0.5;                  // of the block, of the floor
constexpr double flat = 0.1, rounding = 0.15;  // half the flat part of the runner, and how it rises beyond that: 1/m

struct Slope : Parameters {
  reference::InclineProblem incline;
  double youngs_modulus = 0, end = 0;

  explicit Slope(Parameters given = {}) : Parameters(std::move(given)) {
    incline.slope = not_negative("slope", 0.6, "1", "tan(theta)");
    incline.friction = not_negative("friction", typical_friction, "1", "mu, of contact");
    incline.gravity = positive("gravity", 1, "m/s^2", "when it has grown");
    incline.rise = positive("rise", 0.25, "s", "in which gravity grows from zero");
    youngs_modulus = positive("youngs_modulus", usual_modulus, "Pa", "of block and floor");
    end = positive("t_end", 1, "s", "end time");
  }
};

class InclineBlock final : public Problem {
 public:
  explicit InclineBlock(const Settings& settings) : settings_(settings), at_(settings_), exact_(at_.incline) {}

  double end_time() const override { return at_.end; }

  Scene scene() const override {
    Scene scene;
    scene.grid = grid();
    scene.friction = at_.incline.friction;
    const double l = scene.grid.h / settings_.integer("ppc");
    scene.bodies.push_back(box("block", behind, floor_height + spacings_apart(settings_) * l, length, height));
    round_ends(scene.bodies.front());
    scene.bodies.push_back(box("floor", 0, 0, behind + length + before, floor_height));
    scene.bodies.front().load = incline_gravity(exact_);
    apply_choices(settings_, scene);
    return scene;
  }

  void observe(const Simulation& simulation) override {
    const BodyMotion block = motion_of(simulation.scene().bodies[0], 2);
    const Account& energy = simulation.ledger().energy;
    if (history_.empty()) start_ = block.position[0] - block.velocity[0] * simulation.time();
    const double left = energy.store() + contact_energy(simulation.scene()) - energy.flow(Flow::body_force);
    rise_ = history_.empty() ? 0 : larger(rise_, left - left_);
    left_ = left;
    history_.push_back({simulation.time(), block.position[0] - start_, block.velocity[0], block.velocity[1],
                        friction_work(simulation)});
  }
  void history(Archive& archive) override {
    archive("rows", history_);
    archive("start", start_);
    archive("left", left_);
    archive("rise", rise_);
  }

  std::vector<Measure> measures(const Simulation& simulation) const override {
    const BodyMotion block = motion_of(simulation.scene().bodies[0], 2);
    const double t = simulation.time(), rub = at_.incline.friction > 0 ? at_.incline.friction : typical_friction;
    const reference::Bounded during = exact_.velocity_time(t), a = exact_.block_acceleration(),
                             across = exact_.across(), work = block.mass * exact_.block_friction_work(t);
    const double off = block.velocity[0] / during.value - a.value, way = history_.back()[1];
    const double taken = friction_work(simulation);
    return {scalar_measure("acceleration", block.velocity[0] / during.value, a.value, a.bound, "m/s^2"),
            share_measure("friction_off", off / (rub * across.value)),
            scalar_measure("way", way, (a * exact_.way_time(t)).value, (a * exact_.way_time(t)).bound, "m"),
            scalar_measure("later_way", way - way_at(t / 2), 0, 0, "m"),
            scalar_measure("friction_work", taken, work.value, work.bound, "J"),
            share_measure("friction_share", work.value > 0 ? taken / work.value : 1, 1),
            share_measure("normal_force", 1 + block.velocity[1] / (across * during).value, 1),
            share_measure("energy_rise", rise_ / (block.mass * at_.incline.gravity * height))};
  }

  Profile profile(const Simulation&) const override {
    return history_profile({{"time", "s", "time", {}},
                            {"way", "m", "of the block's centre of mass, along the incline", {}},
                            {"velocity", "m/s", "its velocity along the incline", {}},
                            {"velocity_across", "m/s", "its velocity off the incline", {}},
                            {"friction_work", "J", "what friction has taken", {}}},
                           history_);
  }

 private:
  GridSpec grid() const {
    GridSpec grid;
    grid.dim = 2;
    grid.h = length / settings_.number("cells");
    grid.cells = {static_cast<int>(std::ceil((behind + length + before) / grid.h)),
                  static_cast<int>(std::ceil((floor_height + height + 0.1) / grid.h)) + 1, 1};
    grid.walls[1] = {Wall::no_slip, Wall::free};
    return grid;
  }

  Body box(const std::string& name, double x, double y, double w, double h) const {
    auto elastic = std::make_shared<LinearElastic>();
    elastic->youngs_modulus = at_.youngs_modulus;
    elastic->poissons_ratio = poisson;
    elastic->density = density;
    return fill_solid(name, elastic, {{x, y, 0}, {x + w, y + h, 0}}, density, settings_.integer("ppc"), grid());
  }

  // Shifts columns of points up: below stands a runner, whose ends leave the floor.
  static void round_ends(Body& block) {
    for (int p = 0; p < block.points.points(); ++p) {
      const double beyond = std::abs(block.points(column::position, 0)[p] - behind - length / 2) - flat;
      if (beyond > 0) block.points(column::position, 1)[p] += rounding * beyond * beyond;
    }
  }

  double way_at(double time) const {
    const auto row = std::find_if(history_.begin(), history_.end(), [&](const auto& at) { return at[0] >= time; });
    return row == history_.end() ? 0 : (*row)[1];
  }

  Settings settings_;
  Slope at_;
  reference::Incline exact_;
  double start_ = 0, left_ = 0,
         rise_ = 0;  // place at the start; energy without the work of gravity, its largest rise, J
  std::vector<std::array<double, 5>> history_;
};

constexpr double cells = 32, coarse = 16, fine = 64;
constexpr double row_holds = 0.03;  // of what presses by 0.008 M, as under the flat part of the runner [Pairs 2]

// What presses gives way, so that gravity grows more slowly.
constexpr double rise_of_pairs = 1, end_of_pairs = 1.6;

StudyPlan by_pairs(const std::string& id, const std::string& title, const Override& changed,
                   double end = end_of_pairs) {
  return study(id, title, "Pairs give way by some tenths of a spacing, and the block swings on them.", {cells})
      .with({{"contact", "pairs"}, {"rise", rise_of_pairs}, {"t_end", end}, changed});
}

std::vector<StudyPlan> studies() {
  const std::string one = "One mesh: what normals at the ends of the face are tilted by changes from step to step.";
  return {
      study("default", "slides: tan(theta) = 2 mu", one, {cells}).pictured(cells),
      study("smooth", "slides without friction", one, {cells}).with({{"friction", 0.0}}),
      study("sticks", "sticks: tan(theta) = 2/3 mu", one, {coarse}).with({{"slope", slope_that_holds}, {"t_end", 4.0}}),
      by_pairs("pairs", "slides, by pairs of points", {"friction", typical_friction}).in_full({cells, fine}),
      by_pairs("pairs-smooth", "slides without friction, by pairs of points", {"friction", 0.0}).in_full({cells, fine}),
      by_pairs("pairs-sticks", "sticks, by pairs of points", {"slope", slope_that_holds}, 6).in(Tier::full)};
}

std::vector<CaseGate> gates() {
  const Because one_percent = requirement(
      "within 1 % of mu m g cos(theta), so that a coefficient that is off by 2 % is seen: what tilted normals at the "
      "ends of the face take is of the order of h/L of that");
  const Because no_rise = theory(
      "neither contact nor friction nor the midpoint step raises the energy of a linear elastic body beyond what "
      "gravity does; sums over points round at 1e-15");
  const double shear = slope_that_holds / std::hypot(1, slope_that_holds) * density *
                       height;  // N/m^2 at the foot of the block
  const double modulus = usual_modulus / (2 * (1 + poisson)), pressed = usual_modulus / (1 - poisson * poisson);
  const double strained = shear / modulus * (0.4 * height + floor_height);  // shear of block and floor
  const double rocked = 4 * shear * length * height / 2 / (std::numbers::pi * flat * flat * pressed / 2) * height / 2;
  // Of the study `pairs`: tilt times half the height, over the way; m g sin(theta) times the way.
  reference::InclineProblem gently = Slope().incline;
  gently.rise = rise_of_pairs;
  const reference::Incline sliding(gently);
  const double way = (sliding.block_acceleration() * sliding.way_time(end_of_pairs)).value;
  const double gives_way = 0.5 * length / (2 * cells), tipped = height / 2 * gives_way / flat / way;
  const double weighed = density * length * height * sliding.along().value * way;
  std::vector<CaseGate> all{
      gate("default/friction", value_at("friction_off", cells), between(-0.01, 0.01), one_percent),
      gate("smooth/friction", value_at("friction_off", cells), between(-0.01, 0.01), one_percent),
      gate("default/work", value_at("friction_share", cells), between(0.97, 1.03),
           requirement("within 3 % of mu N times the way; the block rocks on its runner, and its face goes by height/2 "
                       "times the angle less far than its centre")),
      gate("smooth/work", value_at("friction_work", cells), between(-1e-15, 1e-15),
           identity("normal impulses do no work; rounding")),
      gate("sticks/way", value_at("way", coarse), between(0, strained + rocked),
           theory("shear of block and floor, mean over the height, and rocking like a rigid punch as wide as the flat "
                  "part, which is narrower than the face: phi = 4 M/(pi a^2 E*)")),
      gate("sticks/creep", value_at("later_way", coarse), between(-strained, strained),
           theory("what sticks swings by its elastic shear and goes nowhere: in the second half of the time it would "
                  "slide by 1.1 m without friction"))};
  for (const char* study : {"pairs", "pairs-smooth"}) {
    all.push_back(gate(std::string(study) + "/friction", value_at("friction_off", cells),
                       between(-row_holds / typical_friction, row_holds / typical_friction),
                       theory("rows of points of one lattice that the runner presses by 0.008 of the modulus hold each "
                              "other by at most 0.03 of that")));
    all.push_back(
        gate(std::string(study) + "/friction-64", value_at("friction_off", fine), between(-0.01, 0.01), one_percent)
            .in(Tier::full));
  }
  all.push_back(gate("pairs/work", value_at("friction_share", cells), between(1 - tipped, 1 + tipped),
                     theory("pairs give way by up to half a spacing, and over the half of the runner that is flat the "
                            "block tips by that; its face goes by height/2 times the angle less far, or further")));
  all.push_back(gate("pairs-smooth/work", value_at("friction_work", cells), between(-1e-4 * weighed, 1e-4 * weighed),
                     requirement("pairs that pass each other give back what they take, but for a ten-thousandth of "
                                 "what gravity does in the same time")));
  all.push_back(gate("pairs-sticks/creep", value_at("later_way", cells), between(-strained, strained),
                     theory("as by contact at nodes, once the block swings no more on its pairs"))
                    .in(Tier::full));
  for (const auto& [study, level] : {std::pair{"default", cells},
                                     {"smooth", cells},
                                     {"sticks", coarse},
                                     {"pairs", cells},
                                     {"pairs-smooth", cells}}) {
    const std::string id = study;
    all.push_back(gate(id + "/energy-rise", value_at("energy_rise", level), at_most(1e-13), no_rise));
    all.push_back(
        gate(id + "/normal-force", value_at("normal_force", level), between(0.98, 1.02),
             requirement("the mean normal force is m g cos(theta): the block neither lifts off nor sinks in")));
  }
  return all;
}

Case incline_block() {
  return {.name = "incline-block",
          .kind = Kind::solid,
          .keys = Slope().keys(),
          .sets = {{"cells", cells}},
          .york1997 = {{"friction", 0.0}},  // his contact has none: in common motion nothing slips
          .york_step = courant_number(0.5),
          .problem = run_of<InclineBlock>,
          .studies = studies(),
          .gates = gates(),
          .levels = {16, 32, 64}};
}
PLUMBLINE_CASE(incline_block);

}  // namespace
}  // namespace plumbline::incline_block
