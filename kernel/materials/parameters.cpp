#include "kernel/materials/parameters.hpp"

#include <map>
#include <stdexcept>

namespace plumbline {
namespace {

std::map<std::string, RegisterParameters::Read>& registered() {
  static std::map<std::string, RegisterParameters::Read> all;
  return all;
}

}  // namespace

RegisterParameters::RegisterParameters(const std::string& material, Read read) {
  registered()[material] = std::move(read);
}

std::vector<MaterialParameter> parameters_of(const Material& material) {
  const auto found = registered().find(material.name());
  if (found == registered().end()) throw std::out_of_range("material " + material.name() + " states no parameters");
  return found->second(material);
}

}  // namespace plumbline
