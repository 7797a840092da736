// A gas-filled elastic ring at rest, as polygons have it: the quarter of it, and its breathing modes.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "cases/catalog/coupled/membrane.hpp"
#include "cases/catalog/coupled/radial_mode.hpp"
#include "cases/harness/description/parameters.hpp"
#include "cases/harness/description/schemes.hpp"
#include "kernel/scene.hpp"
#include "reference/gas_ring.hpp"

namespace plumbline {

// The parameters of every case of a ring. cells counts cells along the radius.
struct RingParameters : Parameters {
  reference::GasRingProblem problem;
  bool cut = true;  // whether the gas's points along the ring are cut by it
  RingParameters() { read(); }
  explicit RingParameters(const Settings& settings);

 private:
  void read();
};
reference::GasRingProblem ring_problem(const Settings& settings);

// Case::york_step: the Courant number of his bag, for waves along a bar of the ring's material. [York A.4]
Override york_ring_step(const Settings& settings);

// Case::levels.
inline const std::vector<double> ring_levels{8, 10, 13, 17, 22};

// A quarter ring of n equal chords, in equilibrium with the gas it encloses; its vertices stand on the radius R.
// The gas pushes each vertex with p l cos(theta/2), l the length of a chord and theta the angle between two; the chords
// pull it back with 2 T sin(theta/2). So T = p R cos(theta/2), pressure times apothem: the virial identity
// T sum l = 2 p A = 2 (gamma - 1) U of the polygon. Its strain, T/(E' t), gives the rest lengths; gas_energy is
// U = p A/(gamma - 1) with the polygon's own A. Shares of h^2 by which circle and polygon differ move nothing.
struct RestingRing {
  Curve curve;  // n + 1 vertices, from the axis y = 0 to x = 0, counter-clockwise
  MembraneMaterial material;
  double strain = 0;      // of every chord
  double apothem = 0;     // m
  double area = 0;        // of the quarter, m^2
  double gas_energy = 0;  // e, J/kg
};
RestingRing resting_ring(const reference::GasRingProblem& problem, int chords, bool segments);
RestingRing resting_ring(const Settings& settings);  // of the problem posed, with chords of h / membrane.ppc

// Gas at rest inside a convex polygon, counter-clockwise: one point at the centroid of each cell of a lattice of the
// spacing a = h / sqrt(ppc), as far as the cell is inside, with the mass of that part. Area and first moments are
// exact, those of the cells at the edge too: a uniform pressure pushes each node as the polygon's edge does, but for a
// share of the order (a/h)^2.
Body fill_cut(const std::string& name, std::shared_ptr<const IdealGas> gas, const GridSpec& grid, int ppc,
              const Curve& polygon, double density, double energy);

// The part of a convex polygon where a x + b y <= c. Counter-clockwise stays so; may be empty.
Curve cut(const Curve& polygon, double a, double b, double c);
std::array<double, 2> centroid(const Curve& polygon);  // of an area above 0

// Grid, gas and ring at rest: bodies "gas" and "ring", the schemes' choices applied.
Scene ring_scene(const Settings& settings, const RestingRing& ring);

// A mode of breathing: J1(k r)/J1(k R).
RadialMode ring_mode(const reference::GasRing& exact, int mode, double radius);

}  // namespace plumbline
