#include "reference/registry.hpp"

#include <charconv>

#include "cases/harness/commands/command.hpp"

namespace plumbline {
namespace {

const reference::Reference& find(const std::string& name) {
  if (const reference::Reference* found = reference::find_reference(name)) return *found;
  std::vector<std::string> names;
  for (const reference::Reference* r : reference::references()) names.push_back(r->name());
  throw unknown_name("reference", name, names);
}

std::map<std::string, double> parsed(const reference::Reference& reference,
                                     const std::vector<std::string>& assignments) {
  std::vector<Key> keys;
  for (const reference::Parameter& p : reference.parameters()) {
    keys.push_back({.name = p.key,
                    .value = p.value,
                    .unit = p.unit,
                    .low = p.low,
                    .high = p.high,
                    .low_open = p.low_open,
                    .high_open = p.high_open,
                    .description = p.description});
  }
  Settings settings(keys);
  for (const std::string& assignment : assignments) settings.set_text(assignment, reference.name());
  std::map<std::string, double> chosen;
  for (const Key& key : settings.keys()) chosen[key.name] = std::get<double>(key.value);
  return chosen;
}

Json record(const reference::Record& values) {
  Json object = Json::object();
  for (const auto& [key, value] : values) object[key] = std::isfinite(value) ? Json(value) : Json(nullptr);
  return object;
}

int execute(const Invocation& invocation, const std::string& name, const std::vector<double>& at) {
  const reference::Reference& reference = find(name);
  const auto chosen = parsed(reference, invocation.options.settings);
  const reference::Answer answer = reference.evaluate(chosen, at);
  const Output out(invocation.options);
  out.line("{}: {} [{}]", reference.name(), reference.title(), reference.source());
  for (std::size_t k = 0; k < answer.values.size(); ++k) {
    out.line("  {:26} {:.15g}  bound {:.1e}", answer.values[k].first, answer.values[k].second, answer.bounds[k].second);
  }
  Json document{{"name", reference.name()},        {"settings", Json::object()}, {"values", record(answer.values)},
                {"bounds", record(answer.bounds)}, {"at", Json::array()},        {"at_bounds", Json::array()}};
  for (const reference::Parameter& p : reference.parameters()) document["settings"][p.key] = chosen.at(p.key);
  for (const reference::Record& row : answer.at) {
    std::string text;
    for (const auto& [key, value] : row) text += fmt::format("  {} {:.12g}", key, value);
    out.line("{}", text);
    document["at"].push_back(record(row));
  }
  for (const reference::Record& row : answer.at_bounds) document["at_bounds"].push_back(record(row));
  write_json(invocation.options, document);
  return 0;
}

}  // namespace

Command add_reference(const Arguments& program, Invocation& invocation) {
  const Arguments sub = program.command("reference", "a reference alone: values and error bounds",
                                        "Example: plumbline reference riemann --set gamma=1.67 --at -0.5,0,0.5");
  auto name = std::make_shared<std::string>();
  auto at = std::make_shared<std::vector<double>>();
  sub.option("name", *name, "the reference").required();
  sub.option("--at", *at, "where, separated by commas").separated_by_commas();
  sub.option("--set", invocation.options.settings, "key=value (repeatable)").repeatable();
  add_json(sub, invocation.options);
  return {sub, [&invocation, name, at] { return execute(invocation, *name, *at); }};
}

}  // namespace plumbline
