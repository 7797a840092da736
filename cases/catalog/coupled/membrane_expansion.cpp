// York's membrane expansion: a dog-bone bag that gas blows up to a cylinder. Long for its gates: two levels and two schemes of
// the whole of his chapter 7, each with what was printed beside what a closed bag must do.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "cases/catalog/coupled/coupled_gates.hpp"
#include "cases/catalog/coupled/dog_bone.hpp"
#include "cases/catalog/gas/ideal_gas.hpp"
#include "cases/harness/description/archive.hpp"
#include "cases/harness/description/case.hpp"
#include "cases/harness/description/parameters.hpp"
#include "cases/harness/files/whole.hpp"
#include "cases/harness/judge/gates.hpp"
#include "reference/membrane_equilibrium.hpp"

namespace plumbline::membrane_expansion {
namespace {

constexpr double side = 1.6;             // m, of the quarter's domain
constexpr int averaged_periods = 10;     // of breathing, at the end
constexpr int looks = 20;                // a period
constexpr int rows_wanted = 3000;        // of the history
constexpr double specific_energy = 250;  // J/kg
const MembraneMaterial bag{1e6, 0.3, 0.5, 0.1};

struct Expansion : Parameters {
  using Parameters::Parameters;
  double end_time = positive("t_end", 8.5, "s", "end time; York's is 8.5 to 10");
  double viscosity = number({.name = "viscosity",
                             .value = 0.1,
                             .unit = "Pa s",
                             .low = 0,
                             .high = 10,
                             .description = "of the gas, which brings it to rest"});
  bool given =
      method(
          "connectivity", "given", {"given", "found"},
          "who follows whom along the membrane: said, or found from where its points stand, which come in no order") ==
      "given";
};

class MembraneExpansionRun final : public Problem {
 public:
  explicit MembraneExpansionRun(const Settings& settings)
      : settings_(settings),
        at_(settings),
        h_(side / settings.number("cells")),
        curve_(at_.given ? dog_bone_outline(segments())
                         : in_order(out_of_order(dog_bone_outline(segments())), corners())),
        gas_energy_(std::abs(enclosed(dog_bone_gas())) * specific_energy),
        period_(expected(0).breathing_period.value),
        next_look_(end_time() - averaged_periods * period_) {}

  double end_time() const override { return at_.end_time; }

