// Materials by name: each registers itself in its own source file, with the parameters by which it is made and written down.
#pragma once

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "kernel/materials/material.hpp"

namespace plumbline {

struct MaterialParameter {
  std::string name, unit;
  double value;  // of a choice between two: 0 or 1
};
using MaterialParameters = std::vector<MaterialParameter>;

struct MaterialEntry {
  // A gate of `plumbline verify --material` that is known to be missed: its id, how it fails, and the band of the wrong value.
  struct KnownFailure {
    std::string gate, cause;
    double low, high;
  };
  static constexpr const char* kind = "material";
  std::string name, title, source;
  // Of a material of this name.
  std::function<MaterialParameters(const Material&)> parameters;
  // One with the values given by name, all others at their defaults. Throws std::invalid_argument for a name that it does not have.
  std::function<std::shared_ptr<const Material>(const std::map<std::string, double>& values)> make;
  std::vector<KnownFailure> known_failures = {};
  // Values by which `plumbline verify --material` judges it besides those that it gives all: where else it would not leave a
  // range, as that of elasticity.
  std::map<std::string, double> examples = {};
};

// In the order of their names.
const std::vector<MaterialEntry>& materials();

// Throws std::invalid_argument for an unknown name.
const MaterialEntry& material_named(const std::string& name);

// The parameters of a material, found by its name(). Throws std::invalid_argument if it is not registered.
MaterialParameters parameters_of(const Material& material);

// Takes one in: RegisterPart.
void add_part(MaterialEntry entry);

// A member of M that users set, by name and unit.
template <class M>
struct ParameterMember {
  ParameterMember(const char* called, const char* in, double M::*at) : name(called), unit(in), number(at) {}
  ParameterMember(const char* called, bool M::*at) : name(called), unit("1"), choice(at) {}
  const char *name, *unit;
  double M::*number = nullptr;
  bool M::*choice = nullptr;

  double of(const M& material) const { return number ? material.*number : static_cast<double>(material.*choice); }
  void set(M& material, double value) const {
    if (number)
      material.*number = value;
    else
      material.*choice = value != 0;
  }
};

// The entry of material M, which has these parameters.
template <class M>
MaterialEntry material_entry(std::string title, std::string source, std::vector<ParameterMember<M>> members,
                             std::vector<MaterialEntry::KnownFailure> known_failures = {},
                             std::map<std::string, double> examples = {}) {
  const auto read = [members](const Material& material) {
    const M& own = dynamic_cast<const M&>(material);
    MaterialParameters all;
    for (const ParameterMember<M>& member : members) all.push_back({member.name, member.unit, member.of(own)});
    return all;
  };
  const auto make = [members](const std::map<std::string, double>& values) {
    auto made = std::make_shared<M>();
    for (const auto& [name, value] : values) {
      const auto member = std::find_if(members.begin(), members.end(),
                                       [&name = name](const auto& m) { return m.name == name; });
      if (member == members.end()) {
        std::string known;
        for (const ParameterMember<M>& m : members) known += (known.empty() ? "" : ", ") + std::string(m.name);
        throw std::invalid_argument("material " + made->name() + " has no parameter " + name + "; it has " + known);
      }
      member->set(*made, value);
    }
    return made;
  };
  return {M().name(), std::move(title), std::move(source), read, make, std::move(known_failures), std::move(examples)};
}

}  // namespace plumbline
