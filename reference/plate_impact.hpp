#pragma once
// A thick plate of an elastoplastic solid strikes a rigid frictionless wall face on, at finite strains: Hencky's law, von Mises's yield
// condition, linear isotropic hardening. With e = -ln of the axial stretch and m = e at the yield stress, m = Y/(2 G), the axial
// stress -p of uniaxial strain that grows is
//   p(e) = e^e (K e + 2/3 q),  q = 2 G e up to m, else Y + H alpha,  alpha = (2 G e - Y)/(3 G + H)       [Hencky 1]
// (lateral stretches are 1: Cauchy's axial stress is the first Piola-Kirchhoff one). Along the stretch p is convex but at m, where it
// gets softer: an elastic shock runs ahead, a slower plastic one behind it, and their jumps are, with U of the undeformed plate,
//   rho U [v] = [p],  U [e^-e] = -[v], so rho [v]^2 = [p] [-e^-e]                                          [Hencky 2]
// Heat changes no stress. Sources: D. S. Wood, J. Appl. Mech. 19 (1952) 521, for small strains; the conditions at jumps: Wang Li-Li,
// Foundations of Stress Waves, 2007; the law: J. C. Simo, doi 10.1016/0045-7825(92)90123-2.
#include "reference/bounded.hpp"

namespace plumbline::reference {

/// Any consistent units; all > 0, but -1 < poissons_ratio < 1/2, hardening_modulus >= 0.
struct PlateImpactProblem {
  double youngs_modulus = 117e9;
  double poissons_ratio = 0.35;
  double density = 8930;
  double yield_stress = 400e6;
  double hardening_modulus = 100e6;  // H: of the yield stress over the equivalent plastic strain
  double velocity = 227;             // of the plate, towards the wall
};

/// Behind a shock. speed: of the shock, of places in the undeformed plate; velocity: what the plate has lost there.
struct PlateState {
  Bounded stretch, stress, lateral_stress, plastic_strain, velocity, speed;
};

class PlateImpact {
 public:
  /// Throws ParameterError with the key of a value out of range, also of a velocity so high that the plastic shock is the faster one.
  explicit PlateImpact(const PlateImpactProblem& problem);

  const PlateImpactProblem& problem() const { return problem_; }
  /// Between the shocks; where the plate does not yield, all of it.
  const PlateState& precursor() const { return precursor_; }
  const PlateState& plateau() const { return plateau_; }  // at the wall
  Bounded elastic_speed() const { return precursor_.speed; }
  Bounded plastic_speed() const { return plateau_.speed; }
  /// place, in the undeformed plate from the face that strikes, and time since then, >= 0. At a shock the state ahead of it; where
  /// rounding leaves its side open, the bounds cover both. Exact until a wave comes back from the other face.
  PlateState state(Bounded place, Bounded time) const;

 private:
  Bounded pressure(Bounded strain) const;                         // p(e)
  Bounded square(const PlateState& ahead, Bounded strain) const;  // of the jump of the velocity
  PlateState struck(const PlateState& ahead, Bounded strain) const;
  PlateState behind(const PlateState& ahead, double low, double loss) const;

  PlateImpactProblem problem_;
  Bounded bulk_, shear_, limit_;  // limit_: m
  PlateState precursor_, plateau_;
};

}  // namespace plumbline::reference
