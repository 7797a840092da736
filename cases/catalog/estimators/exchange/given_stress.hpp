// A material of which a scene gives the stress, or the pressure of a gas: it stays as it is.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "kernel/materials/material.hpp"

namespace plumbline {

class GivenStress final : public Material {
 public:
  explicit GivenStress(StressMeasure measure) : measure_(measure) {}
  std::string name() const override { return "given-stress"; }
  StressMeasure measure() const override { return measure_; }
  Store store() const override { return Store::none; }
  void add_columns(Columns& points, int) const override {
    if (isotropic()) points.add(column::pressure);
  }
  double advance(Columns&, PointRange, const MaterialContext&, double) const override { return 0; }
  std::vector<const ColumnId*> internal_variables(const MaterialContext&) const override { return {}; }
  std::vector<double> rates(const Columns&, const MaterialContext&) const override { return {}; }
  void evaluate_stress(Columns&, PointRange, const MaterialContext&) const override {}
  double stored_energy(const Columns&, PointRange) const override { return 0; }
  StepBounds step_bounds(const Columns&, PointRange, int) const override { return {.fastest = 1}; }
  Fault first_fault(const Columns&, PointRange) const override { return {}; }

 private:
  StressMeasure measure_;
};

// The largest difference, over the size of numbers above one: 0 where both are no numbers, none where there are not as many or
// one alone is a number.
template <class Number>
double farthest(const std::vector<Number>& found, const std::vector<double>& exact) {
  if (found.size() != exact.size()) return NAN;
  double most = 0;
  for (std::size_t k = 0; k < found.size(); ++k) {
    const auto value = static_cast<double>(found[k]);
    if (std::isnan(value) != std::isnan(exact[k])) return NAN;
    if (!std::isnan(value)) most = std::max(most, std::abs(value - exact[k]) / std::max(1.0, std::abs(exact[k])));
  }
  return most;
}

}  // namespace plumbline
