// A gas that every direction compresses alike: its viscosity heats it and does nothing else.
#include <algorithm>
#include <memory>
#include <stdexcept>

#include "cases/catalog/gas/gas_case.hpp"
#include "cases/catalog/gas/radial.hpp"
#include "cases/harness/description/parameters.hpp"
#include "cases/harness/files/errors.hpp"
#include "reference/uniform_compression.hpp"

namespace plumbline::uniform_compression {
namespace {

// The gas ends at `length`, where it is free: what starts there runs inwards with the speed of sound, 1.2 to 1.3 m/s, and
// spreads by viscosity over sqrt(4/3 nu t) = 0.18 m. Judged is what stays beyond the reach of both, three such lengths.
constexpr double length = 2, judged = 0.3, latest = 0.5;  // m, m, s

struct Compression : Parameters {
  using Parameters::Parameters;
  int dimension = integer({.name = "dimension",
                           .value = 1.0,
                           .low = 1,
                           .high = 3,
                           .integer = true,
                           .description = "directions that are compressed"});
  std::string geometry = one_of("geometry", "plane", {"plane", "axisymmetric", "3d"},
                                "plane: a line of one direction, a plane of two; axisymmetric: rings of a cylinder (2) "
                                "or a sphere (3); 3d: space of three");
  double rate = number({.name = "rate",
                        .value = 0.5,
                        .unit = "1/s",
                        .low = -0.5,
                        .high = 0.5,
                        .description = "a of the stretch 1 - a t; below 0 the gas expands, along a line"});
  double viscosity = number(
      {.name = "viscosity", .value = 0.05, .unit = "Pa s", .low = 0, .high = 0.05, .description = "mu [York 4.1]"});
  double end_time = within("t_end", latest, "s", 0, latest, "end time");
};

// Of the settings, as the reference has it: an artificial viscosity that is limited sees nothing in a linear flow.
reference::UniformCompressionProblem problem_of(const Compression& given, const Settings& settings, double h) {
  const bool acts = settings.text("viscosity.closing") != "limited";
  const double linear = acts ? settings.number("viscosity.linear") : 0;
  const double quadratic = acts ? settings.number("viscosity.quadratic") : 0;
  if (linear > 0 && (quadratic > 0 || given.viscosity > 0)) {
    throw UsageError(
        "viscosity.linear", to_text(settings["viscosity.linear"]), "0", {},
        "viscosity.linear: no exact solution is known where viscosity or viscosity.quadratic acts beside it");
  }
  return {.dimension = given.dimension,
          .rate = given.rate,
          .viscosity = given.viscosity,
          .linear = linear * h,
          .quadratic = quadratic * h * h};
}

GasFlow compression_flow(const Settings& settings) {
  const Compression given(settings);
  GasFlow flow;
  const double h = cell_size(flow, settings);
  const auto exact = std::make_shared<const reference::UniformCompression>(problem_of(given, settings, h));
  if (given.dimension == 1) {
    if (given.geometry != "plane") throw unknown_name("geometry", given.geometry, {"plane"});
    flow.high[0] = length;
    flow.space[1] = std::max(0.0, -given.rate * given.end_time * length);
  } else {
    if (given.rate < 0)
      throw UsageError("rate", to_text(settings["rate"]), "at least 0", {}, "rate: no room to expand");
    set_geometry(flow, radial_geometry(given.dimension, given.geometry), length, settings);
  }
  flow.gamma = exact->problem().gamma;
  flow.viscosity = given.viscosity;
  flow.end_time = given.end_time;
  flow.judged = Interval{0, judged};
  flow.filled = false;
  flow.initial = [start = exact->instant(0)](double r) { return state_of(start.at(r)); };
  // One point after another is asked for at the same time, whose powers are found once.
  flow.exact = [exact, now = exact->instant(0), last = 0.0](double r, double t) mutable {
    if (t != last) now = exact->instant(t);
    last = t;
    return now.at(r);
  };
  flow.further = [exact](const std::vector<GasSample>& points, double time) {
    double mass = 0, energy = 0;
    for (const GasSample& p : points) {
      mass += p.volume * p.density;
      energy += p.volume * p.density * p.energy;
    }
    const reference::Bounded heat = exact->viscous_heat(time), rest = exact->isentropic_energy(time);
    return std::vector<Measure>{
        scalar_measure("heat", energy / mass - rest.value, heat.value, heat.bound + rest.bound, "J/kg")};
  };
  return flow;
}

struct Variant {
  std::string name, words;
  std::vector<Override> choices;
  double mesh = 20;  // cells a metre, at which heat is judged
};

const Variant expanding{"expanding", "expansion along a line", {{"rate", -0.5}}};

// At the end, where s = 3/4, cells hold whole numbers of points again, as densities of cells want it: 8 and 4.
const std::vector<Variant>& compressed() {
  static const std::vector<Variant> all{
      {"line", "along a line", {{"ppc", 6.0}}},
      {"plane", "a plane, both directions", {{"dimension", 2.0}, {"ppc", 3.0}}},
      {"rings", "a cylinder by rings", {{"dimension", 2.0}, {"geometry", "axisymmetric"}, {"ppc", 3.0}}, 40},
      {"sphere", "a sphere by rings", {{"dimension", 3.0}, {"geometry", "axisymmetric"}, {"ppc", 3.0}}},
  };
  return all;
}

// The coefficients give about a hundredth of the internal energy at this mesh.
const std::vector<Variant>& viscosities() {
  const auto choices = [](double physical, double linear, double quadratic, const char* closing) {
    return std::vector<Override>{{"viscosity", physical},
                                 {"viscosity.linear", linear},
                                 {"viscosity.quadratic", quadratic},
                                 {"viscosity.closing", closing}};
  };
  static const std::vector<Variant> all{
      {"none", "no viscosity", choices(0, 0, 0, "limited")},
      {"physical", "physical viscosity", choices(0.05, 0, 0, "limited")},
      {"linear", "linear artificial viscosity", choices(0, 1, 0, "divergence")},
      {"quadratic", "quadratic artificial viscosity", choices(0, 0, 8, "divergence")},
      {"limited", "linear artificial viscosity, limited", choices(0, 1, 0, "limited")},
  };
  return all;
}

// How points get their density, without viscosity. "grid" is the default, which the other studies run.
const std::vector<Variant>& densities_compared() {
  static const std::vector<Variant> all = [] {
    std::vector<Variant> made{{"cell", "density of cells", {{"density", "cell"}}},
                              {"quadratic-cell", "density of cells with quadratic shapes", {{"density", "quadratic"}}},
                              {"continuity", "density by continuity", {{"density", "continuity"}}}};
    const std::vector<Override>& none = viscosities().front().choices;
    for (Variant& way : made) way.choices.insert(way.choices.end(), none.begin(), none.end());
    return made;
  }();
  return all;
}

StudyPlan plan(const Variant& body, const Variant& how) {
  std::vector<Override> choices = body.choices;
  choices.insert(choices.end(), how.choices.begin(), how.choices.end());
  return study(body.name + "-" + how.name, body.words + ", " + how.words, "One mesh: the heat at it is judged.",
               {body.mesh})
      .with(choices);
}

std::vector<StudyPlan> studies() {
  const std::vector<Variant>& all = viscosities();
  std::vector<StudyPlan> plans{study("default", "default, no viscosity, along a line",
                                     "Nothing jumps: points and step are of second order.", {10, 14, 20, 28, 40})
                                   .with(all.front().choices)};
  for (const Variant& body : compressed()) {
    for (const Variant& viscosity : all) plans.push_back(plan(body, viscosity));
    if (body.name == "sphere") continue;  // its mesh is too coarse for them
    for (const Variant& density : densities_compared()) plans.push_back(plan(body, density));
  }
  for (std::size_t v = 0; v < 3; ++v) plans.push_back(plan(expanding, all[v]));
  return plans;
}

const Measure& heat_in(const StudyResult& study) {
  const Measure* heat = study.levels.empty() ? nullptr : study.levels.front().run.find("heat");
  if (!heat) throw std::runtime_error("study " + study.plan.id + " has no heat");
  return *heat;
}

// What viscosity has added to the heat of a run, in which the errors of the step are those of a run without any.
double added_heat(const StudyResult& study, const std::string& none) {
  return *heat_in(study).value - *heat_in(*study.sibling(none)).value;
}

CaseGate heat_gate(const std::string& body, const std::string& viscosity) {
  const std::string none = body + "-none", id = body + "-" + viscosity;
  return gate(id + "/heat",
              number_of(
                  "heat added by viscosity over the exact one",
                  [none](const StudyResult& s) { return Measured::of(added_heat(s, none) / *heat_in(s).reference); }),
              between(0.995, 1.005),
              requirement("a coefficient 2 % off moves it by 2 %, of which errors of the mesh may hide a quarter"))
      .beside({none});
}

// Where viscosity must do nothing. `acts`: a study in which the same coefficient does.
CaseGate no_heat_gate(const std::string& body, const std::string& viscosity, const std::string& acts, double most,
                      Because reason) {
  const std::string none = body + "-none", id = body + "-" + viscosity;
  const std::string other_none = acts.substr(0, acts.find('-')) + "-none";
  return gate(id + "/no-heat",
              number_of("heat added by viscosity over that of " + acts,
                        [=](const StudyResult& s) {
                          return Measured::of(added_heat(s, none) / added_heat(*s.sibling(acts), other_none));
                        }),
              between(-most, most), std::move(reason))
      .beside({none, acts, other_none});
}

CaseGate density_gate(const Variant& body, const std::string& how) {
  const std::string id = body.name + "-" + how;
  return gate(id + "/density",
              number_at("density.L1 over the density", "density.L1", body.mesh,
                        [](const RunResult&, const Measure& m) { return Measured::of(m.error / m.scale); }),
              at_most(0.005), requirement("a quarter of what a factor 2 % off would move"));
}

std::vector<CaseGate> gates() {
  const Because nothing = requirement("none, but for a quarter of what a coefficient 2 % off would move where it acts");
  const Because no_shape = theory(
      "nothing changes its shape: 2 mu e and 2/3 mu tr(e) cancel, and one of them 2 % off would give 9 % of what a "
      "cylinder's heat is, of which errors of the mesh may hide a quarter");
  std::vector<CaseGate> all = required_order("default", "energy.L1", 1.8, "2; 0.2 for the coarsest mesh");
  all.push_back(energy_gate("default"));
  for (const std::string body : {"line", "plane", "rings", "expanding"}) all.push_back(heat_gate(body, "physical"));
  for (const std::string body : {"line", "plane", "rings", "sphere"}) {
    all.push_back(heat_gate(body, "linear"));
    all.push_back(heat_gate(body, "quadratic"));
    all.push_back(no_heat_gate(body, "limited", body + "-linear", 0.005, nothing));
    all.push_back(energy_gate(body + "-linear"));
  }
  for (const Variant& body : compressed()) {
    all.push_back(density_gate(body, "none"));
    if (body.name == "sphere") continue;
    for (const Variant& density : densities_compared()) all.push_back(density_gate(body, density.name));
  }
  all.push_back(no_heat_gate("sphere", "physical", "plane-physical", 0.0225, no_shape));
  all.push_back(no_heat_gate("expanding", "linear", "line-linear", 0.005, nothing));
  return all;
}

Case uniform_compression() {
  return {.name = "uniform-compression",
          .kind = Kind::gas,
          .keys = Compression().keys(),
          .sets = {{"cells", 20.0}},
          .york1997 = {{"ppc", 3.0}, {"viscosity", 0.0}, {"viscosity.quadratic", 0.0}},
          .york_step = york_step,
          .problem = gas_run(compression_flow),
          .studies = studies(),
          .gates = gates(),
          .levels = {10, 14, 20, 28, 40}};
}
PLUMBLINE_CASE(uniform_compression);

}  // namespace
}  // namespace plumbline::uniform_compression
