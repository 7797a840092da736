#pragma once
// Largest stable steps w dt of time integrators on the linear oscillator u'' = -w^2 u, and their orders. One step is a
// matrix, which is given, too: the limits are where its spectral radius passes 1.
#include "reference/bounded.hpp"
#include "reference/spectral_radius.hpp"

namespace plumbline::reference {

enum class OscillatorMethod {
  forward_euler,      // grows at every step: limit 0
  explicit_midpoint,  // = Heun on a linear problem, |R|^2 = 1 + (w dt)^4/4: limit 0
  symplectic_euler,   // velocity first, then the place with the new one: USF and MUSL on a frozen stiffness
  leapfrog,           // = velocity Verlet = central differences = Newmark (0, 1/2)
  ssp_rk3,            // Shu and Osher, doi 10.1016/0021-9991(88)90177-5; on a linear problem as any RK3
  rk4,                // the classical Runge-Kutta method
  newmark_trapezoid,  // Newmark (1/4, 1/2) = implicit midpoint: no limit
  newmark_linear,     // Newmark (1/6, 1/2), linear acceleration
  generalized_alpha   // explicit, with a chosen dissipation; below
};

/// Largest stable w dt; infinite where there is none, 0 where every step grows. [Oscillator 1] rho_b is that of
/// generalized_alpha, the others do not look at it. Throws ParameterError with the key `rho_b`.
Bounded oscillator_limit(OscillatorMethod method, double rho_b = 1);

/// Order of the solution at a fixed time.
int oscillator_order(OscillatorMethod method);

/// One step of w dt >= 0 on (u, u'/w), of generalized_alpha on (u, dt u', dt^2 u''). Throws ParameterError with the key
/// `omega_dt` or `rho_b`.
SquareMatrix oscillator_amplification(OscillatorMethod method, double omega_dt, double rho_b = 1);

/// Spectral radius of that matrix, its entries' rounding counted. Throws as above.
Bounded oscillator_growth(OscillatorMethod method, double omega_dt, double rho_b = 1);

/// The explicit generalized-alpha method (G. M. Hulbert, J. Chung, 1996, doi 10.1016/S0045-7825(96)01036-5), undamped:
///   d' = d + dt v + dt^2 ((1/2 - beta) a + beta a'),  v' = v + dt ((1 - gamma) a + gamma a'),
///   (1 - alpha_m) a' + alpha_m a = -w^2 d,
///   alpha_m = (2 rho_b - 1)/(1 + rho_b), gamma = 3/2 - alpha_m, beta = (5 - 3 rho_b)/((1 + rho_b)^2 (2 - rho_b)),
/// of second order, 0 <= rho_b <= 1 the spectral radius where its three roots meet.
///
/// Two limits, which meet at 2 for rho_b = 1:
/// *bifurcation*, w dt = (1 + rho_b) sqrt(2 - rho_b) [Oscillator 2]: the radius falls from 1 to rho_b, a triple root
/// -rho_b; beyond it one root is real and grows;
/// *stability*, w dt = sqrt(12 (1 + rho_b)(2 - rho_b)/(10 - 5 rho_b + rho_b^2)) [Oscillator 3]: that root reaches -1,
/// where a' = -a, v = (gamma - 1/2) dt a, d = (beta - gamma/2) dt^2 a, so (w dt)^2 = (1 - 2 alpha_m)/(beta - gamma/2).
/// (The form 12 (1 + rho_b)^3 (2 - rho_b)/(10 + 15 rho_b - rho_b^2 + rho_b^3 - rho_b^4), met in its place, is the same
/// at rho_b = 0 and 1 alone and up to 0.4 % too high between: over its numerator the denominator of the method above is
/// 10 + 15 rho_b + rho_b^2 - 3 rho_b^3 + rho_b^4.)
/// Throw ParameterError with the key `rho_b`.
Bounded generalized_alpha_bifurcation_limit(double rho_b);
Bounded generalized_alpha_stability_limit(double rho_b);

}  // namespace plumbline::reference
