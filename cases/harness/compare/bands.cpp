#include "cases/harness/compare/bands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "cases/harness/files/errors.hpp"
#include "cases/harness/files/input_file.hpp"
#include "cases/harness/files/json_text.hpp"
#include "cases/harness/judge/regressions.hpp"

namespace plumbline {
namespace {

Ensemble ensemble(const Json& json) {
  Ensemble made;
  made.case_name = json.at("case").get<std::string>();
  made.study = json.at("study").get<std::string>();
  made.id = json.at("id").get<std::string>();
  for (const Json& member : json.at("members")) {
    if (member.is_object()) {
      made.stopped.push_back({member.at("step").get<long>(), member.at("field").get<std::string>()});
    } else {
      made.values.push_back(member.get<double>());
    }
  }
  return made;
}

bool is_narrow(const Gate& gate, double low, double high) {
  if (is_order(gate)) return high - low <= widest_order_band * (1 + bound_slack);
  if (low * high <= 0) return low == high;
  return std::max(high / low, low / high) <= widest_band * (1 + bound_slack);
}

std::string beyond_ensemble(const ExpectedFailure& failure, const Ensemble& runs) {
  if (runs.values.size() + runs.stopped.size() < least_members)
    return fmt::format("its ensemble has {} runs, not {}", runs.values.size() + runs.stopped.size(), least_members);
  const Range shown = widened(runs);
  if (*failure.band.low < *shown.low || *failure.band.high > *shown.high)
    return fmt::format("its band {} reaches beyond what its ensemble shows, {}", range_words(failure.band),
                       range_words(shown));
  for (const Ensemble::Stopped& one : runs.stopped) {
    const auto& stops = failure.stops;
    if (!stops || one.field != stops->field || one.step < stops->step_low || one.step > stops->step_high)
      return fmt::format("a run of its ensemble stopped at step {} in {}, which it does not expect", one.step,
                         one.field);
  }
  return {};
}

}  // namespace

Range widened(const Ensemble& runs) {
  if (runs.values.empty()) return {};
  const auto [least, most] = std::minmax_element(runs.values.begin(), runs.values.end());
  const double half = (*most - *least) / 2;
  return {*least - half, *most + half};
}

std::vector<Ensemble> read_ensembles(const std::string& file) {
  try {
    std::vector<Ensemble> all;
    const Json document = parse_json(read_text_file(file));
    for (const Json& item : document.at("ensembles")) all.push_back(ensemble(item));
    return all;
  } catch (const Json::exception& error) {
    throw FileError(file, fmt::format("{}: not a file of ensembles: {}", file, fault_of(error)));
  }
}

std::string too_wide(const Gate& gate, const Ensemble* runs) {
  if (!gate.expected_failure) return {};
  const ExpectedFailure& failure = *gate.expected_failure;
  const auto [low, high] = std::pair{failure.band.low, failure.band.high};
  if (!low && !high) return {};
  if (!low || !high) return "its band has one end";
  if (runs) return beyond_ensemble(failure, *runs);
  if (is_narrow(gate, *low, *high)) return {};
  return fmt::format(
      "its band {} is wider than {}, and no ensemble of cases/ensembles.json shows that roundings move it",
      range_words(failure.band),
      is_order(gate) ? fmt::format("{} of an order", widest_order_band) : fmt::format("a factor {}", widest_band));
}

std::vector<Discrepancy> wide_bands(const std::vector<const Case*>& entries, const std::vector<Ensemble>& ensembles) {
  std::vector<Discrepancy> found;
  std::set<const Ensemble*> used;
  for (const Case* entry : entries) {
    for (const CaseGate& declared : entry->gates) {
      const LedgerLine::Key key{entry->name, declared.study, declared.gate.id};
      const auto runs = std::find_if(ensembles.begin(), ensembles.end(), [&](const Ensemble& e) {
        return key == LedgerLine::Key{e.case_name, e.study, e.id} && declared.gate.expected_failure;
      });
      const Ensemble* const of_gate = runs == ensembles.end() ? nullptr : &*runs;
      used.insert(of_gate);
      if (const std::string why = too_wide(declared.gate, of_gate); !why.empty())
        found.push_back({"wide", key, fmt::format("gate {} of {}: {}", declared.gate.id, entry->name, why)});
    }
  }
  for (const Ensemble& e : ensembles) {
    if (used.count(&e) == 0)
      found.push_back({"wide",
                       {e.case_name, e.study, e.id},
                       fmt::format("an ensemble of {}: no gate {} is expected to fail", e.case_name, e.id)});
  }
  return found;
}

}  // namespace plumbline
