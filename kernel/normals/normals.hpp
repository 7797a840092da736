// Normals of a membrane: one layer of points in the plane. [York chapter 7]
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "kernel/grid.hpp"
#include "kernel/scene.hpp"

namespace plumbline {

// What a method may look at. Arrays of one group have one length; positions in m, inside the grid.
struct NormalsInput {
  const GridSpec& grid;                            // dim = 2; points have mirror images in its symmetry walls
  std::span<const double> x, y;                    // of the membrane's points
  std::span<const double> other_x, other_y;        // of other points that carry colour: the gas inside; may be empty
  std::span<const double> previous_x, previous_y;  // the last normals, for points without neighbours; may be empty
  bool closed = false;  // `connectivity` alone: points stand in order, and the last is joined to the first
};

// One way to find them. Keeps its work space between calls; one object serves one thread at a time.
class NormalsMethod {
 public:
  virtual ~NormalsMethod() = default;
  // Whether it looks at NormalsInput::other_x and other_y.
  virtual bool sees_others() const { return false; }
  // Unit normals of the membrane's points, of either sign. Where the method has no direction (no neighbours, no gradient)
  // the previous normal stays, or (0, 0) without one. The output may be the previous normals themselves.
  virtual void find(const NormalsInput& input, std::span<double> normal_x, std::span<double> normal_y) = 0;
};

//   connectivity                   mean of the two adjoining segments' angles                    [York 7.1]
//   york-simple                    gradient of the points' colour by linear shapes               [York 7.2, 7.3]
//   york-quadratic                 the same of a colour smoothed to cell centres                 [York 7.4, 7.5]
//   york-cubic                     gradient of a colour smoothed by cubic splines                [York 7.6, 7.7]
//   york-mass-matrix               colours of a cell's nodes that are one on its points          [York 7.8-7.12]
//   york-mass-matrix-kept          the same; a point alone in its cell keeps the normal it had   [York section 7.8]
//   york-mass-matrix-quadratic     the mass matrix with nine colours and quadratic shapes        [York 7.18, 7.19]
//   modern                         circle fitted to the points nearby; needs no order of points  [Circle 1-3]
const std::vector<Choice>& normals_methods();

// Throws std::out_of_range for a name that is not among them.
std::unique_ptr<NormalsMethod> make_normals(const std::string& name);

}  // namespace plumbline
