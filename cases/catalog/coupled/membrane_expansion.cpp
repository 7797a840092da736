// York's membrane expansion: a dog-bone bag that gas blows up to a cylinder.
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <tuple>

#include "cases/catalog/coupled/dog_bone.hpp"
#include "cases/catalog/gas/ideal_gas.hpp"
#include "cases/harness/description/archive.hpp"
#include "cases/harness/description/case.hpp"
#include "cases/harness/files/whole.hpp"
#include "cases/harness/judge/gates.hpp"
#include "reference/membrane_equilibrium.hpp"

namespace plumbline {
namespace {

constexpr double side = 1.6;             // m, of the quarter's domain
constexpr int averaged_periods = 10;     // of breathing, at the end
constexpr int looks = 20;                // a period
constexpr int rows_wanted = 3000;        // of the history
constexpr double specific_energy = 250;  // J/kg
const MembraneMaterial bag{1e6, 0.3, 0.5, 0.1};

class MembraneExpansionRun final : public Problem {
 public:
  explicit MembraneExpansionRun(const Settings& settings)
      : settings_(settings),
        h_(side / settings.number("cells")),
        curve_(dog_bone_outline(segments())),
        gas_energy_(std::abs(enclosed(dog_bone_gas())) * specific_energy),
        period_(expected(0).breathing_period.value),
        next_look_(end_time() - averaged_periods * period_) {}

  double end_time() const override { return settings_.number("t_end"); }

  Scene scene() const override {
    Scene scene;
    scene.grid.dim = 2;
    scene.grid.h = h_;
    scene.grid.cells = {settings_.integer("cells"), settings_.integer("cells"), 1};
    // York's outer sides are fixed; the bag never comes near.
    for (auto& wall : scene.grid.walls) wall = {Wall::symmetry, Wall::symmetry};
    auto gas = chosen_gas(settings_, IdealGas().gamma);
    gas->viscosity = settings_.number("viscosity");
    Body inside = fill_polygon("gas", gas, scene.grid, settings_.integer("ppc"), dog_bone_gas(), 1, specific_energy);
    if (settings_.text("density") == "grid") inside.enclosure = Enclosure{"membrane", corners()};
    scene.bodies.push_back(std::move(inside));
    scene.bodies.push_back(membrane_body(settings_, "membrane", bag, curve_));
    apply_choices(settings_, scene);
    return scene;
  }

  void observe(const Simulation& simulation) override {
    const auto& bodies = simulation.scene().bodies;
    if (simulation.time() >= next_row_) {
      next_row_ += end_time() / rows_wanted;
      rows_.push_back(row(simulation));
    }
    if (simulation.time() < next_look_) return;
    next_look_ += period_ / looks;
    const BagState now = look_at(bodies[0], bodies[1], bag, corners());
    const auto [r0, r90, mean] = radii(bodies[1]);
    ++count_;
    sums_.radius_0 += r0;
    sums_.radius_90 += r90;
    sums_.radius += mean;
    sums_.pressure += now.pressure;
    sums_.hoop += now.hoop_stress;
    sums_.scatter += now.hoop_scatter;
    sums_.volume_ratio += now.gas_volume / now.area;
    sums_.internal += simulation.ledger().stores.internal;
    sums_.virial += now.pressure * now.gas_volume;
    escaped_ = std::max(escaped_, now.escaped);
  }
  void history(Archive& archive) override {
    archive("next_look", next_look_);
    archive("next_row", next_row_);
    archive("rows", rows_);
    archive("sums", sums_);
    archive("count", count_);
    archive("escaped", escaped_);
  }

