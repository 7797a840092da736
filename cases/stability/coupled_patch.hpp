// A straight membrane across a gas: the smallest scene in which both share nodes. Speed of sound and density of the gas
// and the cell size are one.
#pragma once

#include "cases/harness/settings.hpp"
#include "cases/laboratory/patch.hpp"

namespace plumbline {

struct CoupledCell {
  int width = 2, height = 3;     // in cells, >= 2
  double place = 0.5;            // height of the membrane in the middle cell, in cells, (0, 1)
  double density_ratio = 1;      // m_s/(rho h), m_s the membrane's mass per area
  double stiffness_ratio = 1;    // E t/(rho c^2 h), E t its tension per strain
  double strain = 0.02;          // of the membrane at rest, > 0
};

// Gas fills a box between mirrors, round(sqrt(ppc)) points a cell and direction, and the membrane goes across it, parallel
// to x. All is at rest: pressure above is as below, and mirrors pull where the membrane ends. Nothing repeats. Settings:
// all keys of coupled scenes.
Patch coupled_patch(const Settings& settings, const CoupledCell& cell);

}  // namespace plumbline
