#include "cases/harness/description/case.hpp"

#include <algorithm>
#include <utility>

#include "cases/harness/description/auto_courant.hpp"
#include "cases/harness/description/prose.hpp"
#include "cases/harness/files/errors.hpp"
#include "kernel/integrator_traits.hpp"
#include "kernel/shapes/shape.hpp"
#include "kernel/splitting.hpp"
#include "kernel/transfers/transfer.hpp"

namespace plumbline {
namespace {

// What makes cases, before main; the cases are made when first asked for.
using Makers = std::vector<std::pair<std::function<std::vector<Case>()>, std::string>>;
Makers& makers() {
  static Makers all;
  return all;
}

std::vector<Case> made_cases() {
  std::vector<Case> all;
  for (const auto& [make, file] : makers()) {
    for (Case& made : make()) {
      made.source_file = file;
      all.push_back(std::move(made));
    }
  }
  std::sort(all.begin(), all.end(), [](const Case& a, const Case& b) { return a.name < b.name; });
  return all;
}

}  // namespace

RegisterCases::RegisterCases(std::vector<Case> (*make)(), const char* file) { makers().emplace_back(make, file); }
RegisterCases::RegisterCases(Case (*make)(), const char* file) {
  makers().emplace_back([make] { return std::vector<Case>{make()}; }, file);
}

const std::vector<const Case*>& cases() {
  static const std::vector<Case> made = made_cases();
  static const std::vector<const Case*> all = [] {
    std::vector<const Case*> pointers;
    for (const Case& entry : made) pointers.push_back(&entry);
    return pointers;
  }();
  return all;
}

Case trial_case(std::string name, std::vector<Trial> trials, std::vector<CaseGate> gates) {
  Case made{.name = std::move(name), .gates = std::move(gates), .levels = {trial_level}};
  Key key{.name = "trial", .value = trials.front().name, .description = "what is looked at"};
  for (const Trial& trial : trials) {
    key.choices.push_back(trial.name);
    made.studies.push_back(
        study(trial.name, trial.title, trial.why, {trial_level}).with({{"trial", trial.name}}).in(trial.tier));
  }
  made.keys = {std::move(key)};
  made.problem = [name = made.name](const Settings&) -> std::unique_ptr<Problem> {
    throw UsageError("case", name, "a case of runs", {}, name + " has trials beside any run, and no points");
  };
  made.trials = std::move(trials);
  return made;
}

const Trial& Case::trial(const Settings& settings) const {
  return *std::find_if(trials.begin(), trials.end(),
                       [&](const Trial& one) { return one.name == settings.text("trial"); });
}

std::function<Override(const Settings&)> step_over_cells(double dt) {
  return [dt](const Settings& settings) { return Override{"dt", dt / settings.number("cells")}; };
}

std::function<Override(const Settings&)> courant_number(double cfl) {
  return [cfl](const Settings&) { return Override{"cfl", cfl}; };
}

const Case& find_case(const std::string& name) {
  std::vector<std::string> names;
  for (const Case* entry : cases()) {
    if (entry->name == name) return *entry;
    names.push_back(entry->name);
  }
  throw unknown_name("case", name, names);
}

namespace {

UsageError cannot_work(const std::string& key, const Settings& s, const std::string& allowed, const std::string& with,
                       const std::string& why) {
  const std::string value = to_text(s[key]);
  return UsageError(key, value, allowed, {}, key + "=" + value + " cannot work with " + with + ": " + why);
}

// Choices of coupled scenes that follow from each other, or exclude each other.
void settle_membranes(Settings& s, const std::string& owner) {
  if (!s.has("membrane.strain")) return;
  const bool ordered = s.text("normals") == "connectivity";
  if (!s.is_set("membrane.strain")) s.set("membrane.strain", ordered ? "segments" : "accumulated", owner);
  if (!ordered && s.text("membrane.strain") == "segments") {
    throw cannot_work("normals", s, "connectivity with membrane.strain=segments", "membrane.strain=segments",
                      "segments are the connectivity of points; accumulated strain needs none");
  }
  const IntegratorEntry* integrator = find_integrator(s.text("integrator"));
  if (s.text("membrane.loss") == "gas" && integrator &&
      traits_of(*integrator).offers.count(Trait::returned_loss) == 0) {
    throw MissingTraits("membrane.loss", "gas", "booked with integrator=" + integrator->name,
                        "integrator=" + integrator->name,
                        {{Trait::returned_loss, "membrane.loss=gas", "integrator " + integrator->name}});
  }
  const std::string& shape = s.text("shape");
  if (s.number("membrane.relaxation") > 0 && transfer_of(s.text("transfer"), 1).affine &&
      !shape_offers(shape, Trait::constant_inertia)) {
    throw cannot_work("membrane.relaxation", s, "0 with shape=" + shape + ", transfer=apic",
                      "shape=" + shape + ", transfer=apic", "moving points would change their affine inertia");
  }
}

void refuse_pressure_at_nodes(const Settings& settings) {
  const std::string& shape = settings.text("shape");
  if (!settings.has("pressure_at") || settings.text("pressure_at") != "nodes" || shape_named(shape).flows) return;
  throw UsageError("pressure_at", "nodes", "points with shape=" + shape, {},
                   "pressure_at=nodes cannot work with shape=" + shape +
                       ": the integrals of its kernels, by which points would move, are not known");
}

// cfl=auto becomes the number that it stands for; a fixed step has no use for it.
void settle_step(const Case& entry, Settings& settings) {
  if (!std::holds_alternative<std::string>(settings["cfl"])) return;
  settings.set("cfl", 0.5, entry.name);
  if (settings.is_set("dt")) return;
  settings.set("cfl", safe_courant_number(entry.problem(settings)->unprepared(), settings), entry.name);
}

}  // namespace

Statement Case::statement() const { return statement_of(written_prose(name), written_sketch(name)); }

Settings Case::settings(const std::string& scheme, const std::vector<Override>& overrides,
                        const std::vector<std::string>& typed) const {
  const auto known = scheme_names();
  if (std::find(known.begin(), known.end(), scheme) == known.end()) throw unknown_name("scheme", scheme, known);
  std::vector<Key> all = trials.empty() ? kind_keys(kind) : std::vector<Key>{};
  all.insert(all.end(), keys.begin(), keys.end());
  Settings settings(std::move(all));
  const auto set_all = [&](const std::vector<Override>& choices) {
    for (const auto& [key, value] : choices) settings.set(key, value, name);
  };
  if (trials.empty()) set_all(scheme_choices(scheme, kind));
  set_all(sets);
  if (scheme == "york1997") set_all(york1997);
  set_all(overrides);
  for (const std::string& assignment : typed) settings.set_text(assignment, name);
  if (!trials.empty()) return settings;
  settle_membranes(settings, name);
  if (scheme == "york1997" && york_step && !settings.is_set("dt") && !settings.is_set("cfl"))
    set_all({york_step(settings)});
  if (!settings.is_set("cfl") && !settings.is_set("dt")) {
    throw UsageError("cfl", "none", "(0, inf)", {"cfl", "dt"}, "neither cfl nor dt is set: set one of them");
  }
  if (const IntegratorEntry* entry = find_integrator(settings.text("integrator"))) refuse_lacks(*entry, settings);
  if (settings.has("split") && settings.number("split") > 0) {
    constexpr double least = 0.1;  // of a cell: points that are split until they are smaller are without end
    if (settings.number("split") < least) {
      throw UsageError("split", to_text(settings["split"]), "0, or at least 0.1", {},
                       "split = " + to_text(settings["split"]) + " is not allowed: 0, or at least 0.1");
    }
    const std::string &shape = settings.text("shape"), &transfer = settings.text("transfer");
    if (const std::string why = splitting_refusal(shape, transfer); !why.empty()) {
      throw UsageError("split", to_text(settings["split"]), "0 with shape=" + shape + ", transfer=" + transfer, {},
                       "split > 0 cannot work with shape=" + shape + ", transfer=" + transfer + ": " + why);
    }
  }
  refuse_pressure_at_nodes(settings);
  settle_step(*this, settings);
  return settings;
}

}  // namespace plumbline
