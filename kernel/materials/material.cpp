#include "kernel/materials/material.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace plumbline {
namespace {

std::vector<MaterialEntry>& registered() {
  static std::vector<MaterialEntry> all;
  return all;
}

}  // namespace

void StepBounds::include(const StepBounds& other) {
  const auto take = [](double& mine, double theirs) {
    if (!std::isnan(mine) && !(theirs <= mine)) mine = theirs;
  };
  take(fastest, other.fastest);
  take(diffusivity, other.diffusivity);
}

const std::vector<MaterialEntry>& materials() { return registered(); }

RegisterMaterial::RegisterMaterial(MaterialEntry entry) {
  auto& all = registered();
  const auto place = std::upper_bound(all.begin(), all.end(), entry,
                                      [](const auto& a, const auto& b) { return a.name < b.name; });
  all.insert(place, std::move(entry));
}

}  // namespace plumbline
