#include "cases/harness/measures.hpp"

#include <cmath>

namespace plumbline {

Measure scalar_measure(std::string name, double value, double reference, double bound, std::string unit) {
  return {std::move(name), std::abs(value - reference), std::abs(reference), value, reference, bound, std::move(unit)};
}

std::vector<Measure> field_norms(const std::string& name, const std::string& unit,
                                 std::span<const FieldSample> samples) {
  double volume = 0, l1 = 0, l2 = 0, linf = 0, s1 = 0, s2 = 0, sinf = 0, b1 = 0, b2 = 0, binf = 0;
  for (const FieldSample& s : samples) {
    const double e = std::abs(s.computed - s.exact), r = std::abs(s.exact);
    volume += s.volume;
    l1 += s.volume * e;
    l2 += s.volume * e * e;
    linf = larger(linf, e);
    s1 += s.volume * r;
    s2 += s.volume * r * r;
    sinf = larger(sinf, r);
    b1 += s.volume * s.bound;
    b2 += s.volume * s.bound * s.bound;
    binf = larger(binf, s.bound);
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
