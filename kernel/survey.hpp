// What is read off the points after a step, for the ledger, the next step's limit and the checks.
#pragma once

#include "kernel/ledger.hpp"
#include "kernel/scene.hpp"

namespace plumbline {

struct Survey {
  Totals totals;
  StepBounds bounds;
  double step_limit = 0;  // for Courant number 1, s: h / max(c_p + |v_p|), also h^2 / (2 dim diffusivity)
  bool admissible = true;
  // Of other points; the step limit is found once all are in.
  Survey& operator+=(const Survey& o) {
    totals += o.totals;
    bounds.include(o.bounds);
    admissible = admissible && o.admissible;
    return *this;
  }
  friend Survey operator+(Survey a, const Survey& b) { return a += b; }
};

// That of all points of a scene, with the mass on its nodes and cells of h m.
Survey completed(Survey of_points, double grid_mass, double h, int dim);

// So far beyond a side, in cells, a point still stands on it: on a wall it drifts by the rounding of a sum that is zero.
inline constexpr double on_side = 1e-9;

// Throws InadmissibleState for the first point that is: where it stands, its velocity, or what its material says.
void stop_at_inadmissible(const Scene& scene);

}  // namespace plumbline
