// How final states are judged: a gas of two points on a line that ought to end up with the speed of 4 m/s.
#include "cases/harness/exchange/score.hpp"

#include <cmath>
#include <memory>

#include "cases/catalog/estimators/answers.hpp"
#include "cases/catalog/estimators/exchange/handed_file.hpp"
#include "cases/harness/exchange/exchange.hpp"
#include "kernel/materials/ideal_gas.hpp"

namespace plumbline {
namespace {

constexpr double wanted_speed = 4, scored_end = 2;  // m/s, s
constexpr double scored_energy = 25;                // J/kg at the start

// By meshes: far from the end, near it, and beyond it to the other side.
double speed_at_start(int mesh) { return mesh == 20 ? 1 : mesh == 40 ? 3 : -8; }

class ScoredGas final : public Problem, public JudgedAtEnd {
 public:
  explicit ScoredGas(const Settings& settings) : mesh_(settings.integer("cells")) {}
  double end_time() const override { return scored_end; }
  Profile profile(const Simulation&) const override { return {}; }

  Scene scene() const override {
    Scene all;
    all.grid.h = 4.0 / mesh_;
    all.grid.cells = {mesh_, 1, 1};
    Body gas = make_body("gas", std::make_shared<IdealGas>(), 2, 1);
    for (int p = 0; p < 2; ++p) {
      gas.points(column::position)[p] = 1 + 2 * p;
      gas.points(column::velocity)[p] = speed_at_start(mesh_);
      gas.points(column::mass)[p] = gas.points(column::volume)[p] = gas.points(column::density)[p] = 1;
      gas.points(column::energy)[p] = scored_energy;
    }
    all.bodies.push_back(std::move(gas));
    return all;
  }

  std::vector<Measure> measures(const Simulation& simulation) const override {
    const Columns& points = simulation.scene().bodies[0].points;
    std::vector<FieldSample> speeds, none;
    double volume = 0;
    for (int p = 0; p < points.points(); ++p) {
      const double v = points(column::volume)[p], x = points(column::position)[p];
      speeds.push_back({v, x, points(column::velocity)[p], wanted_speed, 0});
      none.push_back({v, x, points(column::velocity)[p], 0, 0});
      volume += v / 4;
    }
    std::vector<Measure> all = field_norms("speed", "m/s", speeds);
    for (Measure& norm : field_norms("stillness", "m/s", none)) all.push_back(std::move(norm));
    all.push_back(share_measure("coverage", volume, 1));
    all.push_back(scalar_measure("seen", 1, 1, 0, "1"));
    return all;
  }
  std::vector<std::string> seen_on_the_way() const override { return {"seen"}; }

