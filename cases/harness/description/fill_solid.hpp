// Points for solid bodies on a regular lattice.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <string>

#include "kernel/grid_spec.hpp"
#include "kernel/points/body.hpp"

namespace plumbline {

struct SolidShape {
  std::array<double, 3> low{}, high{};  // m; a box that holds the body
  // Whether a place belongs to the body; empty: the whole box.
  std::function<bool(const std::array<double, 3>&)> inside = {};
};

// Points of spacing h/ppc, `ppc` a cell and direction, aligned with `low`; a point stands at the centre of its cube of
// the lattice and is there if that centre lies inside. Masses and volumes are those of whole cubes; in a ring per radian,
// with the weight r. Body::spacing is set. density: rho_0, kg/m^3, > 0; ppc >= 1.
// Throws std::invalid_argument if no point is inside.
Body fill_solid(std::string name, std::shared_ptr<const Material> material, const SolidShape& shape, double density,
                int ppc, const GridSpec& grid);

}  // namespace plumbline
