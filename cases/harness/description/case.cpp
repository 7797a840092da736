#include "cases/harness/description/case.hpp"

#include <algorithm>
#include <array>
#include <map>

#include "cases/harness/description/auto_courant.hpp"
#include "cases/harness/description/prose.hpp"
#include "cases/harness/files/errors.hpp"
#include "kernel/integrator_traits.hpp"
#include "kernel/splitting.hpp"
#include "kernel/transfers/transfers.hpp"

namespace plumbline {
namespace {

std::vector<const Case*>& registered() {
  static std::vector<const Case*> all;
  return all;
}

std::map<const Case*, std::string>& source_files() {
  static std::map<const Case*, std::string> all;
  return all;
}

constexpr std::array vary_names{"cells", "dt", "ppc", "offset"};

}  // namespace

std::string name(Vary vary) { return vary_names[static_cast<std::size_t>(vary)]; }

Vary vary_from(const std::string& text) {
  for (std::size_t k = 0; k < vary_names.size(); ++k) {
    if (text == vary_names[k]) return static_cast<Vary>(k);
  }
  throw unknown_name("--vary", text, {vary_names.begin(), vary_names.end()});
}

RegisterCase::RegisterCase(const Case* entry, const char* file) {
  source_files()[entry] = file;
  auto& all = registered();
  const auto place = std::upper_bound(all.begin(), all.end(), entry,
                                      [](const Case* a, const Case* b) { return a->name() < b->name(); });
  all.insert(place, entry);
}

const std::vector<const Case*>& cases() { return registered(); }

const std::string& source_file(const Case& entry) { return source_files().at(&entry); }

const Case& find_case(const std::string& name) {
  std::vector<std::string> names;
  for (const Case* entry : cases()) {
    if (entry->name() == name) return *entry;
    names.push_back(entry->name());
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
  if (s.number("membrane.relaxation") > 0 && transfer_choice(s.text("transfer"), 1).affine &&
      !shape_offers(shape, Trait::constant_inertia)) {
    throw cannot_work("membrane.relaxation", s, "0 with shape=" + shape + ", transfer=apic",
                      "shape=" + shape + ", transfer=apic", "moving points would change their affine inertia");
  }
}

// cfl=auto becomes the number that it stands for; a fixed step has no use for it.
void settle_step(const Case& entry, Settings& settings) {
  if (!std::holds_alternative<std::string>(settings["cfl"])) return;
  settings.set("cfl", 0.5, entry.name());
  if (settings.is_set("dt")) return;
  settings.set("cfl", safe_courant_number(entry.problem(settings)->scene(), settings), entry.name());
}

}  // namespace

Statement Case::statement() const { return statement_of(written_prose(name()), written_sketch(name())); }

Settings Case::settings(const std::string& scheme, const std::vector<Override>& overrides,
                        const std::vector<std::string>& typed) const {
  const auto known = scheme_names();
  if (std::find(known.begin(), known.end(), scheme) == known.end()) throw unknown_name("scheme", scheme, known);
  std::vector<Key> all = kind_keys(kind());
  for (Key& key : keys()) all.push_back(std::move(key));
  Settings settings(std::move(all));
  for (const auto& [key, value] : scheme_choices(scheme, kind())) settings.set(key, value, name());
  for (const auto& [key, value] : points_and_end(scheme)) settings.set(key, value, name());
  for (const auto& [key, value] : overrides) settings.set(key, value, name());
  for (const std::string& assignment : typed) settings.set_text(assignment, name());
  settle_membranes(settings, name());
  derive(settings, scheme);
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
  settle_step(*this, settings);
  return settings;
}

}  // namespace plumbline
