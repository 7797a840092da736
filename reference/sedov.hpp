#pragma once
// Point, line or plane explosion of a given energy in a uniform cold gas: the similarity solution of Sedov, von Neumann
// and Taylor in its standard branch. Source: L. I. Sedov, Similarity and Dimensional Methods in Mechanics, 1959,
// chapter IV; J. R. Kamm, F. X. Timmes, On Efficient Generation of Numerically Robust Sedov Solutions, LA-UR-07-2849,
// 2007.
#include "reference/gas_flow.hpp"

namespace plumbline::reference {

/// Any consistent units. `energy` is of the whole flow: both sides of a plane (per area; Kamm and Timmes count
/// one side), per length of a line, of a point.
struct SedovProblem {
  int dimension = 3;   // 1: plane, 2: line, 3: point
  double gamma = 1.4;  // below 7 for dimension 3
  double density = 1;
  double energy = 0.851072;
};

/// The profile behind the shock as functions of theta in [0, 1], 0 at the centre, 1 at the shock. With the variable V
/// of Kamm and Timmes (V = t/r times u) theta = (V - V_0)/(V_2 - V_0), and their x1 ... x4 are sums of positive terms.
class SedovProfile {
 public:
  SedovProfile(int dimension, double gamma);

  /// All in units of the value behind the shock; `velocity` over `radius` is `x1`.
  struct State {
    Bounded radius, x1, density, pressure, energy;
  };
  /// `start` = theta^kappa with radius = start * (regular), kappa = (gamma - 1)/(2 (gamma - 1) + d).
  State at(Bounded start) const;
  Bounded radius(Bounded start) const;
  Bounded stretch(Bounded start) const;    // d log radius / d log start
  Bounded start_of(Bounded radius) const;  // inverse of radius, for true radius in [0, 1]

 private:
  struct Factors {
    Bounded theta, x1, x3, x4;
  };
  Factors factors(Bounded start) const;

  int d_;
  Bounded gamma_, kappa_, a0_, a1_, a3_, slope1_, slope3_, slope4_, power3_, gap_, two_minus_gamma_;
};

class Sedov {
 public:
  /// Throws ParameterError with the key of a value out of range.
  explicit Sedov(const SedovProblem& problem);

  const SedovProblem& problem() const { return problem_; }
  Bounded alpha() const { return alpha_; }  // energy = alpha density R^(d + 2)/t^2
  Bounded shock_radius(double time) const;  // time > 0 for all of these
  Bounded shock_speed(double time) const;
  double time_of_radius(double radius) const;  // when the shock is there; rounded
  Sample behind(double time) const;            // just behind the shock
  /// radius >= 0; at the shock the value ahead of it. At the centre the density is zero and the energy infinite.
  Sample sample(double radius, double time) const;

 private:
  SedovProblem problem_;
  SedovProfile profile_;
  Bounded alpha_;
};

}  // namespace plumbline::reference
