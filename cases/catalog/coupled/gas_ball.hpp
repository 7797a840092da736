// Gas at rest inside a sphere.
#pragma once

#include <memory>
#include <string>

#include "kernel/grid_spec.hpp"
#include "kernel/materials/ideal_gas.hpp"
#include "kernel/points/body.hpp"

namespace plumbline {

// A ball of gas of a radius, m, about the origin: one point at the centroid of each cell of a lattice of the spacing
// h / ppc^(1/3), as far as the cell is inside, with the mass of that part. A uniform pressure pushes each node as the
// sphere does, but for a share of the order (spacing/h)^2. density, kg/m^3, and energy, J/kg, > 0; ppc > 0, a cube where
// the lattice is to fit the cells.
Body fill_ball(const std::string& name, std::shared_ptr<const IdealGas> gas, const GridSpec& grid, int ppc,
               double radius, double density, double energy);

}  // namespace plumbline
