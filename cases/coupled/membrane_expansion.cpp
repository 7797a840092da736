// York's membrane expansion: a dog-bone bag that gas blows up to a cylinder.
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <tuple>

#include "cases/coupled/dog_bone.hpp"
#include "cases/harness/archive.hpp"
#include "cases/harness/case.hpp"
#include "cases/harness/gates.hpp"
#include "cases/harness/whole.hpp"
#include "reference/membrane_equilibrium.hpp"

namespace plumbline {
namespace {

constexpr double side = 1.6;             // m, of the quarter's domain
constexpr int averaged_periods = 10;     // of breathing, at the end
constexpr int looks = 20;                // a period
constexpr int rows_wanted = 3000;        // of the history
constexpr double specific_energy = 250;  // J/kg
const MembraneMaterial bag{1e6, 0.3, 0.5, 0.1};

constexpr const char* sketch =
    R"svg(<svg viewBox="0 0 360 170" role="img" aria-label="A quarter of a dog-bone bag with gas inside, and the cylinder that it becomes">
<g fill="none" stroke="currentColor" stroke-width="1.5"><path d="M110 8v150h170"/><path d="M160 158V104q0 -6 6 -6h36q6 0 6 -6v-9q0 -5 -5 -7l-46 -14q-20 -6 -47 -7" stroke-width="2"/><path d="M250 158a140 140 0 0 0 -140 -140" stroke-dasharray="5 4"/></g>
<path d="M110 158h43v-65h47v-9l-47 -16l-43 -5z" fill="currentColor" opacity=".2"/>
<g fill="currentColor" font-size="12"><text x="152" y="169">0.5</text><text x="244" y="169">1.4</text><text x="92" y="60">1</text><text x="116" y="130">gas</text><text x="214" y="96">membrane</text></g></svg>)svg";

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
    auto gas = std::make_shared<IdealGas>();
    gas->viscosity = settings_.number("viscosity");
    gas->viscosity_linear = settings_.number("viscosity.linear");
    gas->viscosity_quadratic = settings_.number("viscosity.quadratic");
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
  Statement statement() const override;
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
  GateCount gate_count() const override { return {55, 76}; }
};

