// Each reference of the catalog against a second computation of the same numbers, by other means: 30 to 60 digits, differential
// equations step by step, finite elements. Made once by tests/reference and kept in reference/second_values.json.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <string_view>

#include "cases/catalog/stability/trial_case.hpp"
#include "cases/harness/files/json_text.hpp"
#include "reference/registry.hpp"

namespace plumbline::second_computations {
namespace {

constexpr const char* kept_lines[] = {
#include "second_values.inc"
};

// Numbers that one test found: by the names in a reference's answer, those of row k as name[k].
struct Kept {
  std::string reference, by;
  std::map<std::string, double> settings;
  std::vector<double> at;
  struct Value {
    std::string name;
    double second, within, bound;  // what the second computation may be off, and the first: 0 where no bound is judged
  };
  std::vector<Value> values;
};

// Lines hold an entry each, those of a reference beside one another: whoever asks for one need not read all.
std::string_view reference_of(std::string_view line) {
  constexpr std::string_view before = R"("reference": ")";
  const std::size_t found = line.find(before);
  if (found == line.npos) return {};
  line.remove_prefix(found + before.size());
  return line.substr(0, line.find('"'));
}

std::vector<Kept> kept_of(std::string_view reference) {
  std::vector<Kept> all;
  for (std::string_view line : kept_lines) {
    if (reference_of(line) != reference) continue;
    if (line.ends_with(',')) line.remove_suffix(1);
    const Json entry = parse_json(std::string(line));
    Kept kept{.reference = entry.at("reference"),
              .by = entry.at("by"),
              .settings = entry.at("settings"),
              .at = entry.at("at"),
              .values = {}};
    for (const auto& [name, numbers] : entry.at("values").items()) {
      kept.values.push_back({name, numbers.at(0), numbers.at(1), numbers.at(2)});
    }
    all.push_back(std::move(kept));
  }
  return all;
}

std::vector<std::string> compared_references() {
  std::vector<std::string> names;
  for (const std::string_view line : kept_lines) {
    const std::string_view name = reference_of(line);
    if (!name.empty() && (names.empty() || names.back() != name)) names.emplace_back(name);
  }
  return names;
}

std::map<std::string, reference::Bounded> answered(const Kept& kept) {
  const reference::Reference* const asked = reference::find_reference(kept.reference);
  if (!asked) throw std::runtime_error(fmt::format("{}: there is no reference {}", kept.by, kept.reference));
  const reference::Answer answer = asked->evaluate(kept.settings, kept.at);
  std::map<std::string, reference::Bounded> numbers;
  for (std::size_t k = 0; k < answer.values.size(); ++k) {
    numbers[answer.values[k].first] = {answer.values[k].second, answer.bounds[k].second};
  }
  for (std::size_t row = 0; row < answer.at.size(); ++row) {
    for (std::size_t k = 1; k < answer.at[row].size(); ++k) {  // after the abscissa
      numbers[fmt::format("{}[{}]", answer.at[row][k].first, row)] = {answer.at[row][k].second,
                                                                      answer.at_bounds[row][k - 1].second};
    }
  }
  return numbers;
}

// |value - second| over what both may be off, to which come a few roundings: of what is kept, and of what another compiler makes of
// the value. Of two bounds, the one kept and the one given now, the smaller is judged: neither a wider bound nor one that does not
// hold passes. At weak fronts the deviation is the tolerance itself, since bounds cover both sides. NaN if the value is no number.
double deviation(const reference::Bounded& found, const Kept::Value& kept) {
  if (kept.bound > 0 && !(found.bound >= 0)) return HUGE_VAL;
  const double off = std::abs(found.value - kept.second);
  if (off == 0) return 0;
  const double tolerance = kept.within + std::min(kept.bound, found.bound);
  return off / (tolerance + 4 * std::numeric_limits<double>::epsilon() * (std::abs(kept.second) + tolerance));
}

// By how much the bound is another than the one kept, up or down, relative.
double change_of_bound(double bound, double kept) {
  if (kept == 0 || bound == kept) return 0;
  return bound > 0 ? std::max(bound / kept, kept / bound) - 1 : HUGE_VAL;
}

Findings compared(const std::string& name) {
  ProfileColumn number{"number", "1", "number kept", {}}, values{"value", "1", "value", {}},
      deviations{"deviation", "1", "deviation over its tolerance", {}};
  double largest = 0, change = 0;
  for (const Kept& kept : kept_of(name)) {
    const std::map<std::string, reference::Bounded> found = answered(kept);
    for (const Kept::Value& one : kept.values) {
      const auto value = found.find(one.name);
      if (value == found.end()) throw std::runtime_error(fmt::format("{}: {} has no {}", kept.by, name, one.name));
      number.values.push_back(static_cast<double>(number.values.size() + 1));
      values.values.push_back(value->second.value);
      deviations.values.push_back(deviation(value->second, one));
      largest = larger(largest, deviations.values.back());
      change = larger(change, change_of_bound(value->second.bound, one.bound));
    }
  }
  Findings findings;
  findings.measures = {finding("deviation", largest), finding("bounds", change),
                       finding("numbers", static_cast<double>(number.values.size()))};
  findings.profile.abscissa = "number";
  findings.profile.columns = {std::move(number), std::move(values), std::move(deviations)};
  return findings;
}

Findings catalog() {
  ProfileColumn number{"number", "1", "reference, by name", {}}, has{"second", "1", "has a second computation", {}};
  double without = 0;
  const std::vector<std::string> seconds = compared_references();
  for (const reference::Reference* one : reference::references()) {
    const bool second = std::find(seconds.begin(), seconds.end(), one->name()) != seconds.end();
    if (!second) ++without;
    number.values.push_back(static_cast<double>(number.values.size() + 1));
    has.values.push_back(second ? 1 : 0);
  }
  Findings findings;
  findings.measures = {finding("without", without)};
  findings.profile.abscissa = "number";
  findings.profile.columns = {std::move(number), std::move(has)};
  return findings;
}

std::vector<Trial> trials() {
  std::vector<Trial> all{{"catalog", "all references",
                          "Without a second computation nothing but its own bound speaks for a reference.", catalog}};
  for (const std::string& name : compared_references()) {
    all.push_back({name, name,
                   "Numbers that tests found by other means, for problems of the whole range of parameters.",
                   [name] { return compared(name); }});
  }
  return all;
}

std::vector<CaseGate> gates() {
  std::vector<CaseGate> all{gate("catalog/without", value_of("without"), exactly(0),
                                 requirement("every reference has a second computation"))};
  for (const std::string& name : compared_references()) {
    all.push_back(gate(name + "/deviation", value_of("deviation"), at_most(1),
                       identity("both hold the true number within their bounds: they differ by no more than the sum")));
    all.push_back(
        gate(name + "/bounds", value_of("bounds"), at_most(0.01),
             requirement("the bound that the second computation was compared with: whoever derives another runs that "
                         "again; 1 % for what functions of another C library change")));
  }
  return all;
}

Case second_computations() { return trial_case("second-computations", trials(), gates()); }
PLUMBLINE_CASE(second_computations);

}  // namespace
}  // namespace plumbline::second_computations
