// What a scene contains of that which the stability problems are about.
#pragma once

#include <string>
#include <vector>

#include "kernel/scene.hpp"

namespace plumbline {

struct SceneContents {
  // More points a cell change limits by less than 3 %, and cost much.
  static constexpr int most_per_cell = 3;

  enum class Matter { gas, solid, chain };  // chain: a string or membrane, its points joined to a line

  struct Part {
    std::string body;
    Matter matter = Matter::solid;
    // Points a cell and direction, a chain's along itself, where they stand least densely: 1 to most_per_cell.
    int per_cell = 1;
    double speed = 0;        // of its fastest wave, m/s
    double diffusivity = 0;  // of a viscous gas, 4/3 mu/rho, m^2/s
    bool segments = false;   // of a chain: strain is the stretch between neighbouring points
    bool free_edge =
        false;  // beside it are nodes that nothing else keeps heavy: neither a wall or piston nor another body
  };

  // A chain among gas, on the same nodes.
  struct Coupling {
    Part gas, chain;
    double density_ratio = 1;    // mass of the chain in a cell that it crosses over that of the gas that fills it
    double stiffness_ratio = 1;  // the same of mass times squared speed of waves
  };

  int dim = 1;
  bool axisymmetric = false;
  double h = 1;          // m
  bool contact = false;  // bodies have velocity fields of their own and push each other
  std::vector<Part> parts;
  std::vector<Coupling> couplings;

  std::vector<Part> of(Matter matter) const;
};

// As the scene stands. Bodies without points are left out.
SceneContents contents_of(const Scene& scene);

}  // namespace plumbline
