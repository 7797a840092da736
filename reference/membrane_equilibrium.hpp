#pragma once
// The end of an expansion: gas at rest in a closed membrane, quarter of a doubly symmetric bag (York, section 6.2).
// Derived here. Per depth out of the plane, E' = E/(1 - nu^2) [York 5.12], w = E' t L with L the quarter's unstretched
// length, Lambda its stretched one, T the tension, p A = (gamma - 1) U for the gas of energy U in the quarter's area A.
//
// At rest the work of a small change vanishes: p dA/dR = dW/dR = T dLambda/dR. Whatever the shape, if it grows without
// changing, A goes as R^2 and Lambda as R: 2 p A = T Lambda (the virial identity; p R = T on the circle). Two shapes:
// the circle, A = pi R^2/4, Lambda = pi R/2, and n equal straight chords with their vertices on the radius R at the
// angles k theta, theta = pi/(2 n): A = n R^2 sin(theta)/2, Lambda = 2 n R sin(theta/2), each vertex in equilibrium.
// First law: U = U_0 - lost - W, all that is not lost heats the gas. With b = 2 (gamma - 1) (U_0 - lost)/w:
//   segments     eps = Lambda/L - 1, T = E' t eps, W = w eps^2/2:                gamma eps^2 + eps = b,
//   accumulated  eps = ln(Lambda/L) (sum of dLambda/Lambda) in points of constant volume V = t L:
//                T = E' eps V/Lambda, W = w eps^2/2:                     (gamma - 1) eps^2 + eps = b.
// eps and stress are the same for every shape; radius and pressure are not. The virial identity gives stress V =
// 2 (gamma - 1) U for the accumulated law, and stress V (1 + eps) for segments (the stress is T/t: tension per
// unstretched thickness). Without losses to heat the gas keeps p A^gamma instead: `isentropic`.
//
// Breathing about the end, shape unchanged, all mass M of the membrane at the vertices (on the circle: anywhere), the
// gas a spring without mass (p = -gamma p dA/A):  M w^2 = d2W/dR2 - 2 p C + 4 gamma p C,  A = C R^2.
#include "reference/bounded.hpp"

namespace plumbline::reference {

enum class MembraneLaw { segments, accumulated };

/// SI units, per depth, all of the quarter. All positive but lost in [0, gas_energy); gamma > 1, |nu| < 1/2.
/// Defaults: York's input, 600 points of the volume 0.05^2/6.8207.
struct MembraneEquilibriumProblem {
  double gas_energy = 0.47463 * 250;  // U_0 at the start, J/m
  double gas_area = 0.47463;          // A at the start, m^2; for the isentropic end alone
  double gamma = 1.4;
  double length = 2.19919;      // L, unstretched, m
  double youngs_modulus = 1e6;  // E, Pa
  double poisson_ratio = 0.3;   // nu
  double thickness = 0.1;       // t, unstretched, m
  double density = 0.5;         // of the unstretched membrane, kg/m^3
  double lost = 0;              // energy that heats nothing, J/m
  MembraneLaw law = MembraneLaw::segments;
};

struct MembraneState {
  Bounded strain;            // eps
  Bounded length;            // Lambda, of the quarter, m
  Bounded radius;            // of the circle, or of the vertices, m
  Bounded apothem;           // of the circle, or of the middles of the chords, m
  Bounded area;              // A, of the quarter, m^2
  Bounded pressure;          // p, Pa
  Bounded tension;           // T, N/m
  Bounded stress;            // E' eps, Pa
  Bounded gas_energy;        // U, J/m
  Bounded membrane_energy;   // W, J/m
  Bounded dry_omega;         // of breathing without gas, rad/s; 0 where the tension makes it unstable
  Bounded breathing_omega;   // with the gas as a spring, rad/s
  Bounded breathing_period;  // s
};

/// `segments` is the number n of chords on the quarter, 1 to 1e6, or 0 for the circle: ParameterError "segments".
class MembraneEquilibrium {
 public:
  /// Throws ParameterError with the key.
  explicit MembraneEquilibrium(const MembraneEquilibriumProblem& problem);

  Bounded plane_modulus() const { return modulus_; }  // E', Pa
  Bounded membrane_volume() const;                    // V = t L, m^2
  Bounded membrane_mass() const;                      // M, kg/m
  MembraneState state(int segments = 0) const;        // all motion has become heat
  MembraneState isentropic(int segments = 0) const;   // the gas has not been heated by the motion
  /// 2 (gamma - 1) U/V: no mean hoop stress over the constant volume V can be above it at rest.
  Bounded virial_stress() const;

 private:
  MembraneState state_at(Bounded strain, int segments) const;
  Bounded stretched(Bounded strain) const;

  MembraneEquilibriumProblem problem_;
  Bounded modulus_, elastic_;  // E', w
};

}  // namespace plumbline::reference
