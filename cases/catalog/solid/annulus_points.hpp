// Points of a ring, on the lattice of the grid or on circles.
#pragma once

#include <array>
#include <memory>
#include <string>

#include "cases/harness/description/settings.hpp"
#include "kernel/grid_spec.hpp"
#include "kernel/points/body.hpp"

namespace plumbline {

struct Annulus {
  double inner, outer;                 // m, 0 <= inner < outer
  std::array<double, 2> centre{0, 0};  // m
  bool quarter = false;                // x >= centre, y >= centre alone
};

// On the regular lattice of the grid, `ppc` points a cell and direction: those whose cube has its centre inside. Edges
// are stairs of half a spacing. density: initial, kg/m^3.
Body fill_annulus(std::string name, std::shared_ptr<const Material> material, const Annulus& annulus, double density,
                  int ppc, const GridSpec& grid);

// The same, but squares that an edge cuts count with what lies inside: its area, its centre of mass, and a box of its
// second moments; pieces of less than half a square join the neighbour further inside. Edges and volume are right to
// second order. The boxes are in the columns half_size and half_size_at_start.
Body cut_annulus(std::string name, std::shared_ptr<const Material> material, const Annulus& annulus, double density,
                 int ppc, const GridSpec& grid);

// On circles a spacing h/ppc apart (the nearest that divides the width), points about as far apart along each: edges
// and volume are exact to rounding. Each has the volume of its share of the circle's band, (r_o^2 - r_i^2)/2 dphi, and
// stands at the centre of mass of that share's radii, at its middle angle; Body::spacing is the root of the mean volume.
Body ring_annulus(std::string name, std::shared_ptr<const Material> material, const Annulus& annulus, double density,
                  int ppc, const GridSpec& grid);

// Sectors of the same bands, as many in each, so that they have their corners in common: where those of one band stand between
// those of the next, forces along the circle do not cancel on a grid, by a share that does not fall with h. Each has its area, its
// centre of mass and a parallelogram of two half edges, half its band along the radius and half its middle arc across, in
// the column half_edges_at_start.
Body polar_annulus(std::string name, std::shared_ptr<const Material> material, const Annulus& annulus, double density,
                   int ppc, const GridSpec& grid);

// One of these four by its name: lattice, cut, circles, polar.
using AnnulusLayout = Body (*)(std::string, std::shared_ptr<const Material>, const Annulus&, double, int,
                               const GridSpec&);
AnnulusLayout annulus_layout(const std::string& name);

// The key `layout`, by which a case lets its users choose.
Key layout_key(std::string value);

}  // namespace plumbline
