#include "cases/harness/description/measures.hpp"

#include <cmath>

namespace plumbline {

Measure scalar_measure(std::string name, double value, double reference, double bound, std::string unit) {
  return {std::move(name), std::abs(value - reference), std::abs(reference), value, reference, bound, std::move(unit)};
}

Measure share_measure(std::string name, double value, double reference, double bound) {
  Measure measure = scalar_measure(std::move(name), value, reference, bound, "1");
  measure.scale = 1;
  return measure;
}

std::vector<Measure> field_norms(const std::string& name, const std::string& unit,
                                 std::span<const FieldSample> samples) {
  std::vector<ErrorSample> errors;
  for (const FieldSample& s : samples) {
    errors.push_back({s.volume, std::abs(s.computed - s.exact), std::abs(s.exact), s.bound});
  }
  return error_norms(name, unit, errors);
}

std::vector<Measure> error_norms(const std::string& name, const std::string& unit,
                                 std::span<const ErrorSample> samples) {
  double volume = 0, l1 = 0, l2 = 0, linf = 0, s1 = 0, s2 = 0, sinf = 0, b1 = 0, b2 = 0, binf = 0;
  for (const auto& [v, e, r, bound] : samples) {
    volume += v;
    l1 += v * e;
    l2 += v * e * e;
    linf = larger(linf, e);
    s1 += v * r;
    s2 += v * r * r;
    sinf = larger(sinf, r);
    b1 += v * bound;
    b2 += v * bound * bound;
    binf = larger(binf, bound);
  }
  const auto norm = [&](const char* which, double error, double scale, double bound) {
    return Measure{name + "." + which, error, scale, {}, {}, bound, unit};
  };
  return {norm("L1", l1 / volume, s1 / volume, b1 / volume),
          norm("L2", std::sqrt(l2 / volume), std::sqrt(s2 / volume), std::sqrt(b2 / volume)),
          norm("Linf", linf, sinf, binf)};
}

const ProfileColumn* Profile::find(const std::string& name) const {
  for (const ProfileColumn& column : columns) {
    if (column.name == name) return &column;
  }
  return nullptr;
}

}  // namespace plumbline
