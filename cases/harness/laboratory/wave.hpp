// A standing wave in a bar between two walls: what the maps make of a time integrator's order.
#pragma once

#include <vector>

#include "cases/harness/laboratory/bar_patch.hpp"
#include "cases/harness/laboratory/step_map.hpp"

namespace plumbline {

// Half a wave on `cells` cells, `ppc` points each; speed of sound, density and cell size are one. FLIP alone: other
// transfers filter velocities once a step, so that shorter steps filter more and there is nothing to converge to.
class StandingWave {
 public:
  StandingWave(const MapChoice& maps, int cells, int ppc);

  // Velocities, then strains of the points by their numbers, over their first amplitude.
  using Amplitudes = std::vector<double>;

  Scene scene() const;
  // After `steps` equal steps to t (h/c), through the production kernel.
  Amplitudes stepped(const IntegratorChoice& integrator, double t, int steps) const;
  // What an integrator without any error would make of the same equations on the nodes and points: the exponential of their
  // matrix, column by column the rates of unit states. Positions are held: the wave is small.
  Amplitudes exact(double t) const;
  // d/dt of velocities and strains, row by row.
  std::vector<Amplitudes> rates() const;

 private:
  MapChoice maps_;
  int cells_, ppc_;
};

}  // namespace plumbline