  Scene scene() const override {
    Scene scene;
    scene.grid.dim = 2;
    scene.grid.h = h_;
    scene.grid.cells = {settings_.integer("cells"), settings_.integer("cells"), 1};
    // York's outer sides are fixed; the bag never comes near.
    for (auto& wall : scene.grid.walls) wall = {Wall::symmetry, Wall::symmetry};
    auto gas = chosen_gas(settings_, IdealGas().gamma);
    gas->viscosity = at_.viscosity;
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
    const BagState now = look_at(bodies[0], bodies[1], bag, closing(bodies[1]));
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
      return share_measure(name, value, reference, 1e-15);
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
  // Of points at the middles of chords the first and the last stand half a chord from the walls that the bag ends on.
  Curve closing(const Body& membrane) const {
    if (by_segments()) return corners();
    const double *x = membrane.points(column::position), *y = membrane.points(column::position, 1);
    return {{0, y[membrane.points.points() - 1]}, {0, 0}, {x[0], 0}};
  }
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
  Expansion at_;
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

// Snapshots of a run, a tenth of a second apart: York's text speaks of 0.1 s.
int every_tenth(double end) { return 1 + whole(std::round(10 * end)); }

// A level of york1997 again, which is no second run.
StudyPlan york_to_look_at(double cells) {
  return study("york-shapes-" + to_text(cells), "york1997 on " + to_text(cells) + " cells",
               "To look at: Figs. 52 and 54.", {cells})
      .of_york()
      .in(Tier::full)
      .pictured(every_tenth(8.5));
}

// Fig. 87: to 0.8 s. York does not say on which mesh.
StudyPlan first_second(std::string id, std::string title, const std::string& method) {
  return study(std::move(id), std::move(title), "One mesh, that of his simulation 3.", {16})
      .of_york()
      .with({{"normals", method}, {"t_end", 0.8}})
      .in(Tier::full)
      .pictured(17);
}

std::vector<StudyPlan> studies() {
  const Override five_seconds{"t_end", 5.0}, accumulated{"membrane.strain", "accumulated"};
  return {
      study("default", "default, to 5 s",
            "Gas and membrane meet inside cells: order 1 at least. At 5 s all is as much at rest as at "
            "York's 8.5 s.",
            {4})
          .with({five_seconds})
          .in_full({4, 6, 8, 12, 16, 24, 32})
          .pictured(every_tenth(5), 4),
      study("viscous", "default, fifteen times York's viscosity, to 1.5 s",
            "The end does not depend on what brings it to rest: the bounds of default on its mesh of h = 0.1, "
            "a third as long.",
            {16})
          .with({{"viscosity", 1.5}, {"t_end", 1.5}})
          .pictured(every_tenth(1.5)),
      study("unfolding", "the first half second of default", "To look at: two levels, no order.", {8})
          .with({{"t_end", 0.5}})
          .in_full({8, 16})
          .pictured(25),
      study("york1997", "york1997, 64 points a cell: tables 5 and 6", "York's own four meshes.", {4})
          .of_york()
          .in_full({4, 8, 16, 32})
          .pictured(every_tenth(8.5), 4),
      york_to_look_at(16),
      york_to_look_at(32),
      first_second("york-connectivity", "York's run of Fig. 87, tangents by connectivity", "connectivity"),
      first_second("york-mass-matrix-quadratic", "the same, his quadratic mass matrix", "york-mass-matrix-quadratic"),
      first_second("york-mass-matrix", "the same, his mass matrix with linear shapes", "york-mass-matrix"),
      study("booked", "default, losses booked", "The end with less energy.", {6})
          .with({{"membrane.loss", "booked"}, five_seconds})
          .in_full({6, 8, 16}),
      study("found", "default, who follows whom found",
            "The points come in no order, at the levels of York's first three meshes.", {4})
          .with({five_seconds, {"connectivity", "found"}})
          .in_full({4, 8, 16}),
      study("modern", "accumulated strain, tangents without connectivity",
            "York's open problem as he saw it: strain from rates, no order of points known.", {8})
          .with({five_seconds, accumulated, {"normals", "modern"}})
          .in_full({8, 16})};
}

Number relative_error_at(const std::string& measure, double level) {
  return number_at("relative error of " + measure + " at " + to_text(level), measure, level,
                   [](const RunResult&, const Measure& m) {
                     Measured measured = Measured::of(m.error / m.scale);
                     measured.reference_bound = m.reference_bound / m.scale;
                     return measured;
                   });
}

// STUDY/MEASURE-LEVEL, on a number of that measure at that level.
CaseGate judged(const std::string& study, Number (*number)(const std::string&, double), const std::string& measure,
                double level, Range expected, Because because) {
  return gate(study + "/" + measure + "-" + to_text(level), number(measure, level), expected, std::move(because));
}

Range around(double value, double share) { return between(value * (1 - share), value * (1 + share)); }

const Because nothing_passes = identity("no gas passes a closed membrane");

// At 16 cells, h = 0.1, and at 32, where half as much is allowed.
std::vector<CaseGate> gates_at(const std::string& study, double level, Tier tier) {
  const bool first = level == 16;
  const double share = first ? 1.0 : 0.5;
  const auto required = [&](const char* why) {
    return requirement(first ? why : "half of what is required at h = 0.1: first order");
  };
  const Because thousandth = required("a thousandth at h = 0.1, 1/70 of a cell; York's bag breathes by 2 %");
  const auto relative = [&](const char* measure, double most, const Because& because) {
    return judged(study, relative_error_at, measure, level, at_most(share * most), because);
  };
  const auto value = [&](const char* measure, Range expected, const Because& because) {
    return judged(study, value_at, measure, level, expected, because);
  };
  std::vector<CaseGate> all{
      relative("radius_0", 1e-3, thousandth),
      relative("radius_90", 1e-3, thousandth),
      relative("pressure", 0.015, required("1.5 % at h = 0.1, where York's pressure is 13 % low")),
      relative("hoop_stress", 0.015, required("1.5 % at h = 0.1, as of the pressure that it carries")),
      value("hoop_scatter", at_most(share * 0.1),
            required("a tenth of the mean at h = 0.1; without relaxation single stresses scatter by more than "
                     "their mean")),
      value("volume_ratio", between(1 - share * 0.01, 1 + share * 0.01),
            required("within 1 % at h = 0.1: nodal volumes sum to the enclosed one; by York's density they are 4 "
                     "% too large")),
      value("hoop_from_pressure", between(1 - share * 0.015, 1 + share * 0.015),
            required("stress against pR/t, as close as either must be to its own reference")),
      value("hoop_from_radius", between(0.9, 1.1),
            requirement("stress against the strain that the mean radius implies: a tenth of it is 4e-5 of the "
                        "radius, 1/1800 of a cell at 16 cells, and an inextensible bag would miss by all")),
      value("escaped_points", at_most(0), nothing_passes)};
  for (CaseGate& gate : all) gate.tier = tier;
  return all;
}

// What holds on any mesh once the bag is at rest, at h = 0.1.
std::vector<CaseGate> identities_of(const std::string& study, Tier tier) {
  std::vector<CaseGate> all{
      judged(study, value_at, "virial", 16, between(0.995, 1.005),
             theory("an identity at rest, whatever the discretisation; the membrane still breathes by a few "
                    "thousandths")),
      judged(study, value_at, "energy_lost", 16, at_most(1e-8),
             identity("all that maps take is given back as heat but for what waits at nodes without gas"))};
  for (CaseGate& gate : all) gate.tier = tier;
  return all;
}

// What York's tables 5 and 6 print, on his four meshes.
std::vector<CaseGate> york_gates() {
  const auto printed = [](const char* measure, double cells, double value, double share, const char* why) {
    return judged("york1997", value_at, measure, cells, around(value, share), literature(why))
        .in(cells > 4 ? Tier::full : Tier::quick);
  };
  const auto radius = [&](const char* measure, double cells, double value) {
    return printed(measure, cells, value, 0.03, "table 5; outline and start differ, and his bag breathes by 2 %");
  };
  const auto pressure = [&](double cells, double value) {
    return printed("pressure", cells, value, 0.05, "table 5, a mean over interior grid points; here over points");
  };
  const auto hoop = [&](double cells, double value) {
    return printed("hoop_stress", cells, value, 0.05,
                   "table 6; no mean can differ from the virial's by more than the energy does");
  };
  const std::string stamp = "2026-11-21 6c78473";
  const std::string mean =
      "his mean over interior grid points is not one over the gas: it counts cells alike, and what little gas "
      "stands beside the membrane not at all; here energy over volume, the volumes too large";
  const std::string
      torn_on = "2026-11-26 05844c9",
      torn =
          "the bag tears at 3.3 s, before that its radius, 1.42, is 2 % above his: strains summed from rates let it "
          "grow, and at one place the points drift apart until one flies off; gas and membrane then stand at the "
          "walls";
  // On 4 cells the second radius and the pressure are no property of the scheme: see the known limits.
  return {
      radius("radius_0", 4, 1.08)
          .fails("a bag five cells long folds as its outline does, which is not his; and as roundings will, "
                 "within 5 %",
                 {1.12, 1.26}, "2026-11-22 64431e8"),
      hoop(4, 394),
      radius("radius_0", 8, 1.335),
      radius("radius_90", 8, 1.334),
      pressure(8, 24.9).fails(mean, around(28.5, 0.04), stamp),
      hoop(8, 372).fails("he lost 3.4 % of the energy, this run 0.5 % with 6 % in motion", around(403, 0.03), stamp),
      radius("radius_0", 16, 1.388),
      radius("radius_90", 16, 1.387),
      pressure(16, 27.0).fails(mean, around(28.6, 0.02), stamp),
      hoop(16, 417),
      radius("radius_0", 32, 1.394).fails(torn, {1.5, 1.62}, torn_on),
      radius("radius_90", 32, 1.396).fails(torn, {1.5, 1.62}, torn_on),
      pressure(32, 29.0).fails(torn, {15.5, 18.5}, torn_on),
      gate("york1997/hoop_stress-32",
           number_at(
               "hoop_stress at 32 less York's 447 Pa", "hoop_stress", 32,
               [](const RunResult&, const Measure& mean_stress) { return Measured::of(*mean_stress.value - 447); }),
           between(-0.05 * 447, 0.05 * 447), literature("table 6"))
          .fails(torn, {-447, -400}, torn_on)
          .in(Tier::full),

      judged("york1997", value_at, "hoop_scatter", 8, at_most(0.1),
             requirement("a tenth of the mean, as of the default scheme at h = 0.1"))
          .fails("strains in null-space modes of the maps are frozen in as the bag unfolds: single stresses mean "
                 "nothing, and scatter as roundings will (seventeen runs in cases/ensembles.json)",
                 {1.0, 11.0}, "2026-11-23 5825b24")
          .in(Tier::full),
      judged("york1997", value_at, "volume_ratio", 8, between(0.99, 1.01),
             requirement("within 1 %, as of the default scheme at h = 0.1"))
          .fails("his quadratic density counts cells that the membrane cuts as full: low density, large volumes "
                 "beside it",
                 {1.08, 1.18}, stamp)
          .in(Tier::full),
      judged("york1997", value_at, "virial", 8, between(0.99, 1.01),
             theory("an identity at rest; his bag still moves with 6 % of its energy"))
          .in(Tier::full)};
}

// Energies of Figs. 49, 51, 53 and 55, of which the text gives what is lost, and what it says of the end.
std::vector<CaseGate> york_energy_gates() {
  const std::string stamp = "2026-11-26 05844c9";
  const std::string noise = "much that viscosity should have brought to rest is still in motion at the end: ";
  const auto beyond_york = [&](double cells, double york, const char* says, const char* cause, Range band) {
    return gate("york1997/energy_lost-" + to_text(cells),
                number_at("share of the energy lost, less York's " + to_text(york) + ", at " + to_text(cells),
                          "energy_lost", cells,
                          [york](const RunResult&, const Measure& lost) { return Measured::of(*lost.value - york); }),
                between(-5e-4, 5e-4), literature(says))
        .fails(noise + cause, band, stamp)
        .in(cells > 4 ? Tier::full : Tier::quick);
  };
  const Number out_of_round = number_at("difference of the radii at 0 and 90 degrees over the one at 90, at 8",
                                        "radius_0", 8, [](const RunResult& run, const Measure& at_0) {
                                          return Measured::of(std::abs(*at_0.value / value_of(run, "radius_90") - 1));
                                        });
  return {beyond_york(4, 0.036, "York, section 6.2.1: about 3.6 % lost; half a digit",
                      "10 % of the energy, and 0.4 % is lost", {-0.0345, -0.031}),
          beyond_york(8, 0.034, "York, section 6.2.2: about 3.4 % lost; half a digit", "6 % of it, and 0.5 % is lost",
                      {-0.031, -0.027}),
          beyond_york(16, 0.012, "York, section 6.2.3: about 1.2 % lost; half a digit", "3 % of it, and 0.7 % is lost",
                      {-0.0062, -0.0046}),
          judged("york1997", value_at, "energy_lost", 32, at_most(0.01),
                 literature("York, section 6.2.4: less than 1 % lost"))
              .fails("the bag tears at 3.3 s (radius_0-32), when 0.7 % is lost; gas that streams out takes the rest",
                     {0.07, 0.092}, stamp)
              .in(Tier::full),
          gate("york1997/round-8", out_of_round, at_most(0.02),
               literature("York, section 6.2.2: radii approximately equal; 2 %, by which his bag breathes"))
              .in(Tier::full),
          judged("york1997", value_at, "escaped_points", 4, at_most(0),
                 literature("York, section 6.2.1: gas does not escape")),
          judged("york1997", value_at, "escaped_points", 8, at_most(0), nothing_passes).in(Tier::full),
          judged("york1997", value_at, "escaped_points", 16, at_most(0), nothing_passes).in(Tier::full)};
}

// Fig. 87: normals by York's mass matrices beside those by connectivity.
std::vector<CaseGate> mass_matrix_gates() {
  const auto radius = [](const RunResult& run) {
    return 0.5 * (value_of(run, "radius_0") + value_of(run, "radius_90"));
  };
  const auto over = [radius](const char* study, const char* name, const char* other, const char* says) {
    return gate(std::string(study) + "/" + name,
                number_of(std::string("mean radius at the end over that of ") + other,
                          [=](const StudyResult& s) {
                            return Measured::of(radius(s.level(16)->run) / radius(s.sibling(other)->level(16)->run));
                          },
                          {16}),
                at_least(1), literature(says))
        .beside({other})
        .in(Tier::full);
  };
  // The first of his pictures after the start.
  const auto apart_at_first = [](const StudyResult& s) {
    const auto at = [](const StudyResult& of, const char* column) {
      const Profile& history = of.level(16)->run.profile;
      const std::vector<double>& time = history.find("t")->values;
      const auto row = std::lower_bound(time.begin(), time.end(), 0.05) - time.begin();
      return history.find(column)->values.at(static_cast<std::size_t>(row));
    };
    double most = 0;
    for (const char* column : {"radius_0", "radius_90"}) {
      most = larger(most, std::abs(at(s, column) - at(*s.sibling("york-connectivity"), column)));
    }
    return Measured::of(most);
  };
  return {
      gate("york-mass-matrix-quadratic/early",
           number_of("largest difference of the radii from those with connectivity at 0.05 s", apart_at_first, {16}),
           at_most(0.056),
           literature("York, p. 124: positions are similar at early times; a fiftieth of his picture, 2.8 m wide"))
          .beside({"york-connectivity"})
          .in(Tier::full),
      over("york-mass-matrix-quadratic", "later", "york-connectivity",
           "York, p. 124: the radius grows larger with the mass matrix than with connectivity"),
      over("york-mass-matrix", "expands-more", "york-mass-matrix-quadratic",
           "York, p. 123: linear shapes let it expand too much; quadratic ones do better")};
}

std::vector<CaseGate> booked_gates() {
  const auto pressure = [](double level) {
    return judged("booked", error_at, "pressure", level, at_most(0.3),
                  requirement("1 % of the pressure, below the 1.5 % without losses at h = 0.1: the reference has what "
                              "the ledger booked taken off"));
  };
  return {pressure(6), pressure(8).in(Tier::full)};
}

// Points in no order beside the same in order.
std::vector<CaseGate> found_gates() {
  const Because way = requirement("a fifth of a per cent of the radius with the order given, 0.03 cells at h = 0.1"),
                load = requirement("one per cent of what it is with the order given"),
                scatter = requirement("stresses as even as with the order given");
  const std::tuple<const char*, double, Because> all[] = {{"radius_0", 0.002, way},
                                                          {"radius_90", 0.002, way},
                                                          {"pressure", 0.01, load},
                                                          {"hoop_stress", 0.01, load},
                                                          {"hoop_scatter", 0.1, scatter}};
  std::vector<CaseGate> gates;
  for (const double level : {4.0, 8.0, 16.0}) {
    for (const auto& [measure, share, because] : all) {
      const std::string what = std::string(measure) + "-" + to_text(level);
      gates.push_back(gate("found/" + what,
                           over_that_of("default", measure, level, what + " over that with the order given"),
                           around(1, share), because)
                          .beside({"default"})
                          .in(level > 4 ? Tier::full : Tier::quick));
    }
  }
  return gates;
}

// Strains summed from rates, with tangents that need no connectivity, against what default is judged by at h = 0.1.
std::vector<CaseGate> modern_gates() {
  const std::string stamp = "2026-11-27 afc38c0",
                    relaxed =
                        "strains summed from the grid's rates relax as the bag folds and unfolds, and the longer it "
                        "breathes; the order of points found at the start (study found) is the cure";
  const auto at_16 = [](const char* measure, double most, const char* why) {
    return judged("modern", relative_error_at, measure, 16, at_most(most), requirement(why)).in(Tier::full);
  };
  const char* thousandth = "a thousandth at h = 0.1, as of the default scheme";
  const char* load = "1.5 % at h = 0.1, as of the default scheme";
  return {at_16("radius_0", 1e-3, thousandth).fails(relaxed, {0.018, 0.0243}, stamp),
          at_16("radius_90", 1e-3, thousandth).fails(relaxed, {0.018, 0.0243}, stamp),
          at_16("pressure", 0.015, load).fails(relaxed, {0.0256, 0.0345}, stamp),
          at_16("hoop_stress", 0.015, load),
          judged("modern", value_at, "escaped_points", 8, at_most(0), nothing_passes),
          judged("modern", value_at, "escaped_points", 16, at_most(0), nothing_passes).in(Tier::full)};
}

std::vector<CaseGate> gates() {
  return joined({gates_at("default", 16, Tier::full),
                 gates_at("default", 32, Tier::full),
                 gates_at("viscous", 16, Tier::quick),
                 identities_of("default", Tier::full),
                 identities_of("viscous", Tier::quick),
                 {closed_ledger_gate("default"), closed_ledger_gate("viscous"),
                  gate("default/pressure-order", fitted_order_of("pressure"), at_least(0.9),
                       theory("order 1 is what a boundary inside cells allows; 0.1 for coarse meshes"))
                      .in(Tier::full)},
                 york_gates(),
                 york_energy_gates(),
                 mass_matrix_gates(),
                 booked_gates(),
                 found_gates(),
                 modern_gates()});
}

Case membrane_expansion() {
  return {.name = "membrane-expansion",
          .kind = Kind::coupled,
          .keys = Expansion().keys(),
          .sets = {{"cells", 16.0}},
          .york1997 = {{"ppc", 64.0}, {"membrane.ppc", 9.1}},
          .york_step = step_over_cells(3.5e-5 * 32),  // 3.5e-5 s at h = 0.05 [York A.4.7]
          .problem = run_of<MembraneExpansionRun>,
          .studies = studies(),
          .gates = gates(),
          .levels = {4, 6, 8, 12, 16},
          .may_be_undefined = {
              {"hoop_scatter", "a membrane without stress, as one that has torn, has no mean to divide by"}}};
}
PLUMBLINE_CASE(membrane_expansion);

}  // namespace
}  // namespace plumbline::membrane_expansion
