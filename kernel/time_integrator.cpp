#include "kernel/time_integrator.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace plumbline {
namespace {

std::vector<IntegratorEntry>& registered() {
  static std::vector<IntegratorEntry> all;
  return all;
}

}  // namespace

const std::vector<IntegratorEntry>& integrators() { return registered(); }

const IntegratorEntry* find_integrator(const std::string& name) {
  for (const IntegratorEntry& entry : registered()) {
    if (entry.name == name) return &entry;
  }
  return nullptr;
}

void set_parameters(TimeIntegrator& integrator, const std::map<std::string, double>& chosen) {
  for (const IntegratorParameter& parameter : integrator.parameters()) {
    const auto found = chosen.find(parameter.name);
    if (found == chosen.end()) continue;
    if (!(found->second >= parameter.low && found->second <= parameter.high)) {
      throw std::invalid_argument(parameter.name + " = " + std::to_string(found->second) + " is not within [" +
                                  std::to_string(parameter.low) + ", " + std::to_string(parameter.high) + "]");
    }
    *parameter.value = found->second;
  }
}

RegisterIntegrator::RegisterIntegrator(IntegratorEntry entry) {
  if (find_integrator(entry.name)) throw std::logic_error("integrator " + entry.name + " is registered twice");
  if (!entry.make || !entry.copy) throw std::logic_error("integrator " + entry.name + " cannot be made and copied");
  auto& all = registered();
  const auto place = std::upper_bound(all.begin(), all.end(), entry,
                                      [](const auto& a, const auto& b) { return a.name < b.name; });
  all.insert(place, std::move(entry));
}

}  // namespace plumbline