  std::vector<Measure> measures(const Simulation& simulation) const override {
    const Account& energy = simulation.ledger().energy;
    const double lost = std::max(0.0, energy.initial() - energy.store());
    const reference::MembraneState exact = expected(lost);
    const double n = count_, radius = sums_.radius / n, pressure = sums_.pressure / n, hoop = sums_.hoop / n;
    const double chords = segments(), turn = std::numbers::pi / (4 * chords);
    const double stretched = by_segments() ? 2 * chords * radius * std::sin(turn) : std::numbers::pi / 2 * radius;
    const double from_radius = bag.plane_modulus() * (stretched / length(curve_) - 1);
    const auto against = [](const char* name, double value, const reference::Bounded& r, const char* unit) {
      return scalar_measure(name, value, r.value, r.bound, unit);
    };
    const auto ratio = [](const char* name, double value, double reference) {
      Measure m = scalar_measure(name, value, reference, 1e-15, "1");
      m.scale = 1;
      return m;
    };
    return {against("radius_0", sums_.radius_0 / n, exact.radius, "m"),
            against("radius_90", sums_.radius_90 / n, exact.radius, "m"),
            against("pressure", pressure, exact.pressure, "Pa"),
            against("hoop_stress", hoop, exact.stress, "Pa"),
            ratio("hoop_scatter", sums_.scatter / n, 0),
            ratio("hoop_from_radius", hoop / from_radius, 1),
            ratio("hoop_from_pressure", hoop * bag.thickness / (pressure * radius), 1),
            ratio("virial", hoop * bag.thickness * length(curve_) / (2 * sums_.virial / n), 1),
            ratio("volume_ratio", sums_.volume_ratio / n, 1),
            ratio("escaped_points", escaped_, 0),
            ratio("energy_lost", lost / gas_energy_, 0)};
  }

  Profile profile(const Simulation&) const override {
    return history_profile({{"t", "s", "t", {}},
                            {"radius_0", "m", "radius at 0 degrees", {}},
                            {"radius_90", "m", "radius at 90 degrees", {}},
                            {"radius_end", "m", "exact radius at the end", {}},
                            {"gas_energy", "J/m", "internal energy of the gas", {}},
                            {"kinetic_energy", "J/m", "kinetic energy", {}},
                            {"membrane_energy", "J/m", "elastic energy of the membrane", {}},
                            {"total_energy", "J/m", "their sum", {}}},
                           rows_);
  }

 private:
  static Curve corners() { return {{0, 0}}; }
  bool by_segments() const { return settings_.text("membrane.strain") == "segments"; }
  int segments() const {
    return std::max(4, whole(std::round(settings_.number("membrane.ppc") * dog_bone_length / h_)));
  }

  // At rest, of the membrane as it is made of straight segments.
  reference::MembraneState expected(double lost) const {
    reference::MembraneEquilibriumProblem p;
    p.gas_energy = gas_energy_;
    p.gas_area = gas_energy_ / specific_energy;
    p.length = length(curve_);
    p.lost = lost;
    if (!by_segments()) p.law = reference::MembraneLaw::accumulated;
    return reference::MembraneEquilibrium(p).state(by_segments() ? segments() : 0);
  }

  // At 0 degrees, at 90 degrees, and the mean over all points.
  static std::array<double, 3> radii(const Body& membrane) {
    const double *x = membrane.points(column::position), *y = membrane.points(column::position, 1);
    const int last = membrane.points.points() - 1;
    double sum = 0;
    for (int p = 0; p <= last; ++p) sum += std::hypot(x[p], y[p]);
    return {std::hypot(x[0], y[0]), std::hypot(x[last], y[last]), sum / (last + 1)};
  }

  std::vector<double> row(const Simulation& simulation) const {
    const auto [r0, r90, mean] = radii(simulation.scene().bodies[1]);
    const EnergyStores& stores = simulation.ledger().stores;
    return {simulation.time(), r0, r90, expected_radius_, stores.internal, stores.kinetic, stores.elastic,
            stores.total()};
  }

