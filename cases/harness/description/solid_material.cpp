#include "cases/harness/description/solid_material.hpp"

#include <algorithm>
#include <map>
#include <string>

#include "kernel/materials/material_entry.hpp"

namespace plumbline {
namespace {

bool has(const MaterialParameters& parameters, const std::string& name) {
  return std::any_of(parameters.begin(), parameters.end(), [&](const auto& one) { return one.name == name; });
}

bool is_elastic_solid(const MaterialEntry& entry, bool finite) {
  const auto material = entry.make({});
  if (finite && material->measure() != StressMeasure::full) return false;
  const MaterialParameters parameters = entry.parameters(*material);
  return !material->chain() && !material->surface() && !material->dissipates() && has(parameters, "youngs_modulus") &&
         has(parameters, "density");
}

}  // namespace

Key material_key(bool finite) {
  Key key{.name = "material",
          .value = "own",
          .choices = {"own"},
          .description = "law of the solid, with its E, nu and density"};
  for (const MaterialEntry& entry : materials()) {
    if (is_elastic_solid(entry, finite)) key.choices.push_back(entry.name);
  }
  return key;
}

std::shared_ptr<const Material> chosen_material(const Settings& settings, std::shared_ptr<const Material> own) {
  const std::string& name = settings.text("material");
  if (name == "own") return own;
  const MaterialEntry& entry = material_named(name);
  const MaterialParameters wanted = entry.parameters(*entry.make({}));
  std::map<std::string, double> values;
  for (const MaterialParameter& parameter : parameters_of(*own)) {
    if (has(wanted, parameter.name)) values[parameter.name] = parameter.value;
  }
  return entry.make(values);
}

}  // namespace plumbline
