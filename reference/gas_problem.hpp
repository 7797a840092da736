#pragma once
// Initial value problems of an ideal gas with one coordinate, for the two numerical solvers (finite_volume.hpp,
// lagrangian_gas.hpp). Any consistent units.
#include <functional>
#include <vector>

#include "reference/gas.hpp"
#include "reference/riemann.hpp"

namespace plumbline::reference {

/// outflow: the gas goes on beyond the end as it is there; vacuum: a free surface (Lagrangian solver only).
enum class GasBoundary { reflecting, outflow, vacuum };

struct GasProblem {
  double low = 0, high = 1;  // ends of the gas at t = 0; radii >= 0 if dimension > 1
  GasBoundary left = GasBoundary::outflow, right = GasBoundary::outflow;
  double gamma = 1.4;  // > 1
  double end_time = 0;
  int dimension = 1;                        // 1 planar, 2 cylinder, 3 sphere (2 and 3: Lagrangian solver only)
  std::function<GasState(double)> initial;  // at x in [low, high]; density > 0, pressure >= 0
  std::vector<double> jumps;                // where `initial` jumps
  bool isentropic = false;                  // no shock arises: p/rho^gamma stays with the gas (Lagrangian solver only)
};

/// Volume of the shell between two edges: their distance in the plane, by radian in a cylinder, by steradian in a
/// sphere.
double shell_volume(double inner, double outer, int dimension);

/// Means over the shell [inner, outer] of density, momentum and energy, as the state that has them: exact up to the
/// sixth-order quadrature of the smooth pieces between the jumps.
GasState mean_state(const GasProblem& problem, double inner, double outer);

/// Throws ParameterError (`gamma`, `end_time`, `low`, `high`, `dimension`) for numbers that make no problem.
void check_problem(const GasProblem& problem);

/// Two gases parted at `diaphragm`.
GasProblem riemann_tube(const RiemannProblem& riemann, double diaphragm, double end_time, double low = 0,
                        double high = 1, GasBoundary ends = GasBoundary::outflow);

/// A shock of Mach 3 runs into a density wave, [-5, 5], t = 1.8: C.-W. Shu, S. Osher, J. Comput. Phys. 83 (1989) 32,
/// example 8.
GasProblem shu_osher_problem();

/// Two blast waves between walls, [0, 1], t = 0.038: P. Woodward, P. Colella, J. Comput. Phys. 54 (1984) 115.
GasProblem woodward_colella_problem();

/// A cylinder (dimension 2) of gas at rest, density 1, pressure 100, gamma 1.4, into vacuum: York, section 4.2.
GasProblem gas_expansion_problem(double radius = 0.38, double end_time = 0.005, int dimension = 2);

/// One number for each field; `energy` is specific internal energy.
struct GasFields {
  double density = 0, velocity = 0, pressure = 0, energy = 0;
};

}  // namespace plumbline::reference
