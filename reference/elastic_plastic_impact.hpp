#pragma once
// A piston is pushed against an elastoplastic half-space in uniaxial strain: von Mises's yield condition, linear isotropic
// hardening, small strains. The stress is then a piecewise linear function of the strain as long as the strain grows, with the
// moduli
//   M = K + 4 G/3 up to the stress s_H = Y M/(2 G),  M_p = K + (4 G/3) H/(3 G + H) beyond it,
// so that each part of the piston's velocity runs into the body at a speed of its own,
//   v = v_e(t - x/c_e) + v_p(t - x/c_p),  v_e = min(V, s_H/(rho c_e)),  v_p = V - v_e,
//   stress = -(rho c_e v_e + rho c_p v_p),  plastic strain = 2 G/(3 G + H) v_p/c_p.
// Exact until an unloading wave, as from a free end, meets these; x is the place of a particle in the undeformed body,
// tension is positive. Sources: D. S. Wood, J. Appl. Mech. 19 (1952) 521; Wang Li-Li, Foundations of Stress Waves, 2007.
#include "reference/bounded.hpp"

namespace plumbline::reference {

/// Any consistent units; all > 0, but -1 < poissons_ratio < 1/2, hardening_modulus >= 0, rise_time >= 0.
struct ElasticPlasticImpactProblem {
  double youngs_modulus = 1e5;
  double poissons_ratio = 0.25;
  double density = 1;
  double yield_stress = 1;
  double hardening_modulus = 2e4;  // H: of the yield stress over the equivalent plastic strain
  double velocity = 0.012;         // of the piston, from rise_time on
  double rise_time = 0;            // over which it grows from zero in proportion to the time
};

struct ElasticPlasticState {
  Bounded velocity, stress, lateral_stress, plastic_strain;
};

class ElasticPlasticImpact {
 public:
  /// Throws ParameterError with the key of a value out of range.
  explicit ElasticPlasticImpact(const ElasticPlasticImpactProblem& problem);

  const ElasticPlasticImpactProblem& problem() const { return problem_; }
  Bounded elastic_speed() const { return elastic_speed_; }
  Bounded plastic_speed() const { return plastic_speed_; }
  Bounded elastic_limit() const { return limit_; }            // s_H, of the axial stress, > 0
  Bounded limit_velocity() const { return limit_velocity_; }  // s_H/(rho c_e)
  ElasticPlasticState precursor() const;                      // between the fronts
  ElasticPlasticState plateau() const;                        // at the piston, once it has its velocity
  Bounded strain() const;  // compression there: what small strains leave out, relative
  /// position, time >= 0. At a jump the value ahead of it; where rounding leaves its side open, the bounds cover both.
  ElasticPlasticState state(Bounded position, Bounded time) const;
  /// Heat by plastic flow per area of the piston, Y times the plastic strain of all particles; time >= 0.
  Bounded heat(Bounded time) const;

 private:
  Bounded driven(Bounded time) const;  // V
  ElasticPlasticState of_parts(Bounded elastic, Bounded plastic) const;

  ElasticPlasticImpactProblem problem_;
  Bounded shear_, elastic_speed_, plastic_speed_, limit_, limit_velocity_;
  Bounded elastic_part_, plastic_part_;  // of the piston's velocity
  Bounded flow_;                         // plastic strain over the strain beyond the limit
};

}  // namespace plumbline::reference