 private:
  int mesh_;
};

Case scored_case() {
  Case made = find_case("sod");
  made.problem = run_of<ScoredGas>;
  made.comparators = {};
  made.studies = {study("main", "of all meshes", "none", {20}), study("other", "of others", "none", {20})};
  const Because wanted = requirement("it is wanted"), known = literature("it is known");
  made.gates = {gate("main/error", error_at("speed.L1", 20), at_most(1), known),
                gate("main/missing", error_at("speed.L1", 30), at_most(1), known),
                gate("main/order", fitted_order_of("speed.L1"), at_least(1.5), wanted),
                gate("main/order-known", fitted_order_of("speed.L1"), at_least(1.5), known),
                gate("main/low-order", fitted_order_of("speed.L1"), at_least(0.2), wanted),
                gate("main/wanted", error_at("speed.L1", 20), between(0.5, 1), wanted),
                gate("main/ledger", energy_drift(), at_most(1), known),
                gate("main/red", error_at("speed.L1", 20), at_most(0.1), known).fails("it is so", {0.5, 1}, "today"),
                gate("main/beside", error_at("speed.L1", 20), at_most(1), known).beside({"other"}),
                recorded("main/recorded", error_at("speed.L1", 20), 0.75, 0.1, "today", "it was so"),
                gate("other/error", error_at("speed.L1", 20), at_most(1), known)};
  return made;
}

// What a program hands in: points of mass m with a speed that is off the wanted one.
struct Handing {
  int mesh;
  double off = 0, mass = 1, energy = 0, volume = 2;
  int steps = 30;
};

std::string write_scored(const ScratchFolder& folder, const Case& entry, const Handing& handing) {
  HandedFile file;
  const Settings settings = entry.settings("default", {{"cells", static_cast<double>(handing.mesh)}});
  file.texts["start"] = start_id(entry, settings);
  file.texts["problem"] = problem_id(entry, settings);
  file.texts["program"] = "mpm";
  file.numbers["cells"] = handing.mesh;
  file.numbers["time"] = scored_end;
  file.numbers["steps"] = handing.steps;
  const auto both = [](double value) { return HandedTable{0, {value, value}}; };
  file.bodies["gas"] = {{"position", {1, {1, 3}}},
                        {"velocity", {1, {wanted_speed + handing.off, wanted_speed - handing.off}}},
                        {"mass", both(handing.mass)},
                        {"volume", both(handing.volume)},
                        {"energy", both(handing.energy)}};
  const std::string path = folder / ("scored-" + std::to_string(handing.mesh) + ".h5");
  file.write(path);
  return path;
}

const JudgedGate* judged(const Score& score, const std::string& id) {
  for (const JudgedGate& gate : score.gates) {
    if (gate.gate.id == id) return &gate;
  }
  return nullptr;
}
double judged_value(const Score& score, const std::string& id) {
  const JudgedGate* const gate = judged(score, id);
  return gate ? gate->measured.value.value_or(NAN) : NAN;
}
bool not_judged(const Score& score, const std::string& id) {
  for (const NotJudged& one : score.not_judged) {
    if (one.id == id) return !judged(score, id);
  }
  return false;
}

void add_range(const Score& score, const std::string& id, double low, double high, KnownAnswers& all) {
  const JudgedGate* const gate = judged(score, id);
  const Range range = gate ? gate->gate.expected : Range{NAN, NAN};
  all.push_back({"range.low." + id, range.low.value_or(0), low});
  all.push_back({"range.high." + id, range.high.value_or(0), high});
}

// Half of what the start is off, over the size, but 30 % at least and 50 % at most: of the meshes 37.5 %, 30 % and 50 %.
void add_bounds(const Case& entry, KnownAnswers& all) {
  const ScratchFolder folder;
  const std::vector<Handing> handings{{20, 0.75}, {40, 0.9, 1, 0, 2, 0}, {80, 1}};
  const double exact[] = {0.75 / 1.5, 0.9 / 1.2, 1 / 2.0};
  std::vector<std::string> paths;
  for (std::size_t k = 0; k < handings.size(); ++k) {
    paths.push_back(write_scored(folder, entry, handings[k]));
    const Score one = score(entry, {paths.back()}, {});
    const std::string name = "bound." + std::to_string(handings[k].mesh);
    all.push_back({name, judged_value(one, "main/foreign-speed.L1"), exact[k]});
    all.push_back(yes(name + ".vanishes", not_judged(one, "main/foreign-stillness.L1")));
    all.push_back({name + ".coverage", judged_value(one, "main/foreign-coverage"), 1});
    all.push_back({name + ".of_level", static_cast<double>(gates_of_level(one, one.study.levels.at(0)).size()),
                   static_cast<double>(one.gates.size())});
  }
  const Score series = score(entry, {paths[2], paths[0], paths[1]}, {});
  all.push_back({"bound.all", judged_value(series, "main/foreign-speed.L1"), 0.75});
  all.push_back({"series.unknown_step", series.study.levels.at(1).run.dt, 0});
  all.push_back(yes("series.files", series.files == paths));
  for (std::size_t k = 0; k < 3; ++k) all.push_back({"series.level", series.study.levels.at(k).value, 20.0 * (1 << k)});
  all.push_back(yes("series.order", judged(series, "main/order") != nullptr));
  if (const JudgedGate* const order = judged(series, "main/order")) {
    all.push_back({"series.least_order", order->gate.expected.low.value_or(NAN), 0.4});
    all.push_back(yes("series.theory", order->gate.origin == Origin::theory));
  }
  const auto low_of = [&](const std::string& id) {
    const JudgedGate* const gate = judged(series, id);
    return gate ? gate->gate.expected.low.value_or(NAN) : NAN;
  };
  all.push_back({"series.known_order", low_of("main/order-known"), 1.5});
  all.push_back({"series.low_order", low_of("main/low-order"), 0.2});
  all.push_back({"series.wanted", low_of("main/wanted"), 0.5});
  // Of the mesh of 20 cells: gates of its error, which three of the declared ones read.
  all.push_back({"series.of_level", static_cast<double>(gates_of_level(series, series.study.levels[0]).size()), 2});
  all.push_back({"series.of_finest", static_cast<double>(gates_of_level(series, series.study.levels[2]).size()), 1});
}

void add_run_of_score(const Case& entry, KnownAnswers& all) {
  const ScratchFolder folder;
  const std::string path = write_scored(folder, entry, {20, 0.75, 1.25, 60, 1.5});
  const Score found = score(entry, {path}, {});
  const RunResult& run = found.study.levels.at(0).run;
  const auto number = [&](const std::string& name, double value, double exact) {
    all.push_back({"run." + name, value, exact});
  };
  number("dim", run.dim, 1);
  number("h", run.h, 0.2);
  number("end_time", run.end_time, scored_end);
  number("steps", static_cast<double>(run.steps), 30);
  number("dt", run.dt, scored_end / 30);
  number("points", static_cast<double>(run.points), 2);
  number("wall_s", run.wall_s, 1.5);
  number("finished", static_cast<double>(run.finished), 1);
  number("error", run.find("speed.L1") ? run.find("speed.L1")->error : NAN, 0.75);
  number("seen", static_cast<double>(run.find("seen") != nullptr), 0);
  all.push_back(yes("run.scheme", run.scheme == "foreign:mpm" && found.program == "mpm" && found.version == "7"));
  all.push_back(yes("run.declared", found.declared == "main"));
  // The start has 2 kg with 25 J/kg and 1 m/s; the end a quarter more, 60 J/kg and speeds of 4.75 m/s and 3.25 m/s.
  number("mass", judged_value(found, "main/foreign-mass"), 0.25);
  number("energy", judged_value(found, "main/foreign-energy"),
         1.25 * (120 + (4.75 * 4.75 + 3.25 * 3.25) / 2) / (2 * (25 + 0.5)));
  number("momentum", judged_value(found, "main/foreign-momentum"), (1.25 * 8 - 2) / (1.25 * 8));
  number("coverage", judged_value(found, "main/foreign-coverage"), 0.75);
  number("declared_error", judged_value(found, "main/error"), 0.75);
  add_range(found, "main/foreign-mass", 0, 1e-6, all);
  add_range(found, "main/foreign-energy", 0, 2, all);
  add_range(found, "main/foreign-momentum", 0, 1e-6, all);
  add_range(found, "main/foreign-coverage", 0.99, 1.01, all);
  add_range(found, "main/foreign-speed.L1", 0, 1, all);
  for (const char* id : {"missing", "order", "ledger", "red", "beside", "recorded"}) {
    all.push_back(yes(std::string("run.not_") + id, not_judged(found, std::string("main/") + id)));
  }
  all.push_back(yes("run.other", !judged(found, "other/error") && !not_judged(found, "other/error")));
}

}  // namespace

KnownAnswers score_answers() {
  KnownAnswers all;
  const Case entry = scored_case();
  add_bounds(entry, all);
  add_run_of_score(entry, all);
  return all;
}

}  // namespace plumbline