Statement MembraneExpansion::statement() const {
  Statement s;
  s.name = "membrane-expansion";
  s.title = "York's membrane expansion: dog-bone to cylinder";
  s.source = "York 1997, SAND97-1893, section 6.2, tables 4 to 6, input A.4.7";
  s.claim =
      "Gas blows a dog-bone bag up to a cylinder and comes to rest: radius, pressure and hoop stress converge to the "
      "state that energy conservation demands, and stress fits both the radius and the pressure.";
  s.physics =
      "A quarter of a bag on [0, 1.6 m]². Gas with ρ = 1, i = 250 J/kg, γ = 1.4, μ = 0.1 Pa s fills two polygons, "
      "0.47463 m²; the membrane, ρ = 0.5, E = 10⁶ Pa, ν = 0.3, t = 0.1 m, no stress under compression, stands about "
      "0.07 "
      "m outside. Pressure throws it outwards, it overshoots, breathes, and viscosity brings gas and membrane to rest "
      "as a circle.\n\n"
      "The outline is not printed in the report. This one joins York's two printed ends, (0.5, 0) and (0, 1), by a "
      "polygon with rounded corners; its quarter length is 2.19919 m, which his point volumes imply. The end depends "
      "on "
      "the length alone.\n\n"
      "The end is known without a simulation: all energy is the gas's or the membrane's. The membrane of straight "
      "segments has its own rest length (corners cut by chords: 0.08 % at 16 cells) and the reference is solved for "
      "it, with what the ledger booked as lost taken off (`membrane.loss=booked`; with `gas` nothing is lost).\n\n"
      "The radius proves little: the strain is 4·10⁻⁴, so an inextensible bag would pass. What discriminates is the "
      "hoop stress, once against the strain that the radius implies, E′(πR/2L − 1) (`hoop_from_radius`: 0.07 % of "
      "radius is all of the stress), once against pR/t (`hoop_from_pressure`).\n\n"
      "Where York's ten per cent come from. At rest the virial of all forces vanishes node by node, whatever the "
      "shapes "
      "and however coarse the grid: Σ σ_p V_p over the membrane = 2 Σ V_p p_p over the gas = 2(γ − 1)U (`virial`, "
      "which "
      "his scheme meets to 0.2 % here while the bag still moves). So the mean hoop stress is as good as the energy, "
      "and no property of the "
      "membrane can spoil it. But pR/t takes a mean pressure, and Σ V_p p_p is fixed: if the gas points' volumes add "
      "up "
      "to more than the bag encloses (`volume_ratio`), their pressure is low by as much, and stress seems high against "
      "it: σt/(pR) ≈ `volume_ratio` · πR/2L. So york1997 has 1.06 at 8 cells with volumes 13 % too large, 1.04 at 16 "
      "cells with 4 %. York averages pressure over interior grid points, which is lower still (27.0 "
      "against 28.6 here at 16 cells); his stress of 417 Pa is 416 here. His 447 at 32 cells is above what the virial "
      "allows for any mean (432) and can only be a peak.\n\n"
      "Two weaknesses are mended in `default`. Points of one layer have motions that no node sees; as the bag unfolds "
      "these freeze in, and single stresses scatter by more than their mean though the mean is right. Each step takes "
      "out of the segments' forces what a pass to the nodes and back does not return (`membrane.relaxation`). And the "
      "gas's volume: nodal volumes are what of each cell lies inside the membrane, by Green's theorem, and points "
      "share "
      "these volumes instead of densities, so that they sum to the space enclosed.";
  s.equations = {"pR = σt,  σ = E′(πR/2L − 1),  E′ = E/(1 − ν²)", "p πR²/4 = (γ − 1)(U₀ − lost − ½ E′ t L ε²)",
                 "Σ σ_p V_p = 2 Σ p_p V_p  (at rest)",
                 "δx_p = θτ (F_p/m_p − Σ N_ip A_i),  A_i = Σ F_p N_ip / Σ m_p N_ip",
                 "V_p = m_p Σ N_ip |cell_i|/M_i,  |cell_i| = ∫_inside N_i dA"};
  s.sketch = sketch;
  s.cells_along = "the domain's side of 1.6 m; York's meshes h = 0.4, 0.2, 0.1, 0.05 are at 4, 8, 16, 32";
  s.reference_name = "membrane-equilibrium";
  s.reference_text =
      "First law and equilibrium of the bag at rest, for the run's own chords and its own booked loss. Means over the "
      "last ten breathing periods.";
  s.reference_bound = "Rounding of closed forms, computed with the value.";
  s.theory_orders = {{"pressure", 1, "gas and membrane meet inside cells, so the gas's edge is known to a cell"},
                     {"radius_0", 1, "as pressure"}};
  s.known_limits = {
      "`membrane.strain=accumulated`, the only law that needs no connectivity: strain summed from the grid's rates "
      "while "
      "the bag folds and unfolds misses 2.6 % of the length at 16 cells, so radii are that much too large; the mean "
      "stress is right all the same, as the virial demands.",
      "On 4 and 8 cells a bag of six or eleven cells cannot become round.",
      "Under `york1997` on 4 cells the bag folds as roundings will. Twelve runs whose viscosities differ by 3e-15 of "
      "themselves end with radii of 1.148 to 1.204 m at 0 and 1.155 to 1.284 m at 90 degrees, and with "
      "pressures of 28.9 to 32.9 Pa: so the last two, of which York's are some, are measured and not judged there.",
      "The mean radius is short by 3·10⁻⁵ at 16 and at 32 cells, from waves of the shape along the grid, which is 7 % "
      "of "
      "the strain: `hoop_from_radius` can be judged no closer."};
  return s;
}

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
        "default", declare(id, {{}, share}, Origin::target, why), measure, level,
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
    const char* halved = "half of what is asked at h = 0.1: first order";
    const bool first = level == 16;
    for (const char* radius : {"radius_0", "radius_90"}) {
      relative(radius, level, share * 1e-3, first ? "asked of h = 0.1" : halved, tier);
    }
    for (const char* field : {"pressure", "hoop_stress"}) {
      relative(field, level, share * 0.015, first ? "asked of h = 0.1; York's pressure is 13 % low there" : halved,
               tier);
    }
    value("default", "hoop_scatter", level, {{}, share * 0.1}, Origin::target,
          first ? "asked of h = 0.1; without relaxation single stresses scatter by more than their mean" : halved,
          tier);
    value("default", "volume_ratio", level, {1 - share * 0.01, 1 + share * 0.01}, Origin::target,
          first ? "asked of h = 0.1; nodal volumes sum to the enclosed one" : halved, tier);
    value("default", "hoop_from_pressure", level, {1 - share * 0.015, 1 + share * 0.015}, Origin::target,
          first ? "stress against pR/t, as closely as either is asked for" : halved, tier);
    value(
        "default", "hoop_from_radius", level, {0.9, 1.1}, Origin::target,
        "stress against the strain that the mean radius implies: a tenth of it is 4e-5 of the radius, 1/1800 of a cell "
        "at 16 cells, and an inextensible bag would miss by all",
        tier);
    value("default", "escaped_points", level, {{}, 0.0}, Origin::identity, "no gas passes a closed membrane", tier);
  }
  value("default", "virial", 16, {0.995, 1.005}, Origin::theory,
        "an identity at rest, whatever the discretisation; the membrane still breathes by a few thousandths",
        Tier::quick);
  all.push_back(drift_gate("default", declare("default/energy", {{}, 1e-10}, Origin::target,
                                              "asked; the step closes the ledger to rounding")));
  value("default", "energy_lost", 16, {{}, 1e-8}, Origin::identity,
        "all that maps take is given back as heat but for what waits at nodes without gas", Tier::quick);
  CaseGate order = fitted_order_gate("default", "pressure",
                                     declare("default/pressure-order", {0.9, {}}, Origin::target,
                                             "asked; order 1 is what a boundary inside cells allows"));
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
  value("york1997", "hoop_scatter", 8, {{}, 0.1}, Origin::target, "asked of default", Tier::quick);
  all.back().gate = expected_failure(
      all.back().gate,
      "strains that no node sees are frozen in as the bag unfolds: single stresses mean nothing, and "
      "scatter as roundings will (seventeen runs in cases/ensembles.json)",
      {1.0, 11.0}, "2026-11-23 5825b24");
  value("york1997", "volume_ratio", 8, {0.99, 1.01}, Origin::target, "asked of default", Tier::quick);
  all.back().gate = expected_failure(all.back().gate,
                                     "his quadratic density counts cells that the membrane cuts as full: low density, "
                                     "large volumes beside it",
                                     {1.08, 1.18}, stamp);
  value("york1997", "virial", 8, {0.99, 1.01}, Origin::theory,
        "an identity at rest; his bag still moves with 6 % of its energy", Tier::quick);
  all.push_back(error_gate("booked", "pressure", 8,
                           declare("booked/pressure-8", {{}, 0.3}, Origin::target,
                                   "1 % of the pressure: the reference has what the ledger booked taken off")));
  for (const char* radius : {"radius_0", "radius_90"}) {
    all.push_back(beside("modern", "connectivity", radius, 16,
                         declare(std::string("modern/") + radius + "-16", {0.995, 1.005}, Origin::target,
                                 "asked of h = 0.1: without connectivity within half a per cent of the radius with it"),
                         Tier::full));
  }
  for (const auto& [level, tier] : {std::pair{8.0, Tier::quick}, std::pair{16.0, Tier::full}}) {
    all.push_back(beside("modern", "connectivity", "hoop_stress", level,
                         declare("modern/hoop_stress-" + to_text(level), {0.98, 1.02}, Origin::target,
                                 "asked of h = 0.1: within two per cent"),
                         tier));
    value("modern", "escaped_points", level, {{}, 0.0}, Origin::identity, "no gas passes a closed membrane", tier);
  }
  return all;
}

PLUMBLINE_CASE(MembraneExpansion);

}  // namespace
}  // namespace plumbline
