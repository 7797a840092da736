#include "kernel/time_integrator.hpp"

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <utility>

namespace plumbline {
namespace {

std::vector<IntegratorEntry>& registered() {
  static std::vector<IntegratorEntry> all;
  return all;
}

std::vector<IntegratorEntry>* collected = nullptr;  // where registrations go while a plug-in is loaded

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

std::string name_refusal(const std::string& name) {
  constexpr std::size_t longest = 63;
  const auto letter_or_digit = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9'); };
  const bool whole = std::all_of(name.begin(), name.end(),
                                 [&](char c) { return letter_or_digit(c) || c == '.' || c == '_' || c == '-'; });
  if (whole && !name.empty() && letter_or_digit(name.front()) && name.size() <= longest) return {};
  return "a name has 1 to 63 characters of a-z, 0-9, '.', '_' and '-', the first a letter or a digit";
}

RegisterIntegrator::RegisterIntegrator(IntegratorEntry entry, const PluginStamp& built_against) {
  if (collected) {
    collected->push_back(std::move(entry));
    return;
  }
  if (std::memcmp(built_against.text, kernel_stamp().text, sizeof built_against.text) != 0) {
    throw std::logic_error("an integrator was built against another kernel");  // nothing of the entry can be read
  }
  if (find_integrator(entry.name)) throw std::logic_error("integrator " + entry.name + " is registered twice");
  if (const std::string why = name_refusal(entry.name); !why.empty()) {
    throw std::logic_error("integrator '" + entry.name + "': " + why);
  }
  if (!entry.make || !entry.copy) throw std::logic_error("integrator " + entry.name + " cannot be made and copied");
  auto& all = registered();
  const auto place = std::upper_bound(all.begin(), all.end(), entry,
                                      [](const auto& a, const auto& b) { return a.name < b.name; });
  all.insert(place, std::move(entry));
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
