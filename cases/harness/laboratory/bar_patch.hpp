// Elastic bars and plates as lattices: speed of sound, density and cell size are one.
#pragma once

#include <string>

#include "cases/harness/laboratory/patch.hpp"

namespace plumbline {

// What the maps between points and grid are.
struct MapChoice {
  std::string shape = "linear", transfer = "flip";
  int transfer_order = 2;
};

// A long bar on a line, `ppc` points a cell. place: where a point stands in its share of a cell, (0, 1); 1/2: regular.
Patch bar_patch(const MapChoice& maps, int ppc, double place, const Extent& extent);

// How a bar with one free end ends on the other side: it leans on a plane of symmetry, or is free there, too, after
// `cells` times `ppc` points.
enum class FarEnd { wall, free };

// The free end of a bar, about `cells` cells long. The last point lies `depth` cells deep in the last cell that has a point,
// (0, 1]; then every 1/ppc cells one.
Patch bar_edge_patch(const MapChoice& maps, int ppc, double depth, int cells, FarEnd far_end = FarEnd::wall);

// A plate, plane strain, `ppc` points a cell and direction, in both directions at `place`. nu: Poisson's ratio.
Patch plate_patch(const MapChoice& maps, int ppc, double place_x, double place_y, double nu, const Extent& extent);

}  // namespace plumbline
