#include "reference/registry.hpp"

#include <stdexcept>

namespace plumbline::reference {
namespace {

using Catalog = std::map<std::string, std::unique_ptr<Reference>, std::less<>>;

Catalog& catalog() {
  static Catalog entries;  // local: other files register before main, in any order
  return entries;
}

}  // namespace

void Answer::add(const std::string& key, Bounded value) {
  values.emplace_back(key, value.value);
  bounds.emplace_back(key, value.bound);
}

Answer Reference::evaluate(const std::map<std::string, double>& chosen, std::span<const double> at) const {
  const std::map<std::string, double> settings = complete(parameters(), chosen);
  const Parameter position = abscissa();
  for (double value : at) check(position, value);
  return solve(settings, at);
}

Registration::Registration(std::unique_ptr<Reference> reference) {
  const std::string name = reference->name();
  if (!catalog().emplace(name, std::move(reference)).second) {
    throw std::logic_error("two references are called " + name);
  }
}

std::vector<const Reference*> references() {
  std::vector<const Reference*> all;
  for (const auto& [name, reference] : catalog()) all.push_back(reference.get());
  return all;
}

const Reference* find_reference(std::string_view name) {
  const auto found = catalog().find(name);
  return found == catalog().end() ? nullptr : found->second.get();
}

}  // namespace plumbline::reference
