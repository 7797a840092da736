// York's airbag before the probe comes: blown up with a tether inside, at rest.
#pragma once

#include <memory>

#include "cases/catalog/coupled/bag_forces.hpp"
#include "cases/catalog/coupled/membrane.hpp"
#include "cases/harness/description/settings.hpp"
#include "kernel/scene.hpp"

namespace plumbline {

// Pressures, absolute, Pa.
struct BagPressures {
  double inside = 0, outside = 0;
};
// `york`: 4000 and 0, the gauge pressure taken as absolute. `physical`: 4000 more than 101325.
BagPressures bag_pressures(const std::string& name);

inline constexpr double bag_gamma = 1.4, bag_density = 1.2156;  // of the gas, kg/m^3. York, Table 8

// The skin from the pole on the plate to the upper one, counter-clockwise about the gas, m: the polygon of York's
// input. crown: height of the upper pole, inside the ring of the tether. York A.4.8, A.4.9
Curve york_outline(double crown);
inline constexpr double tether_radius = 0.08, tether_height = 0.299;  // of its ring on the skin

// Its material; the density is such that the bag has York's mass of 0.3672 kg.
MembraneMaterial bag_skin(const Curve& outline);

// The grid: cells of 0.5 m / `cells`, the plate at y = 0, space for the bag when it is flat and for the probe above it.
GridSpec airbag_grid(int cells);

// Bag and gas, bodies "gas" and "bag", the outline as they stand, the gas with York's density. The skin is unstretched
// in York's outline.
struct Bag {
  Body gas, skin;
  Tether tether;
};
Bag unstretched_bag(const GridSpec& grid, int ppc, double membrane_ppc, double crown, const BagPressures& pressures,
                    std::shared_ptr<const IdealGas> gas);

// The bag blown up, at rest: the scheme `default` with a drag on all points, -rate v, for `blowing_time`, while a pump holds
// the gas at its pressure and one temperature. At the end all velocities are zero and the gas has York's density at that pressure.
inline constexpr double blowing_time = 60e-3;  // s
Bag inflate(const Bag& bag, const GridSpec& grid, const BagPressures& pressures);

double enclosed_volume(const Body& skin);  // m^3 per radian

}  // namespace plumbline
