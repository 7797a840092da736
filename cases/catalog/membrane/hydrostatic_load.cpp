#include "cases/catalog/membrane/hydrostatic_load.hpp"

#include <algorithm>

#include "kernel/points/column_names.hpp"

namespace plumbline {

Load hydrostatic_load(double base, double weight) {
  return [=](double, Columns& points, std::span<const int>) {
    const double *x = points(column::position), *y = points(column::position, 1), *mass = points(column::mass);
    double* force[2] = {points(column::body_force), points(column::body_force, 1)};
    const int n = points.points();
    for (double* component : force) std::fill_n(component, n, 0.0);
    for (int a = 0; a + 1 < n; ++a) {
      const int b = a + 1;
      const double normal[2] = {y[b] - y[a], x[a] - x[b]};  // right of the way, times l
      const double at_a = base - weight * y[a], at_b = base - weight * y[b];
      for (int d = 0; d < 2; ++d) {
        force[d][a] += (2 * at_a + at_b) / 6 * normal[d] / mass[a];
        force[d][b] += (at_a + 2 * at_b) / 6 * normal[d] / mass[b];
      }
    }
  };
}

}  // namespace plumbline
