// A disk on an incline with Coulomb friction: rolls, or slides while it spins up. Axes are those of the incline.
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "cases/catalog/solid/annulus_points.hpp"
#include "cases/catalog/solid/collision.hpp"
#include "cases/catalog/solid/incline_gravity.hpp"
#include "cases/harness/description/archive.hpp"
#include "cases/harness/description/fill_solid.hpp"
#include "cases/harness/description/parameters.hpp"
#include "cases/harness/judge/gates.hpp"
#include "kernel/contact/pair_potential.hpp"
#include "kernel/materials/neo_hookean.hpp"
#include "reference/incline.hpp"
#include "reference/line_contact.hpp"

namespace plumbline::rolling_disk {
namespace {

// Of the floor, m: its height, and its length behind the disk's centre and before it.
constexpr double radius = 1, density = 1, poisson = 0.3, usual_stiffness = 12.5, floor_height = 0.5;
constexpr double behind = 1.1, before = 2.5, usual_slope = 0.6, slope_that_slides = 1.5, usual_friction = 0.3;
struct Slope : Parameters {
  reference::InclineProblem incline;
  double stiffness = 0, end = 0;

  explicit Slope(Parameters given = {}) : Parameters(std::move(given)) {
    incline.slope = not_negative("slope", usual_slope, "1", "tan(theta)");
    incline.friction = not_negative("friction", usual_friction, "1", "mu, of contact");
    incline.gravity = positive("gravity", 1, "m/s^2", "when it has grown");
    incline.rise = positive("rise", 1.5, "s", "in which gravity grows from zero; rates are those after it");
    stiffness = positive("stiffness", usual_stiffness, "Pa", "E of disk and floor over the cells along the radius");
    end = positive("t_end", 3.5, "s", "end time");
  }
  reference::LineContact contact(double cells) const {
    const double weight = density * std::numbers::pi * radius * radius * reference::Incline(incline).across().value;
    return {radius, stiffness * cells, poisson, weight};
  }
};

class RollingDisk final : public Problem {
 public:
  explicit RollingDisk(const Settings& settings) : settings_(settings), at_(settings_), exact_(at_.incline) {}
  double end_time() const override { return at_.end; }
  Scene scene() const override {
    Scene scene;
    scene.grid = grid();
    scene.friction = at_.incline.friction;
    const int ppc = settings_.integer("ppc");
    const double top = floor_rows() * scene.grid.h;
    const Annulus disk{0, radius, {behind, top + radius + spacings_apart(settings_) * scene.grid.h / ppc}};
    scene.bodies.push_back(polar_annulus("disk", material(), disk, density, ppc, scene.grid));
    scene.bodies.push_back(
        fill_solid("floor", material(), {{0, 0, 0}, {behind + before, top, 0}}, density, ppc, scene.grid));
    scene.bodies.front().load = incline_gravity(exact_);
    apply_choices(settings_, scene);
    return scene;
  }

  void observe(const Simulation& simulation) override {
    const BodyMotion disk = motion_of(simulation.scene().bodies[0], 2);
    const Account& energy = simulation.ledger().energy;
    const double t = simulation.time(), spin = spin_of(simulation.scene().bodies[0], disk);
    if (history_.empty()) start_ = disk.position[0] - disk.velocity[0] * t;
    const double left = energy.store() + contact_energy(simulation.scene()) - energy.flow(Flow::body_force);
    rise_ = history_.empty() ? 0 : larger(rise_, left - left_);
    left_ = left;
    const double high = disk.position[1] - floor_rows() * simulation.scene().grid.h;
    slipped_ += (disk.velocity[0] - high * spin) * (t - (history_.empty() ? 0 : history_.back()[0]));
    history_.push_back({t, disk.position[0] - start_, high, disk.velocity[0], disk.velocity[1], spin,
                        friction_work(simulation), slipped_});
  }
  void history(Archive& archive) override {
    archive("rows", history_);
    archive("start", start_);
    archive("slipped", slipped_);
    archive("left", left_);
    archive("rise", rise_);
  }

