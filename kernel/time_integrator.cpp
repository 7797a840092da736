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

RegisterIntegrator::RegisterIntegrator(IntegratorEntry entry) {
  if (find_integrator(entry.name)) throw std::logic_error("integrator " + entry.name + " is registered twice");
  auto& all = registered();
  const auto place = std::upper_bound(all.begin(), all.end(), entry,
                                      [](const auto& a, const auto& b) { return a.name < b.name; });
  all.insert(place, std::move(entry));
}

}  // namespace plumbline
