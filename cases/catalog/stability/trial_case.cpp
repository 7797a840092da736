#include "cases/catalog/stability/trial_case.hpp"

namespace plumbline {

namespace {

// A trial has no level to be told.
Number called(std::string quantity, Number number) {
  number.quantity = std::move(quantity);
  return number;
}

}  // namespace

Number error_of(const std::string& measure) { return called(measure, error_at(measure, trial_level)); }
Number value_of(const std::string& measure) { return called("value of " + measure, value_at(measure, trial_level)); }

Measure finding(std::string name, double value, std::string unit) {
  Measure measure;
  measure.name = std::move(name);
  measure.value = value;
  measure.error = value;
  measure.scale = 1;
  measure.unit = std::move(unit);
  return measure;
}

}  // namespace plumbline