  std::vector<Measure> measures(const Simulation& simulation) const override {
    const double mass = motion_of(simulation.scene().bodies[0], 2).mass;
    const reference::Bounded a = exact_.disk_acceleration(), turns = exact_.disk_spin_up();
    const double along = rate(velocity), spin = rate(turning), across = exact_.across().value + rate(off);
    const double taken = grown(work), down = exact_.along().value * mass * grown(way);
    const double rubbed = at_.incline.friction * across * mass * grown(slip);
    return {scalar_measure("acceleration", along, a.value, a.bound, "m/s^2"),
            share_measure("acceleration_share", along / a.value, 1),
            share_measure("spin_share", radius * spin / turns.value, 1),
            share_measure("rolling_radius", along / spin / radius, 1),
            share_measure("friction_off",
                          (exact_.along().value - along) / across - (exact_.along() - a).value / exact_.across().value),
            share_measure("taken_share", taken / down),
            share_measure("work_share", rubbed > 0 ? taken / rubbed : 1, 1),
            scalar_measure("height", mean(height), radius, 0, "m"),
            share_measure("energy_rise", rise_ / (mass * at_.incline.gravity * radius))};
  }

  Profile profile(const Simulation&) const override {
    return history_profile({{"time", "s", "time", {}},
                            {"way", "m", "of the disk's centre of mass, along the incline", {}},
                            {"height", "m", "of it, over the incline", {}},
                            {"velocity", "m/s", "its velocity along the incline", {}},
                            {"velocity_across", "m/s", "its velocity off the incline", {}},
                            {"spin", "1/s", "angular velocity", {}},
                            {"friction_work", "J", "what friction has taken", {}},
                            {"slip", "m", "way less the angle times the height", {}}},
                           history_);
  }

 private:
  enum Column : std::size_t { time, way, height, velocity, off, turning, work, slip };
  using Row = std::array<double, 8>;

  bool later(const Row& row) const { return row[time] >= at_.incline.rise; }
  // What a column has grown by since then; no number for a run that ends before.
  double grown(Column column) const {
    const auto first = std::find_if(history_.begin(), history_.end(), [this](const Row& row) { return later(row); });
    return first == history_.end() ? std::nan("") : history_.back()[column] - (*first)[column];
  }

  // Of a column over time, since gravity has grown: the line of least squares, since the disk swings on its own softness.
  double rate(Column column) const {
    const double middle = mean(time), value = mean(column);
    double both = 0, square = 0;
    for (const Row& row : history_) {
      both += later(row) * (row[time] - middle) * (row[column] - value);
      square += later(row) * (row[time] - middle) * (row[time] - middle);
    }
    return both / square;
  }
  double mean(Column column) const {
    double sum = 0, count = 0;
    for (const Row& row : history_) {
      sum += later(row) * row[column];
      count += later(row);
    }
    return sum / count;
  }

  // Of the rigid motion that is nearest, forwards: against the axes' sense, 1/s.
  static double spin_of(const Body& disk, const BodyMotion& motion) {
    double moment = 0, inertia = 0;
    for (int p = 0; p < disk.points.points(); ++p) {
      const double mass = disk.points(column::mass)[p];
      const double x = disk.points(column::position, 0)[p] - motion.position[0],
                   y = disk.points(column::position, 1)[p] - motion.position[1];
      moment += mass * (y * disk.points(column::velocity, 0)[p] - x * disk.points(column::velocity, 1)[p]);
      inertia += mass * (x * x + y * y);
    }
    return moment / inertia;
  }

  // Whole cells, so that the floor's face is where it is said to be.
  double floor_rows() const { return std::max(1.0, std::round(floor_height / radius * settings_.number("cells"))); }

