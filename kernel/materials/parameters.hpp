// What a material states of itself by name, for those who write a scene down.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "kernel/materials/material.hpp"

namespace plumbline {

struct MaterialParameter {
  std::string name, unit;
  double value;  // of a choice between two: 0 or 1
};

// The parameters of a material, found by its name(). Throws std::out_of_range if it has registered none.
std::vector<MaterialParameter> parameters_of(const Material& material);

// Each material registers its own beside its equations: members by name and unit.
class RegisterParameters {
 public:
  using Read = std::function<std::vector<MaterialParameter>(const Material&)>;
  RegisterParameters(const std::string& material, Read read);
};

template <class M>
struct ParameterMember {
  ParameterMember(const char* called, const char* in, double M::*at) : name(called), unit(in), number(at) {}
  ParameterMember(const char* called, bool M::*at) : name(called), unit("1"), choice(at) {}
  const char *name, *unit;
  double M::*number = nullptr;
  bool M::*choice = nullptr;
};

template <class M>
RegisterParameters::Read read_members(std::vector<ParameterMember<M>> members) {
  return [members = std::move(members)](const Material& material) {
    const M& of = dynamic_cast<const M&>(material);
    std::vector<MaterialParameter> all;
    for (const ParameterMember<M>& m : members) {
      all.push_back({m.name, m.unit, m.number ? of.*m.number : static_cast<double>(of.*m.choice)});
    }
    return all;
  };
}

}  // namespace plumbline
