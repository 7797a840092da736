// The flow on which `bench` times a step: a gas between frictionless walls with shear, compression, density waves and a
// jump of energy, from which shocks and a contact grow.
#pragma once

#include <string>

#include "kernel/scene.hpp"

namespace plumbline {

struct BenchFlow {
  int dimension = 2;          // 1, 2 or 3
  bool axisymmetric = false;  // with dimension 2
  std::string shape = "quadratic", transfer = "apic", integrator = "leapfrog";
  long points = 1000000;  // about so many: whole cells

  int ppc() const;    // points per cell: 8 on a line, 16 in the plane, 8 in space
  int cells() const;  // along each direction of the unit square (line, cube)
  std::string name() const;
  // Whether the integrator works with shape and transfer.
  bool is_possible() const;
};

// The default gas scheme's sharpening, heat exchange and artificial viscosity; none of the first two where the transfer
// keeps what its maps filter out. Points stand on a regular lattice, their masses follow the density.
Scene flow_scene(const BenchFlow& flow);

}  // namespace plumbline
