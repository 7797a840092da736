#include "cases/harness/compare/recording.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "cases/harness/files/errors.hpp"
#include "cases/harness/files/input_file.hpp"
#include "cases/harness/files/json_text.hpp"
#include "cases/harness/files/text_file.hpp"
#include "cases/harness/judge/gates.hpp"

namespace plumbline {
namespace {

std::string words(const RecordedValue& value) {
  return fmt::format("{} of {}, {} tier", value.id, value.case_name, value.tier);
}

Range range_of(const Json& json) {
  const auto end = [&](const char* key) {
    return json.at(key).is_null() ? std::nullopt : std::optional<double>(json.at(key).get<double>());
  };
  return {end("low"), end("high")};
}

// A judged gate of the document as a value to be recorded; absent where it fails as expected or has no number.
std::optional<RecordedValue> measured(const Json& gate, const std::string& tier, const std::string& since) {
  RecordedValue value;
  value.case_name = gate.at("case").get<std::string>();
  value.study = gate.at("study").get<std::string>();
  value.id = gate.at("id").get<std::string>();
  value.tier = tier;
  value.since = since;
  const std::string verdict = gate.at("verdict").get<std::string>();
  const bool good = verdict == "PASS" || verdict == "INCONCLUSIVE";
  if (!good || value.id.ends_with("/regression") || gate.at("measured").is_null()) return {};
  value.measured = gate.at("measured").get<double>();
  if (verdict == "INCONCLUSIVE") return value;
  Gate judged;
  judged.quantity = gate.at("quantity").get<std::string>();
  judged.order = !gate.at("interval").is_null();
  const Origin origin = origin_from(gate.at("origin").get<std::string>()).value_or(Origin::requirement);
  value.within = recorded_range(range_of(gate.at("expected")), origin, is_order(judged), value.measured);
  return value;
}

// "2026-11-23 5825b24", of the program that measured.
std::string stamp_of(const Json& verification, const std::string& file) {
  const Json& made = verification.at("provenance");
  const std::string git = made.at("git").get<std::string>();
  if (git.size() < 7 || git.find_first_not_of("0123456789abcdef") != std::string::npos)
    throw FileError(file, fmt::format("{}: its program knows no commit (git = {}); build it in a checkout", file, git));
  return made.at("started").get<std::string>().substr(0, 10) + " " + git.substr(0, 7);
}

RecordedValue merged(const RecordedValue& was, RecordedValue now, const std::string& why, std::string& unexplained) {
  if (!was.within) {
    if (!now.within) return was;
    return now;
  }
  if (was.within->contains(now.measured)) {
    RecordedValue kept = was;
    if (!now.within) kept.within.reset();  // the gate's own bound has become close enough
    return kept;
  }
  if (why.empty()) {
    unexplained += fmt::format("\n  {}: {:.6g} became {:.6g}, outside {}", words(now), was.measured, now.measured,
                               range_words(*was.within));
  }
  now.moved = RecordedValue::Moved{was.measured, now.since.substr(0, 10), why};
  return now;
}

Json to_json(const RecordedValue& value) {
  Json json{{"case", value.case_name}, {"study", value.study}, {"id", value.id}, {"tier", value.tier}};
  json["measured"] = value.measured;
  if (value.within) {
    json["low"] = *value.within->low;
    json["high"] = *value.within->high;
  }
  json["since"] = value.since;
  if (value.moved)
    json["moved"] = {{"from", value.moved->from}, {"date", value.moved->date}, {"why", value.moved->why}};
  return json;
}

}  // namespace

Json read_verification(const std::string& file) {
  if (!is_there(file)) throw FileError(file, file + ": cannot be opened; `plumbline verify --json` writes it");
  try {
    return parse_json(read_text_file(file));
  } catch (const Json::exception& error) {
    throw FileError(file, fmt::format("{}: not a document of verify: {}", file, fault_of(error)));
  }
}

std::vector<RecordedValue> recorded_from(const std::vector<RecordedValue>& before, const Json& verification,
                                         const std::string& file, const std::string& why) {
  std::map<RecordedValue::Key, RecordedValue> values;
  for (const RecordedValue& value : before) values[value.key()] = value;
  std::string unexplained;
  try {
    if (!verification.at("settings").empty())
      throw UsageError("--record", file, "results of `plumbline verify` without --set", {},
                       file + ": made with --set: recorded values are those of the declared studies");
    const std::string tier = verification.at("tier").get<std::string>(), since = stamp_of(verification, file);
    const bool all = verification.value("chosen_gates", Json::array()).empty();  // otherwise others were not asked for
    std::set<std::pair<std::string, std::string>> judged;
    std::map<RecordedValue::Key, RecordedValue> found;
    std::set<std::string> known;
    for (const Case* entry : cases()) known.insert(entry->name);
    for (const Json& gate : verification.at("gates")) {
      if (known.count(gate.at("case").get<std::string>()) == 0) continue;  // an integrator's own
      judged.emplace(gate.at("case").get<std::string>(), gate.at("study").get<std::string>());
      if (auto value = measured(gate, tier, since)) found[value->key()] = *value;
    }
    for (auto it = values.begin(); it != values.end();) {
      const RecordedValue& value = it->second;
      const bool gone = all && value.tier == tier && judged.count({value.case_name, value.study}) > 0 &&
                        found.count(it->first) == 0;
      it = gone ? values.erase(it) : std::next(it);
    }
    for (const auto& [key, value] : found) {
      const auto was = values.find(key);
      values[key] = was == values.end() ? value : merged(was->second, value, why, unexplained);
    }
  } catch (const Json::exception& error) {
    throw FileError(file, fmt::format("{}: not a document of verify: {}", file, fault_of(error)));
  }
  if (!unexplained.empty()) {
    throw UsageError("--why", "", "a sentence", {},
                     "these values left the range recorded of them; say why with --why:" + unexplained);
  }
  std::vector<RecordedValue> all;
  for (auto& [key, value] : values) all.push_back(std::move(value));
  return all;
}

std::vector<Discrepancy> unrecorded(const std::vector<const Case*>& entries, const std::vector<RecordedValue>& values) {
  std::set<RecordedValue::Key> recorded;
  for (const RecordedValue& value : values) recorded.insert(value.key());
  std::vector<Discrepancy> found;
  std::set<std::pair<std::string, std::string>> studies;
  for (const Case* entry : entries) {
    const std::string name = entry->name;
    const std::string call = fmt::format(
        "Record it: `plumbline verify {} --json judged.json`, then `plumbline tolerances cases/tolerances.json "
        "--record "
        "judged.json`",
        name);
    const auto demand = [&](const std::string& study, const std::string& id) {
      if (recorded.count({name, study, id, "quick"}) == 0)
        found.push_back({"unrecorded",
                         {name, study, id},
                         fmt::format("no value is recorded of gate {} of {}, study {}. {}", id, name, study, call)});
    };
    std::set<std::string> failing;
    for (const CaseGate& gate : entry->gates) {
      if (gate.gate.expected_failure) failing.insert(gate.gate.id);
      if (gate.tier == Tier::quick && !gate.gate.expected_failure) demand(gate.study, gate.gate.id);
    }
    for (const StudyPlan& plan : entry->studies) {
      studies.emplace(name, plan.id);
      if (plan.tier != Tier::quick) continue;
      for (const CaseGate& generic : generic_gates(plan.id, entry->trials.empty() ? 1 : 0)) {
        if (failing.count(generic.gate.id) == 0) demand(plan.id, generic.gate.id);
      }
    }
  }
  for (const RecordedValue& value : values) {
    if (value.study.rfind("integrator/", 0) == 0 || studies.count({value.case_name, value.study}) > 0) continue;
    found.push_back(
        {"unrecorded",
         {value.case_name, value.study, value.id},
         fmt::format("a value is recorded of {}, whose study is declared no more: take its line away", words(value))});
  }
  return found;
}

std::vector<RecordedValue> read_regressions(const std::string& file) {
  return parse_regressions(read_text_file(file), file);
}

void write_regressions(const std::string& file, const std::vector<RecordedValue>& values) {
  std::string text = "{\"format\": 1, \"recorded\": [\n";
  for (std::size_t k = 0; k < values.size(); ++k)
    text += "  " + json_text(to_json(values[k])) + (k + 1 < values.size() ? ",\n" : "\n");
  write_text_file(file, text + "]}\n");
}

}  // namespace plumbline
