// Where the points of one body stand on the grid, as locate_points() finds it. Every later stage of the step reads these
// places and none the positions, so that masses and weights never come from different instants.
#pragma once

#include <array>
#include <vector>

#include "kernel/bins.hpp"
#include "kernel/pack.hpp"
#include "kernel/points/columns.hpp"
#include "kernel/shapes/reference_columns.hpp"

namespace plumbline {

// What the weights of points are functions of.
template <int dim>
struct Places {
  const double *x[dim] = {}, *half_size[dim] = {};  // half sizes of boxes: null where the shape has none
};

template <int dim>
struct Weights {
  Bins bins;
  bool bins_hold = false;  // the points are in the order of the bins, each sorted by id

  // Whether the places are at hand.
  bool known() const { return known_; }
  // They are the positions, whatever they were.
  void release() {
    known_ = true;
    kept_ = false;
  }
  // To be called before a stage moves points that later stages may follow: from then on the places are copies. Calling it
  // again changes nothing.
  void keep(const Columns& points) {
    if (kept_) return;
    for (int d = 0; d < dim; ++d) {
      const double* x = points(column::position, d);
      copies_[static_cast<std::size_t>(d)].assign(x, x + points.points() + lanes - 1);
    }
    kept_ = true;
  }
  bool kept() const { return kept_; }
  // To be called when positions change otherwise: only copies stay.
  void positions_changed() { known_ = known_ && kept_; }
  // None of the stages that follow may use them.
  void drop() { known_ = false; }

  Places<dim> places(const Columns& points, bool boxes) const {
    Places<dim> places;
    for (int d = 0; d < dim; ++d) {
      const bool copied = kept_ && !points.has(column::position_at_start);
      places.x[d] = copied ? copies_[static_cast<std::size_t>(d)].data() : place_of_weights(points, d);
      if (boxes) places.half_size[d] = points(column::half_size, d);
    }
    return places;
  }

 private:
  std::array<std::vector<double>, dim> copies_;
  bool known_ = false, kept_ = false;
};

}  // namespace plumbline