  Settings settings_;
  double h_;
  Curve curve_;
  double gas_energy_, period_, next_look_, next_row_ = 0, expected_radius_ = expected(0).radius.value;
  std::vector<std::vector<double>> rows_;
  struct {
    double radius_0 = 0, radius_90 = 0, radius = 0, pressure = 0, hoop = 0, scatter = 0, volume_ratio = 0, internal = 0,
           virial = 0;
    void history(Archive& archive) {
      archive("radius_0", radius_0);
      archive("radius_90", radius_90);
      archive("radius", radius);
      archive("pressure", pressure);
      archive("hoop", hoop);
      archive("scatter", scatter);
      archive("volume_ratio", volume_ratio);
      archive("internal", internal);
      archive("virial", virial);
    }
  } sums_;
  int count_ = 0, escaped_ = 0;
};

// York's tables 5 and 6, by cells.
struct Published {
  double cells, radius_0, radius_90, pressure, hoop;
};
constexpr Published tables[] = {{4, 1.08, 1.13, 33.4, 394},
                                {8, 1.335, 1.334, 24.9, 372},
                                {16, 1.388, 1.387, 27.0, 417},
                                {32, 1.394, 1.396, 29.0, 447}};

// One number of a run over the same of another study's run at the same level.
CaseGate beside(const std::string& study, const std::string& other, const std::string& measure, double level, Gate gate,
                Tier tier) {
  gate.quantity = measure + " over that of " + other + " at " + to_text(level);
  CaseGate g = study_gate(
      study, std::move(gate),
      [other, measure, level](const StudyResult& s) {
        Measured measured;
        const StudyLevel *here = s.level(level), *there = s.sibling(other)->level(level);
        const Measure *a = here ? here->run.find(measure) : nullptr, *b = there ? there->run.find(measure) : nullptr;
        measured.value = a && b && a->value && b->value ? *a->value / *b->value : std::nan("");
        return measured;
      },
      {level}, tier);
  g.also = {other};
  return g;
}

class MembraneExpansion final : public Case {
 public:
  std::string name() const override { return "membrane-expansion"; }
  Kind kind() const override { return Kind::coupled; }
  std::vector<Key> keys() const override {
    return {positive_key("t_end", 8.5, "s", "end time; York's is 8.5 to 10"),
            {.name = "viscosity",
             .value = 0.1,
             .unit = "Pa s",
             .low = 0,
             .high = 10,
             .description = "of the gas, which brings it to rest"}};
  }
  std::vector<Override> points_and_end(const std::string& scheme) const override {
    if (scheme == "york1997") return {{"cells", 16.0}, {"ppc", 64.0}, {"membrane.ppc", 9.1}};
    return {{"cells", 16.0}};
  }
  // His step of 3.5e-5 s at h = 0.05, in proportion to h. [York A.4.7]
  void derive(Settings& settings, const std::string& scheme) const override {
    if (scheme != "york1997" || settings.is_set("dt") || settings.is_set("cfl")) return;
    settings.set("dt", 3.5e-5 * 32 / settings.number("cells"), "membrane-expansion");
  }
  std::unique_ptr<Problem> problem(const Settings& settings) const override {
    return std::make_unique<MembraneExpansionRun>(settings);
  }
  std::vector<double> default_levels() const override { return {4, 6, 8, 12, 16}; }
  std::vector<StudyPlan> studies() const override;
  std::vector<CaseGate> gates() const override;
};

std::vector<StudyPlan> MembraneExpansion::studies() const {
  return {
      {.id = "default",
       .title = "default, to 5 s",
       .why = "Gas and membrane meet inside cells: order 1 at least. At 5 s all is as much at rest as at York's 8.5 s.",
       .overrides = {{"t_end", 5.0}},
       .values = {4, 6, 8, 12, 16},
       .full_values = {4, 6, 8, 12, 16, 24, 32},
       .frames = 25,
       .frames_at = 16.0},
      {.id = "unfolding",
       .title = "the first half second of default",
       .why = "To look at: two levels, no order.",
       .overrides = {{"t_end", 0.5}},
       .values = {8, 16},
       .frames = 25},
      {.id = "york1997",
       .title = "york1997, 64 points a cell: tables 5 and 6",
       .why = "York's own four meshes.",
       .scheme = "york1997",
       .values = {4, 8},
       .full_values = {4, 8, 16, 32}},
      {.id = "booked",
       .title = "default, losses booked",
       .why = "The end with less energy.",
       .overrides = {{"membrane.loss", "booked"}, {"t_end", 5.0}},
       .values = {8},
       .full_values = {8, 16}},
      {.id = "connectivity",
       .title = "accumulated strain, tangents by connectivity",
       .why = "For comparison with the next.",
       .overrides = {{"membrane.strain", "accumulated"}},
       .values = {8},
       .full_values = {8, 16}},
      {.id = "modern",
       .title = "accumulated strain, tangents without connectivity",
       .why = "York's open problem: no order of points is known.",
       .overrides = {{"membrane.strain", "accumulated"}, {"normals", "modern"}},
       .values = {8},
       .full_values = {8, 16}}};
}

std::vector<CaseGate> MembraneExpansion::gates() const {
  std::vector<CaseGate> all;
  const auto relative = [&](const char* measure, double level, double share, const char* why, Tier tier) {
    const std::string id = std::string("default/") + measure + "-" + to_text(level);
    CaseGate g = measure_gate(
        "default", declare(id, {{}, share}, Origin::requirement, why), measure, level,
        [](const RunResult&, const Measure& m) {
          Measured measured;
          measured.value = m.error / m.scale;
          measured.reference_bound = m.reference_bound / m.scale;
          return measured;
        },
        tier);
    g.gate.quantity = std::string("relative error of ") + measure + " at " + to_text(level);
    all.push_back(g);
  };
  const auto value = [&](const std::string& study, const char* measure, double level, Range range, Origin origin,
                         const char* why, Tier tier) {
    const std::string id = study + "/" + measure + "-" + to_text(level);
    all.push_back(value_gate(study, measure, level, declare(id, range, origin, why), tier));
  };
  for (const auto& [level, share, tier] : {std::tuple{16.0, 1.0, Tier::quick}, std::tuple{32.0, 0.5, Tier::full}}) {
    const char* halved = "half of what is required at h = 0.1: first order";
    const bool first = level == 16;
    for (const char* radius : {"radius_0", "radius_90"}) {
      relative(radius, level, share * 1e-3,
               first ? "a thousandth at h = 0.1, 1/70 of a cell; York's bag breathes by 2 %" : halved, tier);
    }
    relative("pressure", level, share * 0.015, first ? "1.5 % at h = 0.1, where York's pressure is 13 % low" : halved,
             tier);
    relative("hoop_stress", level, share * 0.015, first ? "1.5 % at h = 0.1, as of the pressure that it bears" : halved,
             tier);
    value("default", "hoop_scatter", level, {{}, share * 0.1}, Origin::requirement,
          first ? "a tenth of the mean at h = 0.1; without relaxation single stresses scatter by more than their mean"
                : halved,
          tier);
    value("default", "volume_ratio", level, {1 - share * 0.01, 1 + share * 0.01}, Origin::requirement,
          first
              ? "within 1 % at h = 0.1: nodal volumes sum to the enclosed one; by York's density they are 4 % too large"
              : halved,
          tier);
    value("default", "hoop_from_pressure", level, {1 - share * 0.015, 1 + share * 0.015}, Origin::requirement,
          first ? "stress against pR/t, as close as either must be to its own reference" : halved, tier);
    value(
        "default", "hoop_from_radius", level, {0.9, 1.1}, Origin::requirement,
        "stress against the strain that the mean radius implies: a tenth of it is 4e-5 of the radius, 1/1800 of a cell "
        "at 16 cells, and an inextensible bag would miss by all",
        tier);
    value("default", "escaped_points", level, {{}, 0.0}, Origin::identity, "no gas passes a closed membrane", tier);
  }
  value("default", "virial", 16, {0.995, 1.005}, Origin::theory,
        "an identity at rest, whatever the discretisation; the membrane still breathes by a few thousandths",
        Tier::quick);
  all.push_back(
      drift_gate("default", declare("default/energy", {{}, 1e-10}, Origin::identity,
                                    "the step closes the energy ledger to rounding, which adds up over the steps")));
  value("default", "energy_lost", 16, {{}, 1e-8}, Origin::identity,
        "all that maps take is given back as heat but for what waits at nodes without gas", Tier::quick);
  CaseGate order = fitted_order_gate("default", "pressure",
                                     declare("default/pressure-order", {0.9, {}}, Origin::theory,
                                             "order 1 is what a boundary inside cells allows; 0.1 for coarse meshes"));
  all.push_back(order);
  const std::string stamp = "2026-11-21 6c78473";
  for (const Published& row : tables) {
    const Tier tier = row.cells > 8 ? Tier::full : Tier::quick;
    const auto york = [&](const char* measure, double printed, double share, const char* why) -> Gate& {
      value("york1997", measure, row.cells, {printed * (1 - share), printed * (1 + share)}, Origin::literature, why,
            tier);
      return all.back().gate;
    };
    const auto fails = [&](Gate& gate, const char* cause, double was, double share) {
      gate = expected_failure(gate, cause, {was * (1 - share), was * (1 + share)}, stamp);
    };
    Gate& r0 = york("radius_0", row.radius_0, 0.03, "table 5; outline and start differ, and his bag breathes by 2 %");
    if (row.cells == 4) {
      r0 = expected_failure(
          r0, "a bag five cells long folds as its outline does, which is not his; and as roundings will, within 5 %",
          {1.12, 1.26}, "2026-11-22 64431e8");
    }
    // On 4 cells these two are no property of the scheme: see the known limits.
    if (row.cells > 4) {
      york("radius_90", row.radius_90, 0.03, "table 5; outline and start differ, and his bag breathes by 2 %");
      Gate& p = york("pressure", row.pressure, 0.05, "table 5, a mean over interior grid points; here over points");
      const char* mean =
          "his mean over interior grid points is not one over the gas: it counts cells alike, and what little "
          "gas stands beside the membrane not at all; here energy over volume, the volumes too large";
      if (row.cells == 8) fails(p, mean, 28.5, 0.04);
      if (row.cells == 16) fails(p, mean, 28.6, 0.02);
    }
    Gate& hoop = york("hoop_stress", row.hoop, 0.05,
                      "table 6; no mean can differ from the virial's by more than the energy does");
    if (row.cells == 8) fails(hoop, "he lost 3.4 % of the energy, this run 0.5 % with 6 % in motion", 403, 0.03);
    if (row.cells == 32) {
      hoop = expected_failure(
          hoop,
          "first law and virial allow a mean of 432 Pa with nothing lost; this run loses 2 % of the "
          "energy",
          {409, 426}, "2026-11-22 7c0a6a5");
    }
  }
  value("york1997", "hoop_scatter", 8, {{}, 0.1}, Origin::requirement,
        "a tenth of the mean, as of the default scheme at h = 0.1", Tier::quick);
  all.back().gate = expected_failure(
      all.back().gate,
      "strains that no node sees are frozen in as the bag unfolds: single stresses mean nothing, and "
      "scatter as roundings will (seventeen runs in cases/ensembles.json)",
      {1.0, 11.0}, "2026-11-23 5825b24");
  value("york1997", "volume_ratio", 8, {0.99, 1.01}, Origin::requirement,
        "within 1 %, as of the default scheme at h = 0.1", Tier::quick);
  all.back().gate = expected_failure(all.back().gate,
                                     "his quadratic density counts cells that the membrane cuts as full: low density, "
                                     "large volumes beside it",
                                     {1.08, 1.18}, stamp);
  value("york1997", "virial", 8, {0.99, 1.01}, Origin::theory,
        "an identity at rest; his bag still moves with 6 % of its energy", Tier::quick);
  all.push_back(error_gate("booked", "pressure", 8,
                           declare("booked/pressure-8", {{}, 0.3}, Origin::requirement,
                                   "1 % of the pressure, below the 1.5 % without losses at h = 0.1: the reference has "
                                   "what the ledger booked taken off")));
  for (const char* radius : {"radius_0", "radius_90"}) {
    all.push_back(
        beside("modern", "connectivity", radius, 16,
               declare(std::string("modern/") + radius + "-16", {0.995, 1.005}, Origin::requirement,
                       "without connectivity within half a per cent of the radius with it: 0.07 cells at h = 0.1"),
               Tier::full));
  }
  for (const auto& [level, tier] : {std::pair{8.0, Tier::quick}, std::pair{16.0, Tier::full}}) {
    all.push_back(beside(
        "modern", "connectivity", "hoop_stress", level,
        declare("modern/hoop_stress-" + to_text(level), {0.98, 1.02}, Origin::requirement,
                "without connectivity within 2 % of the stress with it, a fifth of the 10 % that York's was off by"),
        tier));
    value("modern", "escaped_points", level, {{}, 0.0}, Origin::identity, "no gas passes a closed membrane", tier);
  }
  return all;
}

PLUMBLINE_CASE(MembraneExpansion);

}  // namespace
}  // namespace plumbline
