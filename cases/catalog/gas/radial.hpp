// Flows of one radius, cylinders and spheres, and the geometries in which they can be computed: a quarter of the
// cylinder in the plane or one slice of it by rings, a quarter of the sphere's section by rings or its octant.
#pragma once

#include <string>
#include <vector>

#include "cases/catalog/gas/gas_problem.hpp"

namespace plumbline {

struct RadialGeometry {
  std::string name;    // plane, axisymmetric, 3d: what a key `geometry` says
  int dimension;       // of the flow: 2 cylinder, 3 sphere
  int dim;             // of the grid
  bool axisymmetric;   // x is the radius, y the axis
  bool slice = false;  // rings of a cylinder: the flow's radius is x, and y has a few cells between walls

  // Directions, from 0, that the radius is made of.
  int spread() const { return slice ? 1 : dim; }
};

// Those of a cylinder or a sphere, the cheapest first.
const std::vector<RadialGeometry>& radial_geometries(int dimension);
// Throws UsageError with the names that there are.
const RadialGeometry& radial_geometry(int dimension, const std::string& name);
Key geometry_key(int dimension, std::string by_default = "axisymmetric");

double radius_of(const RadialGeometry& geometry, const Position& x);
Position radial_direction(const RadialGeometry& geometry, const Position& x);  // zero at the centre

// Height of a slice: two cells, the fewest that walls on both sides allow.
inline double slice_height(double h) { return 2 * h; }

// Share of the scene in masses, energies and volumes of the whole flow, which references count: all round, per length
// of a cylinder. Rings are counted per radian.
double share_of_whole(const RadialGeometry& geometry, double h);
// Volume of the scene within the radius.
double space_within(const RadialGeometry& geometry, double radius, double h);

// Sets what the geometry decides: the domain [0, length] along each direction of the radius, rounded up to whole cells,
// with mirrors at the centre; coordinate, direction and abscissa; `ppc` points a cell along each direction.
// Throws UsageError for a shifted grid: a wall must stand at the centre.
void set_geometry(GasFlow& flow, const RadialGeometry& geometry, double length, const Settings& settings);
double cell_size(const GasFlow& flow, const Settings& settings);

// coverage: volume of the points judged over that of the space within `radius`. Points are inside or outside as a
// whole, a choice of about a cell's worth of them at the radius.
Measure coverage_within(const RadialGeometry& geometry, const std::vector<GasSample>& points, double radius, double h);

// Two hundredths: half a percent for a lattice of squares cut by a circle some tens of points from the centre, and what
// a kernel of three cells moves across the circle or blurs of a shock inside it.
CaseGate radial_coverage_gate(const std::string& study, double level);

}  // namespace plumbline
