// The values with which a material is judged.
#include <map>

#include "cases/harness/parts/material_gates.hpp"

namespace plumbline {
namespace {

double example_of(const std::string& unit) {
  if (unit == "Pa") return 1000;
  if (unit == "kg/m^3") return 2;
  return 0.25;
}

}  // namespace

MaterialSubject::MaterialSubject(const MaterialEntry& entry) {
  std::map<std::string, double> with_units, all;
  for (const MaterialParameter& parameter : entry.parameters(*entry.make({}))) {
    const double example = parameter.value != 0 ? parameter.value : example_of(parameter.unit);
    if (parameter.name == "density") density = example;
    if (parameter.value != 0) continue;
    for (const MaterialParameter& back : entry.parameters(*entry.make({{parameter.name, example}}))) {
      if (back.name != parameter.name || back.value != example) continue;  // a choice becomes 1
      all[parameter.name] = example;
      if (parameter.unit != "1" && parameter.unit != "Pa s") with_units[parameter.name] = example;
    }
  }
  made.push_back(entry.make(all));
  if (with_units.size() < all.size()) made.push_back(entry.make(with_units));
  if (entry.examples.empty()) return;
  for (const auto& [name, value] : entry.examples) all[name] = value;
  made.push_back(entry.make(all));
}

}  // namespace plumbline