  GridSpec grid() const {
    GridSpec grid;
    grid.dim = 2;
    grid.h = radius / settings_.number("cells");
    grid.cells = {static_cast<int>(std::ceil((behind + before) / grid.h)),
                  static_cast<int>(std::ceil(floor_rows() + (2 * radius + 0.1) / grid.h)) + 1, 1};
    grid.walls[1] = {Wall::no_slip, Wall::free};
    return grid;
  }
  std::shared_ptr<Material> material() const {
    auto elastic = std::make_shared<NeoHookean>();
    elastic->youngs_modulus = at_.stiffness * settings_.number("cells");
    elastic->poissons_ratio = poisson;
    elastic->density = density;
    return elastic;
  }

  Settings settings_;
  Slope at_;
  reference::Incline exact_;
  double start_ = 0, slipped_ = 0;  // place at the start, m; the slip so far, m
  double left_ = 0, rise_ = 0;      // energy without the work of gravity, its largest rise, J
  std::vector<Row> history_;
};

std::vector<StudyPlan> studies() {
  const std::string first = "What leads the disk's pressure is of the order of a cell: first order.";
  const std::string by_pairs = "One mesh: the disk swings on what its pairs give way.";
  return {study("default", "rolls: tan(theta) = 2 mu", first, {8, 12}).in_full({8, 12, 16, 24, 32}).pictured(25),
          study("slides", "slides: tan(theta) = 5 mu", first, {8, 16})
              .in_full({8, 12, 16, 24, 32})
              .with({{"slope", slope_that_slides}, {"t_end", 2.75}}),
          study("pairs", "rolls, by pairs of points", by_pairs, {16}).with({{"contact", "pairs"}}).in(Tier::full),
          study("pairs-slides", "slides, by pairs of points", by_pairs, {16})
              .with({{"contact", "pairs"}, {"slope", slope_that_slides}, {"t_end", 2.75}})
              .in(Tier::full)};
}

// What the disk's pressure leads by, over its radius: half a cell, since a node stands for the points around it.
double lead(double level) { return 0.5 / level; }

double sinks(double level, double slope) {
  Slope at;
  at.incline.slope = slope;
  return at.contact(level).approach(floor_height) / radius;
}
// Of the friction that rolls, over what presses.
constexpr double pull = usual_slope / 3;
double creep(double level) {
  const reference::LineContact disk = Slope().contact(level);
  return disk.creep(usual_friction, pull * disk.force);
}

CaseGate stands(const std::string& study, double slope, double level) {
  const double high = radius * (1 - sinks(level, slope)), rows = (1 - std::sqrt(0.75)) / (2 * level);
  return gate(
      study + "/height-" + to_text(level), value_at("height", level), between(high - rows, high + rows),
      theory(
          "Hertz's line contact on a layer [Johnson 5.6], and how much nearer rows of points come where they stand in "
          "each other's gaps: (1 - sqrt(3)/2) of a spacing"));
}

std::vector<CaseGate> rolling_gates(double level, Tier tier) {
  const std::string at = "-" + to_text(level);
  const double slower = lead(level) / usual_slope;
  return {
      gate("default/acceleration" + at, value_at("acceleration_share", level), between(1 - slower, 1 + slower),
           theory("2/3 g (sin(theta) - e/R cos(theta)): a node stands for the points around it, and pressure leads "
                  "by at most e = h/2"))
          .in(tier),
      gate("default/rolls" + at, value_at("rolling_radius", level),
           between(1 - sinks(level, usual_slope), 1 + creep(level)),
           theory(
               "no slip: v = w R, less by at most what the disk sinks in, more by at most its elastic creep (Carter)"))
          .in(tier),
      gate(
          "default/taken" + at, value_at("taken_share", level), between(0, creep(level) * pull / usual_slope),
          theory("what rolls without slip loses nothing; an elastic disk creeps (Carter), and friction takes its force "
                 "times that"))
          .in(tier),
      stands("default", usual_slope, level).in(tier)};
}

CaseGate spins(double level) {
  const double turned = lead(level) / usual_friction + sinks(level, slope_that_slides);
  const CaseGate within = gate("slides/spin-up-" + to_text(level), value_at("spin_share", level),
                               between(1 - turned, 1 + turned),
                               theory("2 mu g cos(theta), with pressure that leads by h/2 and a lever that is as much "
                                      "shorter as the disk sinks in"));
  if (level > 8) return within;
  return CaseGate(within).fails("the patch that is touched is two cells wide there, and pressure leads by .6 of a cell",
                                {0.68, 0.7524}, "2026-11-27 3df1c0b");
}

std::vector<CaseGate> sliding_gates(double level) {
  const std::string at = "-" + to_text(level);
  return {gate("slides/friction" + at, value_at("friction_off", level), between(-lead(level), lead(level)),
               theory("pressure that leads by h/2 on the disk's curved face is tilted by h/(2 R)")),
          spins(level), stands("slides", slope_that_slides, level)};
}

CaseGate gains_nothing(const std::string& study, double level, Tier tier) {
  return gate(study + "/energy-rise-" + to_text(level), value_at("energy_rise", level), at_most(1e-13),
              theory("neither contact nor friction nor the midpoint step raises the energy beyond what gravity does; "
                     "sums over points round at 1e-15"))
      .in(tier);
}

// The pairs press around their middle, a node or two from the faces, and lead by as much as nodes do.
std::vector<CaseGate> pairs_gates(double level) {
  const std::string at = "-" + to_text(level);
  const double slower = lead(level) / usual_slope,
               turned = lead(level) / usual_friction + sinks(level, slope_that_slides);
  const Because leads = theory("what stands for the points around it leads by at most e = h/2");
  return {
      gate("pairs/acceleration" + at, value_at("acceleration_share", level), between(1 - slower, 1 + slower), leads)
          .in(Tier::full),
      gate("pairs/spin-up" + at, value_at("spin_share", level), between(1 - slower, 1 + slower), leads).in(Tier::full),
      gate("pairs-slides/friction" + at, value_at("friction_off", level), between(-lead(level), lead(level)), leads)
          .in(Tier::full),
      gate("pairs-slides/spin-up" + at, value_at("spin_share", level), between(1 - turned, 1 + turned), leads)
          .in(Tier::full)};
}

std::vector<CaseGate> gates() {
  std::vector<CaseGate> all{
      gate("slides/work-16", value_at("work_share", 16), between(0.99, 1.01),
           requirement(
               "friction's work is mu N times the slip within 1 %, so that a coefficient that is off by 2 % is seen")),
      gains_nothing("default", 8, Tier::quick),
      gains_nothing("default", 12, Tier::quick),
      gains_nothing("default", 16, Tier::full),
      gains_nothing("slides", 8, Tier::quick),
      gains_nothing("slides", 16, Tier::quick),
      gains_nothing("pairs", 16, Tier::full),
      gains_nothing("pairs-slides", 16, Tier::full),
      gate("default/acceleration-order", fitted_order_of("acceleration_share"), at_least(0.8),
           theory("first order, as the lead; 0.2 for coarse meshes"))
          .in(Tier::full),
      gate("slides/friction-order", fitted_order_of("friction_off"), at_least(0.8),
           theory("first order, as the lead; 0.2 for coarse meshes"))
          .in(Tier::full)};
  return joined({all, rolling_gates(8, Tier::quick), rolling_gates(12, Tier::quick), rolling_gates(16, Tier::full),
                 rolling_gates(32, Tier::full), sliding_gates(8), sliding_gates(16), pairs_gates(16)});
}

Case rolling_disk() {
  return {.name = "rolling-disk",
          .kind = Kind::solid,
          .keys = Slope().keys(),
          .sets = {{"cells", 16.0}},
          .york1997 = {{"friction", 0.0}},  // his contact has none: in common motion nothing slips
          .york_step = courant_number(0.5),
          .problem = run_of<RollingDisk>,
          .studies = studies(),
          .gates = gates(),
          .levels = {8, 12, 16, 24, 32}};
}
PLUMBLINE_CASE(rolling_disk);

}  // namespace
}  // namespace plumbline::rolling_disk
