#include "cases/harness/results/documents.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cases/harness/description/prose.hpp"
#include "cases/harness/description/schemes.hpp"
#include "cases/harness/judge/expected_failures.hpp"

namespace plumbline {
namespace {

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

template <class T>
Json optional_number(const std::optional<T>& value) {
  return value ? number(*value) : Json(nullptr);
}

Json numbers(const std::vector<double>& values) {
  Json list = Json::array();
  for (const double value : values) list.push_back(number(value));
  return list;
}

Json account(const Account& account, bool with_booked) {
  return {{"initial", number(account.initial())},
          {"final", number(account.store())},
          {"relative_drift", number(account.relative_drift(with_booked))},
          {"largest_residual", number(account.largest_residual())}};
}

Json flows(const Account& account) {
  Json list = Json::object();
  for (int f = 0; f < flow_count; ++f) {
    list[std::string(flow_names[static_cast<std::size_t>(f)])] = number(account.flow(static_cast<Flow>(f)));
  }
  return list;
}

Json stores(const EnergyStores& s) {
  return {{"kinetic", number(s.kinetic)}, {"internal", number(s.internal)}, {"elastic", number(s.elastic)}};
}

Json range(const Range& r) { return {{"low", optional_number(r.low)}, {"high", optional_number(r.high)}}; }

Json declared_gate(const Case& entry, const StudyPlan& plan, const CaseGate& g) {
  Json gate{{"id", g.gate.id},
            {"scheme", plan.scheme},
            {"study", g.study},
            {"tier", g.tier == Tier::quick ? "quick" : "full"},
            {"quantity", g.gate.quantity},
            {"expected", range(g.gate.expected)},
            {"origin", name(g.gate.origin)},
            {"reason", g.gate.reason}};
  gate["cause"] = g.gate.expected_failure ? Json(g.gate.expected_failure->cause) : Json(nullptr);
  gate["failure_of"] = g.gate.expected_failure ? Json(name(failure_of(entry, plan, g.gate))) : Json(nullptr);
  return gate;
}

// The scheme that a result's name of it, "default+usl", is made from.
std::string chosen_scheme(const std::string& shown) { return shown.substr(0, shown.find('+')); }

// Those of a run; none of a case that is not registered.
Json run_choices(const RunResult& run) {
  const auto entry = std::find_if(cases().begin(), cases().end(),
                                  [&](const Case* c) { return c->name == run.case_name; });
  return entry == cases().end() ? Json::object() : choices(**entry, chosen_scheme(run.scheme), run.settings);
}

// Those that all levels of a study share, beside what it varies.
Json shared_choices(const StudyResult& study) {
  if (study.levels.empty()) return Json::object();
  const StudyLevel& first = study.levels.front();
  Settings settings = first.run.settings;
  if (study.plan.vary == Vary::dt) {
    const char* step = settings.is_set("dt") ? "dt" : "cfl";
    settings.set(step, settings.number(step) / first.value, study.entry->name);
  }
  Json shared = choices(*study.entry, study.plan.scheme, settings);
  if (study.plan.vary != Vary::dt) shared.erase(name(study.plan.vary));
  return shared;
}

}  // namespace

Json choices(const Case& entry, const std::string& scheme, const Settings& settings) {
  const std::vector<std::string> schemes = scheme_names();
  if (std::find(schemes.begin(), schemes.end(), scheme) == schemes.end()) return Json::object();  // another program's
  std::vector<Override> cells;
  if (settings.has("cells")) cells.emplace_back("cells", settings["cells"]);
  const Settings plain = entry.settings(scheme, cells);
  Json chosen = Json::object();
  for (const Key& key : settings.keys()) {
    if (key.value == plain[key.name]) continue;
    chosen[key.name] = std::holds_alternative<std::monostate>(key.value) ? Json("none") : to_json(key.value);
  }
  return chosen;
}

Json to_json(const Value& value) {
  if (const double* x = std::get_if<double>(&value)) {
    return *x == std::floor(*x) && std::abs(*x) < 1e15 ? Json(static_cast<long long>(*x)) : Json(*x);
  }
  if (const std::string* text = std::get_if<std::string>(&value)) return *text;
  return nullptr;
}

Json to_json(const Settings& settings) {
  Json object = Json::object();
  for (const Key& key : settings.keys()) object[key.name] = to_json(key.value);
  return object;
}

Json to_json(const Provenance& p) {
  return {{"version", p.version},
          {"git", p.git},
          {"dirty", p.dirty},
          {"fingerprint", p.fingerprint},
          {"compiler", p.compiler},
          {"flags", p.flags},
          {"cpu", p.cpu},
          {"instruction_set", p.instruction_set},
          {"threads", p.threads},
          {"fused", p.fused},
          {"libraries", p.libraries},
          {"command", p.command},
          {"started", p.started}};
}

Json to_json(const JudgedGate& g) {
  Json gate{{"id", g.gate.id},
            {"case", g.case_name},
            {"scheme", g.scheme},
            {"study", g.study},
            {"quantity", g.gate.quantity},
            {"expected", range(g.gate.expected)},
            {"origin", name(g.gate.origin)},
            {"reason", g.gate.reason},
            {"measured", optional_number(g.measured.value)}};
  gate["interval"] = g.measured.interval && std::isfinite(g.measured.interval->first) &&
                             std::isfinite(g.measured.interval->second)
                         ? Json{g.measured.interval->first, g.measured.interval->second}
                         : Json(nullptr);
  gate["margin"] = optional_number(g.judgement.margin);
  gate["verdict"] = name(g.judgement.verdict);
  gate["cause"] = g.gate.expected_failure ? Json(g.gate.expected_failure->cause) : Json(nullptr);
  gate["band"] = g.gate.expected_failure ? range(g.gate.expected_failure->band) : Json(nullptr);
  gate["failure_of"] = g.gate.expected_failure ? Json(name(failure_of(g))) : Json(nullptr);
  gate["note"] = g.judgement.note.empty() ? g.measured.note : g.judgement.note;
  gate["run_ids"] = g.run_ids;
  if (!g.explanation.empty()) gate["explanation"] = g.explanation;
  return gate;
}

Json to_json(const std::vector<JudgedGate>& gates) {
  Json list = Json::array();
  for (const JudgedGate& gate : gates) list.push_back(to_json(gate));
  return list;
}

Json to_json(const std::vector<NotApplicable>& all) {
  Json list = Json::array();
  for (const NotApplicable& one : all) {
    Json missing = Json::array();
    for (const Lack& lack : one.lacks) missing.push_back({{"trait", name(lack.trait)}, {"why", lack.text()}});
    list.push_back({{"what", one.what}, {"integrator", one.integrator}, {"missing", missing}});
  }
  return list;
}

Json to_json(const Ledger& ledger, int dim, bool axisymmetric) {
  Json all{{"mass", account(ledger.mass, false)}};
  for (const auto& [name, of] : ledger.accounts(dim, axisymmetric)) {
    if (of == &ledger.mass || of == &ledger.energy) continue;
    all[name] = account(*of, true);
    all[name]["flows"] = flows(*of);
  }
  Json energy = account(ledger.energy, false);
  energy["initial_stores"] = stores(ledger.initial_stores);
  energy["stores"] = stores(ledger.stores);
  energy["flows"] = flows(ledger.energy);
  energy["viscous"] = number(ledger.viscous);
  all["energy"] = energy;
  return all;
}

Json to_json(const std::vector<Measure>& measures) {
  Json all = Json::object();
  for (const Measure& m : measures) {
    all[m.name] = {{"error", number(m.error)},
                   {"relative_error", m.scale > m.reference_bound ? number(m.error / m.scale) : Json(nullptr)},
                   {"value", optional_number(m.value)},
                   {"reference", optional_number(m.reference)},
                   {"reference_bound", number(m.reference_bound)},
                   {"unit", m.unit}};
  }
  return all;
}

Json to_json(const OrderFit& fit) {
  return {{"order", number(fit.order)},
          {"order_low", number(fit.low)},
          {"order_high", number(fit.high)},
          {"constant", number(fit.constant)},
          {"asymptotic", fit.asymptotic},
          {"pairwise", numbers(fit.pairwise)},
          {"leave_one_out", numbers(fit.leave_one_out)},
          {"plateau", numbers(fit.plateau)},
          {"levels_used", fit.used},
          {"reason", fit.reason}};
}

Json run_document(const RunResult& run, const std::vector<JudgedGate>& gates, const Provenance& provenance) {
  const auto all = verdicts(gates);
  Json document{{"case", run.case_name},       {"scheme", run.scheme},          {"settings", to_json(run.settings)},
                {"choices", run_choices(run)}, {"verdict", name(overall(all))}, {"finished", run.finished}};
  if (run.stop) {
    const Stop& s = *run.stop;
    document["stop"] = {{"reason", s.reason}, {"step", s.step},   {"time", number(s.time)},
                        {"point", s.point},   {"field", s.field}, {"value", number(s.value)}};
  } else {
    document["stop"] = nullptr;
  }
  document["steps"] = run.steps;
  document["points"] = run.points;
  document["h"] = number(run.h);
  document["time"] = number(run.end_time);
  document["wall_s"] = number(run.wall_s);
  document["particle_steps_per_s"] = number(run.particle_steps_per_s());
  document["measures"] = to_json(run.measures);
  document["ledger"] = to_json(run.ledger, run.dim, run.axisymmetric);
  document["gates"] = to_json(gates);
  document["file"] = run.file;
  document["provenance"] = to_json(provenance);
  return document;
}

Json study_document(const StudyResult& study, const std::vector<JudgedGate>& gates, const Provenance& provenance) {
  Json levels = Json::array(), fits = Json::object();
  for (const StudyLevel& at : study.levels) {
    Json level = run_document(at.run, {}, provenance);
    level["h"] = number(at.h);
    level["value"] = number(at.value);
    levels.push_back(std::move(level));
  }
  for (const auto& [measure, fit] : study.fits) fits[measure] = to_json(fit);
  const Settings shared = study.levels.empty() ? study.entry->settings(study.plan.scheme, study.plan.overrides)
                                               : study.levels.front().run.settings;
  return {{"scheme", study.scheme},      {"vary", name(study.plan.vary)},
          {"settings", to_json(shared)}, {"choices", shared_choices(study)},
          {"id", study.plan.id},         {"title", study.plan.title},
          {"why", study.plan.why},       {"levels", std::move(levels)},
          {"measures", std::move(fits)}, {"gates", to_json(gates)}};
}

Json counts_document(const std::vector<JudgedGate>& gates) {
  const Counts counts = tally(verdicts(gates));
  Json all = Json::object();
  for (const Verdict verdict : all_verdicts) all[std::string(name(verdict))] = counts[verdict];
  return all;
}

Json catalog_entry(const Case& entry) {
  const Statement s = entry.statement();
  Json parameters = Json::array(), gates = Json::array(), studies = Json::array();
  const Settings settings = entry.settings("default", {});
  for (const Key& key : settings.keys()) {
    parameters.push_back({{"key", key.name},
                          {"numerical", is_numerical(entry, key.name)},
                          {"value", to_json(key.value)},
                          {"default", to_json(key.value)},
                          {"unit", key.unit},
                          {"low", number(key.low)},
                          {"high", number(key.high)},
                          {"allowed", key.allowed()},
                          {"description", key.description}});
  }
  for (const StudyPlan& plan : entry.studies) {
    studies.push_back({{"id", plan.id},
                       {"title", plan.title},
                       {"why", plan.why},
                       {"scheme", plan.scheme},
                       {"vary", name(plan.vary)},
                       {"values", numbers(plan.values)}});
    for (const CaseGate& gate : entry.gates) {
      if (gate.study == plan.id) gates.push_back(declared_gate(entry, plan, gate));
    }
  }
  Json orders = Json::object();
  for (const auto& [measure, order, why] : s.theory_orders) orders[measure] = {{"order", order}, {"why", why}};
  Json document{{"name", s.name},
                {"title", s.title},
                {"source", s.source},
                {"claim", s.claim},
                {"physics", s.physics},
                {"equations", s.equations},
                {"sketch", s.sketch},
                {"cells_along", s.cells_along.empty() ? Json() : Json(s.cells_along)},
                {"parameters", parameters},
                {"reference", {{"name", s.reference_name}, {"text", s.reference_text}, {"bound", s.reference_bound}}},
                {"theory_order", orders},
                {"studies", studies},
                {"known_limits", s.known_limits},
                {"gates", gates},
                {"regenerate", "plumbline verify " + s.name + " --tier quick"}};
  if (const auto undefined = entry.may_be_undefined; !undefined.empty()) document["may_be_undefined"] = undefined;
  return document;
}

Json error_document(const UsageError& error) {
  return {{"error",
           {{"key", error.key},
            {"value", error.value},
            {"allowed", error.allowed},
            {"nearest", error.nearest},
            {"message", error.what()}}}};
}

Json error_document(const std::string& key, const std::string& message) {
  return {{"error",
           {{"key", key}, {"value", nullptr}, {"allowed", nullptr}, {"nearest", Json::array()}, {"message", message}}}};
}

std::vector<Verdict> verdicts(const std::vector<JudgedGate>& gates) {
  std::vector<Verdict> all;
  for (const JudgedGate& gate : gates) all.push_back(gate.judgement.verdict);
  return all;
}

}  // namespace plumbline
