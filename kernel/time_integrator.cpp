#include "kernel/time_integrator.hpp"

#include <cstring>
#include <stdexcept>
#include <utility>

#include "kernel/choice.hpp"

namespace plumbline {
namespace {

std::vector<IntegratorEntry>& registered() {
  static std::vector<IntegratorEntry> all;
  return all;
}

std::vector<IntegratorEntry>* collected = nullptr;  // where registrations go while a plug-in is loaded

}  // namespace

const std::vector<IntegratorEntry>& integrators() { return registered(); }

const IntegratorEntry* find_integrator(const std::string& name) { return find_named(registered(), name); }

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

RegisterIntegrator::RegisterIntegrator(IntegratorEntry entry, const PluginStamp& built_against) {
  if (collected) {
    collected->push_back(std::move(entry));
    return;
  }
  if (std::memcmp(built_against.text, kernel_stamp().text, sizeof built_against.text) != 0) {
    throw std::logic_error("an integrator was built against another kernel");  // nothing of the entry can be read
  }
  if (!entry.make || !entry.copy) throw std::logic_error("integrator " + entry.name + " cannot be made and copied");
  add_named(registered(), std::move(entry), "integrator");
}

std::vector<IntegratorEntry> collect_registrations(const std::function<void()>& load) {
  struct Collecting {
    explicit Collecting(std::vector<IntegratorEntry>& into) { collected = &into; }
    ~Collecting() { collected = nullptr; }
  };
  std::vector<IntegratorEntry> found;
  const Collecting now(found);
  load();
  return found;
}

const PluginStamp& kernel_stamp() { return stamp_of_this_file; }

}  // namespace plumbline
