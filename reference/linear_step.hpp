#pragma once
// One step of the material-point method on frozen places, written down as a matrix: every quantity of the step is a
// matrix that gives it from the state at its start.
#include "reference/dense.hpp"
#include "reference/mpm_amplification.hpp"

namespace plumbline::reference {

/// Rows are points, columns nodes: weights, gradients, weights times arms, and the weights that give C_p; the inverse
/// of the nodal masses and the sharpening Q, nodes by nodes. `mass` is that of each point, and its volume.
template <class Number>
struct GridMaps {
  Dense<Number> weight, gradient, arm, affine, inverse_mass, sharpen;
  double mass = 1;
};

template <class Number>
class LinearStep {
 public:
  LinearStep(const MapScheme& scheme, const GridMaps<Number>& maps, double courant)
      : scheme_(scheme),
        maps_(maps),
        dt_(courant),
        points_(maps.weight.rows),
        affine_(scheme.transfer == GridTransfer::apic) {
    const int size = points_ * (affine_ ? 3 : 2);
    velocity_ = selection<Number>(points_, size, 0);
    if (affine_) slope_ = selection<Number>(points_, size, points_);
    strain_ = selection<Number>(points_, size, size - points_);
  }

  Square<Number> matrix() {
    const bool halves = scheme_.update == StressUpdate::averaged;
    const Dense<Number> start = mapped();
    if (scheme_.update == StressUpdate::first || halves) strain(start, halves ? dt_ / 2 : dt_);
    const Dense<Number> change = dt_ * acceleration(), end = start + change;
    take(start, change);
    if (scheme_.update == StressUpdate::last) strain(end, dt_);
    if (scheme_.update == StressUpdate::modified_last || halves) strain(mapped(), halves ? dt_ / 2 : dt_);
    return whole();
  }

 private:
  Dense<Number> to_nodes(const Dense<Number>& rows, const Dense<Number>& of_points) const {
    return maps_.inverse_mass * (maps_.mass * (adjoint(rows) * of_points));
  }
  Dense<Number> mapped() const {  // [York 3.16]
    const Dense<Number> plain = to_nodes(maps_.weight, velocity_);
    return affine_ ? plain + to_nodes(maps_.arm, slope_) : plain;
  }
  Dense<Number> acceleration() const {  // [York 3.17, 3.19]
    return maps_.sharpen * (-1.0 * to_nodes(maps_.gradient, strain_));
  }
  void strain(const Dense<Number>& nodal, double dt) {  // [York 3.23]
    strain_ = strain_ + dt * (maps_.gradient * (maps_.sharpen * nodal));
  }
  // sum_{j < m} (1 - P)^j w
  Dense<Number> filtered(const Dense<Number>& nodal) const {
    Dense<Number> left = nodal, sum = nodal;
    for (int j = 1; j < scheme_.order; ++j) {
      left = left - to_nodes(maps_.weight, maps_.weight * left);
      sum = sum + left;
    }
    return sum;
  }
  void take(const Dense<Number>& start, const Dense<Number>& change) {
    const Dense<Number> end = start + change;
    if (affine_) slope_ = maps_.affine * end;
    switch (scheme_.transfer) {
      case GridTransfer::flip:
        velocity_ = velocity_ + maps_.weight * change;
        break;  // [York 3.22]
      case GridTransfer::xpic:
        velocity_ = maps_.weight * (filtered(start) + change);
        break;
      case GridTransfer::fmpm:
        velocity_ = maps_.weight * filtered(end);
        break;
      default:
        velocity_ = maps_.weight * end;
    }
  }
  Square<Number> whole() const {
    Square<Number> all(strain_.columns);
    all.entries.clear();
    for (const Dense<Number>* part : {&velocity_, &slope_, &strain_}) {
      all.entries.insert(all.entries.end(), part->entries.begin(), part->entries.end());
    }
    return all;
  }

  const MapScheme& scheme_;
  const GridMaps<Number>& maps_;
  double dt_;
  int points_;
  bool affine_;
  Dense<Number> velocity_, slope_, strain_;
};

}  // namespace plumbline::reference
