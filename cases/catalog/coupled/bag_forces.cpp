#include "cases/catalog/coupled/bag_forces.hpp"

#include <algorithm>
#include <cmath>

#include "kernel/materials/material.hpp"

namespace plumbline {
namespace {

std::array<double, 2> reach(const Columns& chain, const Tether& tether) {
  std::array<double, 2> way{};
  const auto p = static_cast<std::size_t>(tether.after);
  for (int d = 0; d < 2; ++d) {
    const double* x = chain(column::position, d);
    const double ring = (1 - tether.share) * x[p] + tether.share * x[p + 1];
    way[static_cast<std::size_t>(d)] = ring - tether.anchor[static_cast<std::size_t>(d)];
  }
  return way;
}

}  // namespace

std::vector<double> volume_gradient(const Columns& chain) {
  const auto n = static_cast<std::size_t>(chain.points());
  const double *r = chain(column::position), *y = chain(column::position, 1);
  std::vector<double> gradient(2 * n);
  for (std::size_t p = 0; p + 1 < n; ++p) {
    const double a = r[p], b = r[p + 1], rise = y[p + 1] - y[p];
    const double across = (a * a + a * b + b * b) / 6;  // [Airbag 1]
    gradient[p] += (2 * a + b) / 6 * rise;
    gradient[p + 1] += (a + 2 * b) / 6 * rise;
    gradient[n + p] -= across;
    gradient[n + p + 1] += across;
  }
  return gradient;
}

void add_outside_pressure(Columns& chain, double pressure) {
  const std::vector<double> gradient = volume_gradient(chain);
  const auto n = static_cast<std::size_t>(chain.points());
  const double* mass = chain(column::mass);
  for (int d = 0; d < 2; ++d) {
    double* force = chain(column::body_force, d);
    for (std::size_t p = 0; p < n; ++p) {
      force[p] -= pressure * gradient[static_cast<std::size_t>(d) * n + p] / mass[p];  // [Airbag 1]
    }
  }
}

double tension(const Columns& chain, const Tether& tether) {
  const auto way = reach(chain, tether);
  return tether.stiffness * std::max(0.0, std::hypot(way[0], way[1]) - tether.length);  // [Airbag 2]
}

void add_tether(Columns& chain, const Tether& tether) {
  const auto way = reach(chain, tether);
  const double pull = tension(chain, tether) / std::hypot(way[0], way[1]);
  const double* mass = chain(column::mass);
  const double shares[2] = {1 - tether.share, tether.share};
  for (int d = 0; d < 2; ++d) {
    for (int end = 0; end < 2; ++end) {
      const int p = tether.after + end;
      chain(column::body_force, d)[p] -= pull * shares[end] * way[static_cast<std::size_t>(d)] / mass[p];
    }
  }
}

}  // namespace plumbline
