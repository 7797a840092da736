#include "cases/harness/compare/tolerances.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>

#include "cases/harness/description/settings.hpp"
#include "cases/harness/files/errors.hpp"
#include "cases/harness/files/input_file.hpp"
#include "cases/harness/files/json_text.hpp"

namespace plumbline {
namespace {

constexpr int ledger_format = 1;
constexpr const char* any_case = "*";

Json end(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

void put(const Bounds& bounds, Json& json) {
  json["low"] = end(bounds.expected.low);
  json["high"] = end(bounds.expected.high);
  if (bounds.order) json["order"] = true;
  if (bounds.band && (bounds.band->low || bounds.band->high))
    json["band"] = {{"low", end(bounds.band->low)}, {"high", end(bounds.band->high)}};
  if (bounds.stops)
    json["stops"] = {
        {"step_low", bounds.stops->step_low}, {"step_high", bounds.stops->step_high}, {"field", bounds.stops->field}};
}

std::optional<double> end(const Json& json, const char* key) {
  return json.at(key).is_null() ? std::nullopt : std::optional<double>(json.at(key).get<double>());
}

Bounds bounds(const Json& json) {
  Bounds b;
  b.expected = {end(json, "low"), end(json, "high")};
  b.order = json.value("order", false);
  if (json.contains("band")) b.band = Range{end(json.at("band"), "low"), end(json.at("band"), "high")};
  if (json.contains("stops")) {
    const Json& stops = json.at("stops");
    b.stops = StopBand{stops.at("step_low").get<long>(), stops.at("step_high").get<long>(),
                       stops.at("field").get<std::string>()};
  }
  return b;
}

LedgerLine line(const Json& json) {
  LedgerLine l;
  l.case_name = json.at("case").get<std::string>();
  l.study = json.at("study").get<std::string>();
  l.id = json.at("id").get<std::string>();
  l.tier = json.at("tier").get<std::string>();
  l.origin = json.at("origin").get<std::string>();
  if (const auto known = origin_from(l.origin)) l.origin = name(*known);  // the name of this version
  l.reason = json.at("reason").get<std::string>();
  l.since = json.at("since").get<std::string>();
  l.bounds = bounds(json);
  if (json.contains("widened")) {
    const Json& w = json.at("widened");
    l.widened = Widening{bounds(w.at("from")), w.at("date").get<std::string>(), w.at("why").get<std::string>()};
  }
  return l;
}

std::string gate_words(const LedgerLine::Key& gate) {
  const auto& [case_name, study, id] = gate;
  return case_name == any_case ? "generic gate " + id : fmt::format("gate {} of {}, study {}", id, case_name, study);
}

std::map<LedgerLine::Key, const LedgerLine*> by_key(const std::vector<LedgerLine>& lines) {
  std::map<LedgerLine::Key, const LedgerLine*> map;
  for (const LedgerLine& l : lines) map[l.key()] = &l;
  return map;
}

bool same_but_for_bounds(const LedgerLine& a, const LedgerLine& b) {
  return a.tier == b.tier && a.origin == b.origin && a.reason == b.reason;
}

constexpr const char* record = "`plumbline tolerances cases/tolerances.json --update`";

std::string widened_message(const LedgerLine& from, const LedgerLine& to, const std::string& why) {
  return fmt::format(
      "WIDENED: {} lets pass more ({}): {} became {}. Take it back, or record it with its reason: `plumbline "
      "tolerances "
      "cases/tolerances.json --update --why '...'` changes its line and adds `widened` with date and reason",
      gate_words(to.key()), why, bounds_words(from.bounds), bounds_words(to.bounds));
}

void compare_lines(const LedgerLine& was, const LedgerLine& is, std::vector<Discrepancy>& found) {
  std::string why;
  const Shift by = shift(was.bounds, is.bounds, &why);
  if (by == Shift::widened) found.push_back({"widened", is.key(), widened_message(was, is, why)});
  if (by == Shift::narrowed) {
    found.push_back({"narrowed", is.key(),
                     fmt::format("narrowed: {}: {} became {}. Record it: {}", gate_words(is.key()),
                                 bounds_words(was.bounds), bounds_words(is.bounds), record)});
  }
  if (by == Shift::same && !same_but_for_bounds(was, is)) {
    found.push_back({"reason", is.key(),
                     fmt::format("{}: its tier, origin or reason is not the recorded one. Record it: {}",
                                 gate_words(is.key()), record)});
  }
}

bool equal(const Widening& a, const Widening& b) {
  return a.date == b.date && a.why == b.why && shift(a.from, b.from) == Shift::same;
}

}  // namespace

Json to_json(const LedgerLine& l) {
  Json json{{"case", l.case_name}, {"study", l.study}, {"id", l.id}, {"tier", l.tier}};
  put(l.bounds, json);
  json["origin"] = l.origin;
  json["reason"] = l.reason;
  json["since"] = l.since;
  if (l.widened) {
    Json from = Json::object();
    put(l.widened->from, from);
    json["widened"] = {{"from", from}, {"date", l.widened->date}, {"why", l.widened->why}};
  }
  return json;
}

LedgerLine declared_line(const std::string& case_name, const CaseGate& declared, const std::string& date) {
  const Gate& gate = declared.gate;
  LedgerLine l;
  l.case_name = case_name;
  l.study = declared.study;
  l.id = gate.id;
  l.tier = declared.tier == Tier::quick ? "quick" : "full";
  l.origin = name(gate.origin);
  l.bounds = {gate.expected, {}, {}, gate.order};
  l.since = gate.measured_on.empty() ? date : gate.measured_on;
  std::string reason = gate.reason;
  if (gate.expected_failure) {
    l.bounds.band = gate.expected_failure->band;
    l.bounds.stops = gate.expected_failure->stops;
    reason += "\n" + gate.expected_failure->cause;
    if (!gate.expected_failure->measured_on.empty()) l.since = gate.expected_failure->measured_on;
  }
  l.reason = short_hash(reason);
  return l;
}

std::vector<LedgerLine> declared_lines(const std::vector<const Case*>& entries, const std::string& date) {
  std::vector<LedgerLine> lines;
  for (const CaseGate& gate : generic_gates(any_case, 2)) lines.push_back(declared_line(any_case, gate, date));
  for (const Case* entry : entries) {
    const std::string name = entry->name;
    for (const CaseGate& gate : entry->gates) lines.push_back(declared_line(name, gate, date));
  }
  std::sort(lines.begin(), lines.end(), [](const LedgerLine& a, const LedgerLine& b) { return a.key() < b.key(); });
  return lines;
}

std::vector<LedgerLine> read_ledger(const std::string& file) {
  if (!is_there(file)) throw FileError(file, file + ": cannot be opened; --update writes it");
  std::vector<LedgerLine> lines;
  try {
    const Json json = parse_json(read_text_file(file));
    if (json.at("format").get<int>() > ledger_format) throw FileError(file, file + ": made by a newer version");
    for (const Json& item : json.at("gates")) lines.push_back(line(item));
  } catch (const nlohmann::json::exception& error) {
    throw FileError(file, fmt::format("{}: not a tolerance ledger: {}", file, fault_of(error)));
  }
  std::map<LedgerLine::Key, int> seen;
  for (const LedgerLine& l : lines) {
    if (++seen[l.key()] > 1) throw FileError(file, fmt::format("{}: {} is listed twice", file, gate_words(l.key())));
    if (l.widened && (l.widened->date.empty() || l.widened->why.empty()))
      throw FileError(file, fmt::format("{}: the widening of {} lacks date or reason", file, gate_words(l.key())));
  }
  return lines;
}

void write_ledger(const std::string& file, const std::vector<LedgerLine>& lines) {
  std::string text = fmt::format("{{\"format\": {}, \"gates\": [\n", ledger_format);
  for (std::size_t k = 0; k < lines.size(); ++k)
    text += "  " + json_text(to_json(lines[k])) + (k + 1 < lines.size() ? ",\n" : "\n");
  text += "]}\n";
  const std::string temporary = fmt::format("{}.{}.part", file, ::getpid());
  std::ofstream out(temporary, std::ios::binary);
  out << text;
  out.close();
  std::error_code error;
  if (out) std::filesystem::rename(temporary, file, error);
  if (!out || error) {
    std::filesystem::remove(temporary, error);
    throw FileError(file, file + ": cannot be written");
  }
}

std::vector<Discrepancy> discrepancies(const std::vector<LedgerLine>& recorded,
                                       const std::vector<LedgerLine>& declared) {
  std::vector<Discrepancy> found;
  const auto old = by_key(recorded), now = by_key(declared);
  for (const auto& [key, was] : old) {
    if (const auto is = now.find(key); is != now.end())
      compare_lines(*was, *is->second, found);
    else
      found.push_back(
          {"removed", key, fmt::format("removed: {} is declared no more. Record it: {}", gate_words(key), record)});
  }
  for (const auto& [key, is] : now) {
    if (old.count(key) == 0)
      found.push_back(
          {"new", key, fmt::format("new: {}, {}. Record it: {}", gate_words(key), bounds_words(is->bounds), record)});
  }
  return found;
}

std::vector<Discrepancy> unsigned_widenings(const std::vector<LedgerLine>& earlier,
                                            const std::vector<LedgerLine>& recorded) {
  std::vector<Discrepancy> found;
  const auto old = by_key(earlier);
  for (const LedgerLine& l : recorded) {
    const auto was = old.find(l.key());
    std::string why;
    if (was == old.end() || shift(was->second->bounds, l.bounds, &why) != Shift::widened) continue;
    const auto& before = was->second->widened;
    if (l.widened && !(before && equal(*before, *l.widened))) continue;
    found.push_back({"widened", l.key(), widened_message(*was->second, l, why)});
  }
  return found;
}

std::vector<LedgerLine> updated(const std::vector<LedgerLine>& recorded, const std::vector<LedgerLine>& declared,
                                const std::string& why, const std::string& date) {
  const auto old = by_key(recorded);
  std::vector<LedgerLine> lines = declared;
  std::string unexplained;
  for (LedgerLine& l : lines) {
    const auto found = old.find(l.key());
    if (found == old.end()) continue;
    const LedgerLine& was = *found->second;
    const Shift by = shift(was.bounds, l.bounds);
    if (by == Shift::same) l.since = was.since;
    if (by == Shift::widened) {
      l.widened = Widening{was.bounds, date, why};
      if (why.empty())
        unexplained += fmt::format("\n  {}: {} became {}", gate_words(l.key()), bounds_words(was.bounds),
                                   bounds_words(l.bounds));
    } else if (was.widened && shift(was.widened->from, l.bounds) == Shift::widened) {
      l.widened = was.widened;
    }
  }
  if (!unexplained.empty()) {
    throw UsageError("--why", "", "a sentence", {},
                     "these gates let pass more than recorded; say why with --why:" + unexplained);
  }
  return lines;
}

}  // namespace plumbline
