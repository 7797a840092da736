#include "kernel/survey.hpp"

#include <algorithm>
#include <cmath>

#include "kernel/inadmissible.hpp"

namespace plumbline {

Survey completed(Survey of_points, double grid_mass, double h, int dim) {
  const StepBounds& bounds = of_points.bounds;
  double limit = HUGE_VAL;
  if (bounds.fastest > 0) limit = std::min(limit, h / bounds.fastest);
  if (bounds.diffusivity > 0) limit = std::min(limit, h * h / (2 * dim * bounds.diffusivity));
  of_points.step_limit = limit;
  of_points.totals.grid_mass = grid_mass;
  return of_points;
}

void stop_at_inadmissible(const Scene& scene) {
  const GridSpec& grid = scene.grid;
  for (const Body& body : scene.bodies) {
    const auto stop = [&](int p, const std::string& field, double value, const std::string& reason) {
      throw InadmissibleState(reason, body.name, body.id[static_cast<std::size_t>(p)], field, value);
    };
    for (int d = 0; d < grid.dim; ++d) {
      const auto axis = static_cast<std::size_t>(d);
      const double *x = body.points(column::position, d), *v = body.points(column::velocity, d);
      const double low = grid.origin[axis] - on_side * grid.h;
      const double high = grid.origin[axis] + (grid.cells[axis] + on_side) * grid.h;
      for (int p = 0; p < body.points.points(); ++p) {
        if (!std::isfinite(v[p])) stop(p, column::velocity.name(), v[p], "the velocity must be finite");
        if (x[p] >= low && x[p] <= high) continue;
        stop(p, column::position.name(), x[p],
             std::isfinite(x[p]) ? "a point left the grid" : "the position must be finite");
      }
    }
    const Material::Fault fault = body.material->first_fault(body.points, all_points(body.points));
    if (fault.point >= 0) stop(fault.point, fault.field, fault.value, fault.reason);
  }
}

}  // namespace plumbline
