// A straight membrane in a gas, at rest: pressure above is as below, and the membrane is about to pull. It is taken on
// the taut side of its one-way law, so that it pushes, too. Speed of sound and density of the gas and the cell size are
// one. Settings: all keys of coupled scenes.
#pragma once

#include "cases/harness/description/settings.hpp"
#include "cases/harness/laboratory/patch.hpp"

namespace plumbline {

struct CoupledCell {
  double place = 0.5;          // of the membrane to the grid in cells, (0, 1): its height; on a line that of its points
  double density_ratio = 1;    // m_s/(rho h), m_s the membrane's mass per area, > 0
  double stiffness_ratio = 1;  // E t/(rho c^2 h), E t its tension per strain, > 0
};

// A layer of gas, h high, and the membrane in it as they move along the membrane: on a line, `ppc` points of gas a cell.
// Both go on for ever.
Patch coupled_line_patch(const Settings& settings, const CoupledCell& cell, const Extent& extent);

// Gas fills a box of `width` x `height` cells (>= 2 each) between mirrors, round(sqrt(ppc)) points a cell and direction,
// and the membrane goes across it, parallel to x, through a middle cell. Nothing repeats.
Patch coupled_box_patch(const Settings& settings, const CoupledCell& cell, int width, int height);

}  // namespace plumbline
