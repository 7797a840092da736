#pragma once
// Gas by FLIP in the plane, the method that York compares the material point method with (section 4.2): particles carry
// mass, velocity and specific internal energy, the equation of state is evaluated in cells and forces act at vertices
// (J. U. Brackbill, H. M. Ruppel, J. Comput. Phys. 65 (1986) 314). Of what York leaves open this takes the simplest:
// bilinear shapes at vertices, quadratic B-splines at cell centres for mass and energy (his "higher order
// interpolation", p. 37), pressure at the start of a step (explicit) or, adiabatic and linear in the divergence, at its
// end (implicit).
#include <array>
#include <vector>

namespace plumbline::reference {

struct FlipPoint {
  std::array<double, 2> place, velocity;
  double mass = 0, energy = 0;  // energy: specific internal
};

/// A square box of cells * cells with sides of length h from the origin on, all four sides planes of symmetry. Any
/// consistent units.
struct FlipGas {
  int cells = 40;         // along each side, > 1
  double h = 0.025;       // > 0
  double gamma = 1.4;     // > 1
  double step = 0;        // > 0; the last one is shortened to end at end_time
  double end_time = 0;    // >= 0
  bool implicit = false;  // pressure at the end of the step
};

/// At the end: the points in their order, and the pressure of the cells, row by row from the origin.
struct FlipState {
  std::vector<FlipPoint> points;
  std::vector<double> pressure;
};

/// The work of the pressure at the vertices is what the cells lose, but for rounding; what the maps smooth of the
/// points' velocities is lost. A point that would leave the box stays on its side. Throws ParameterError (`cells`, `h`,
/// `gamma`, `step`, `end_time`), or std::runtime_error if the linear system of an implicit step is not solved.
FlipState flip_gas(const FlipGas& gas, std::vector<FlipPoint> points);

}  // namespace plumbline::reference
