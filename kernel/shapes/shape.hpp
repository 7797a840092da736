// Shape functions by name: each registers itself in its own source file, with its traits and the loops compiled for it.
#pragma once

#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "kernel/choice.hpp"
#include "kernel/geometry.hpp"
#include "kernel/grid_spec.hpp"
#include "kernel/transfers/transfer.hpp"

namespace plumbline {

template <class Geometry>
class PointLoops;

template <class Geometry>
using MakeLoops = std::unique_ptr<PointLoops<Geometry>> (*)(const GridSpec&, const Transfer&);

struct ShapeEntry : Choice {
  static constexpr const char* kind = "shape";
  std::tuple<MakeLoops<Line>, MakeLoops<Plane>, MakeLoops<Axisymmetric>, MakeLoops<Solid>> loops;
  double inertia = 0;  // D_p / h^2 where a point stands on a node, the same anywhere if constant_inertia is offered
  bool boxes = false;  // points have half sizes
  bool boxes_deform = false;      // which follow the deformation
  bool domain_gradients = false;  // gradients are means over the points' domains, not derivatives of the values
  bool at_start = false;          // weights are those of the places where the points stood at the start: of solids
  bool flows = false;             // the integrals of its kernels are known [Pressure 4]
  int lanes = 1;                  // how many values its loops read side by side
};

// In the order of their names.
const std::vector<ShapeEntry>& shapes();

// Throws std::invalid_argument for an unknown name.
const ShapeEntry& shape_named(const std::string& name);

// Whether a shape is known and offers a trait.
bool shape_offers(const std::string& shape, Trait trait);

// Takes one in: RegisterPart.
void add_part(ShapeEntry entry);

}  // namespace plumbline
