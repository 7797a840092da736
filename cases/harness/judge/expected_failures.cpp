#include "cases/harness/judge/expected_failures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <set>
#include <sstream>

#include "kernel/scene.hpp"
#include "kernel/shapes/shape.hpp"
#include "kernel/time_integrator.hpp"
#include "kernel/transfers/transfer.hpp"

namespace plumbline {
namespace {

constexpr std::array<std::string_view, all_failures_of.size()> owner_names{"york1997", "other", "default"};
constexpr std::string_view york = "york";

bool begins_with_york(const std::string& text) { return text.rfind(york, 0) == 0; }

bool begins_with_york(const Value& value) {
  const auto* text = std::get_if<std::string>(&value);
  return text && begins_with_york(*text);
}

// Whether a key of a case is a choice of schemes, or its own of the method. Mesh, step and points per cell are none.
bool is_choice(const Case& entry, const std::string& key) {
  static const std::set<std::string> resolution{"cells", "dt", "cfl", "ppc", "membrane.ppc", "offset"};
  const auto is_it = [&](const Key& one) { return one.name == key; };
  const auto own = std::find_if(entry.keys.begin(), entry.keys.end(), is_it);
  if (own != entry.keys.end()) return own->method;
  const std::vector<Key> of_schemes = kind_keys(entry.kind);
  return resolution.count(key) == 0 && std::any_of(of_schemes.begin(), of_schemes.end(), is_it);
}

bool changes_the_scheme(const Case& entry, const StudyPlan& plan) {
  const Settings own = entry.settings(plan.scheme, {});
  return std::any_of(plan.overrides.begin(), plan.overrides.end(),
                     [&](const Override& one) { return is_choice(entry, one.first) && own[one.first] != one.second; });
}

// The words of "plane/york1997-rate".
std::set<std::string> words_of(std::string id) {
  std::replace_if(
      id.begin(), id.end(), [](char c) { return c == '/' || c == '-'; }, ' ');
  std::istringstream stream(id);
  return {std::istream_iterator<std::string>(stream), {}};
}

// Whether the plan's trial has choices of its own.
bool looks_at_another(const Case& entry, const StudyPlan& plan) {
  return std::any_of(entry.trials.begin(), entry.trials.end(),
                     [&](const Trial& trial) { return trial.name == plan.id && !trial.choices.empty(); });
}

FailureOf named_by(const std::string& id) {
  const std::set<std::string> named = words_of(id);
  if (named.count("york1997") > 0) return FailureOf::york;
  const auto has = [&](const auto& entries) {
    return std::any_of(entries.begin(), entries.end(), [&](const auto& e) { return named.count(e.name) > 0; });
  };
  return has(shapes()) || has(transfers()) || has(integrators()) ? FailureOf::other : FailureOf::standard;
}

}  // namespace

std::string_view name(FailureOf whose) { return owner_names[static_cast<std::size_t>(whose)]; }

FailureOf failure_of(const Case& entry, const StudyPlan& plan, const Gate& gate) {
  const bool his_method = std::any_of(plan.overrides.begin(), plan.overrides.end(), [&](const Override& one) {
    return is_choice(entry, one.first) && begins_with_york(one.second);
  });
  if (begins_with_york(plan.scheme) || his_method) return FailureOf::york;
  if (gate.origin == Origin::literature && entry.statement().source.rfind("York", 0) == 0) return FailureOf::york;
  if (!entry.trials.empty()) return looks_at_another(entry, plan) ? FailureOf::other : named_by(gate.id);
  return plan.scheme == "default" && !changes_the_scheme(entry, plan) ? FailureOf::standard : FailureOf::other;
}

FailureOf failure_of(const JudgedGate& judged) {
  for (const Case* entry : cases()) {
    if (entry->name != judged.case_name) continue;
    for (const StudyPlan& plan : entry->studies) {
      if (plan.id == judged.study) return failure_of(*entry, plan, judged.gate);
    }
  }
  for (const FailureOf whose : {FailureOf::york, FailureOf::standard}) {
    if (judged.scheme == name(whose)) return whose;
  }
  return FailureOf::other;
}

int FailureCounts::total() const { return std::accumulate(by_owner.begin(), by_owner.end(), 0); }

FailureCounts expected_failures(const std::vector<JudgedGate>& gates) {
  FailureCounts counts;
  for (const JudgedGate& gate : gates) {
    if (gate.judgement.verdict == Verdict::xfail) ++counts.by_owner[static_cast<std::size_t>(failure_of(gate))];
  }
  return counts;
}

std::string words(const FailureCounts& counts) {
  if (counts.total() == 0) return {};
  return fmt::format("{} expected: {} York's own, {} of other schemes, {} of the default", counts.total(),
                     counts[FailureOf::york], counts[FailureOf::other], counts[FailureOf::standard]);
}

}  // namespace plumbline
