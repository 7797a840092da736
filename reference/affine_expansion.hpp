#pragma once
// A slab, cylinder or sphere of gas that expands into a vacuum with a velocity linear in the radius: density goes as
// (1 - xi^2)^(1/(gamma - 1)), pressure as (1 - xi^2)^(gamma/(gamma - 1)), u = R' xi, xi = r/R(t), and the edge obeys
//   R'' = 2 gamma/(gamma - 1) (p_c/rho_c) (R0/R)^(d (gamma - 1)) / R.
// Source: the affine motions of L. V. Ovsiannikov, Dokl. Akad. Nauk SSSR 111 (1956) 47, and F. J. Dyson, J. Math.
// Mech. 18 (1968) 91; L. I. Sedov, Similarity and Dimensional Methods in Mechanics, 1959, chapter IV.
#include "reference/gas_flow.hpp"

namespace plumbline::reference {

/// Any consistent units. At t = 0 the gas is at rest.
struct AffineExpansionProblem {
  int dimension = 2;     // 1: slab, 2: cylinder, 3: sphere
  double radius = 0.38;  // of the edge at t = 0; half the thickness of a slab
  double density = 1;    // at the centre at t = 0
  double pressure = 100;
  double gamma = 1.4;
};

/// The gas at one time.
class AffineGas {
 public:
  Bounded radius() const { return radius_; }
  Bounded edge_speed() const { return edge_speed_; }
  const Sample& centre() const { return centre_; }
  /// r >= 0. Beyond the edge density, pressure and energy are 0 and the velocity is that of the edge.
  Sample sample(double r) const;

 private:
  friend class AffineExpansion;
  Bounded gamma_, radius_, edge_speed_;
  Sample centre_;
};

class AffineExpansion {
 public:
  /// Throws ParameterError with the key of a value out of range.
  explicit AffineExpansion(const AffineExpansionProblem& problem);

  const AffineExpansionProblem& problem() const { return problem_; }
  AffineGas at(double time) const;  // time >= 0; about 50 us
  Bounded radius(double time) const { return at(time).radius(); }
  Bounded edge_speed(double time) const { return at(time).edge_speed(); }
  Bounded final_speed() const { return final_speed_; }  // of the edge as t grows without limit
  Sample sample(double r, double time) const { return at(time).sample(r); }

  Bounded mass() const;    // of the whole gas: both halves of a slab (per area), cylinder (per length), sphere
  Bounded energy() const;  // of the whole gas, kinetic and internal

 private:
  Bounded log_growth(double time) const;
  Bounded elapsed(double root) const;

  AffineExpansionProblem problem_;
  Bounded gamma_;
  Bounded n_;  // d (gamma - 1)
  Bounded final_speed_;
};

}  // namespace plumbline::reference
