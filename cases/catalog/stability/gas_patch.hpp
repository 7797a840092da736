// A gas as a lattice of points, at rest or under uniform compression: speed of sound, density and cell
// size are one.
#pragma once

#include <memory>

#include "cases/harness/description/settings.hpp"
#include "cases/harness/laboratory/patch.hpp"
#include "kernel/materials/ideal_gas.hpp"

namespace plumbline {

inline constexpr double gas_gamma = 1.4;

// p = c^2 rho / gamma and e = p / ((gamma - 1) rho) of a gas with c = rho = 1.
inline constexpr double gas_pressure = 1 / gas_gamma, gas_energy = gas_pressure / (gas_gamma - 1);

// Which side of the artificial viscosity's switch is examined: that of the settings' own, as it is; of a gas that closes,
// where its linear part acts always; of one that opens, where it never does.
enum class Side { both, closing, opening };

// The material, with the artificial viscosity of the settings. viscosity: mu / (rho c h), >= 0. The quadratic part has
// neither value nor slope where div v = 0, and is left out unless wanted: what differences of finite size make of it would
// not be small beside what a limit is judged by. On a line the linear part of a gas that closes is a physical viscosity,
// 4/3 mu = c_L rho c h: Side::closing puts that in its place.
std::shared_ptr<const IdealGas> gas_material(const Settings& settings, double viscosity, Side side, bool quadratic);

// Gives a point of gas at rest its mass, volume, density and energy. volume: in h^dim (axisymmetric: per radian).
void put_gas(Columns& points, std::size_t p, double volume);

struct GasLattice {
  int dim = 1;             // 1 or 2: `ppc` points a cell on a line, round(sqrt(ppc)) a cell and direction in the plane
  double offset = 0;       // of the lattice to the grid, in cells, [0, 1)
  double compression = 0;  // -h/c dv_d/dx_d in each direction; the middle of the patch is at rest
  double viscosity = 0;    // mu / (rho c h)
  Side side = Side::both;
};

// Settings: all keys of gases but for those of runs. The lattice fills the grid between mirrors. One that moves has further periods beyond the margin, where its velocity falls to zero.
Patch gas_patch(const Settings& settings, const GasLattice& lattice, const Extent& extent);

}  // namespace plumbline
