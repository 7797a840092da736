#pragma once
// Stability limits of the material-point method on a linear elastic bar: closed forms. One point a cell at the same
// place in every cell, its weight N on the node above and 1 - N below, tent shapes, increments of the nodal velocity
// given to the points (FLIP), places held fixed, infinite or periodic. Steps are Courant numbers c dt/h.
//
// With s = sin^2(theta/2) of the wave number theta/h the map from points to nodes keeps |S|^2 = 1 - 4 N (1 - N) s of a
// velocity and the divergence of the gradient gives 4 s/h^2, so that a step multiplies a wave by the eigenvalues of a
// matrix of trace 2 - x (1 or |S|^2) and determinant 1 (or 1 - x (1 - |S|^2)), x = 4 C^2 s.
#include "reference/bounded.hpp"

namespace plumbline::reference {

/// When a step strains its points: before the forces (USF); after them with the updated nodal velocity (USL), or with
/// the updated points mapped to the nodes again (MUSL); half of it before and half after a second map (USAVG).
enum class StressUpdate { first, last, modified_last, averaged };

/// The Courant number above which some wave grows, 0 <= N <= 1: 4 sqrt(N (1 - N)), or 1/|1 - 2 N| where
/// N (1 - N) < 1/8, [Stability 1], from 1 at N = 0 and 1 to 2 at N = 1/2; for StressUpdate::last
/// 1/sqrt(1 + 4 N (1 - N)) [Stability 2]. Throws ParameterError with the key `weight`.
Bounded frozen_courant_limit(StressUpdate update, double weight);

/// Largest factor by which one step at this Courant number > 0 multiplies any wave, 1 up to the limit.
/// Throws ParameterError with the key `weight` or `courant`.
Bounded frozen_growth(StressUpdate update, double weight, double courant);

/// Of tents in 1, 2 or 3 dimensions, stresses first or with the second map: one point a cell at a corner makes the
/// stiffness that of the finite differences 4 (s_x + s_y + ...)/h^2, so 1/sqrt(d) [Stability 3]. Waves of one speed.
/// Throws ParameterError with the key `dimensions`.
Bounded corner_courant_limit(int dimensions);

/// York's own bounds: one point moves, the others and all stresses are zero, and its velocity may not be thrown
/// beyond its negative. This asks for the mean of the stiffness over all wave numbers alone, 1/sqrt(1 - 3 N (1 - N)),
/// from his coefficient 2 - 6 N (1 - N) [York 8.24]: his 1 at the side of a cell [York 8.36], his 2 at its centre
/// [York 8.41], too low by up to 13 % between. Throws ParameterError with the key `weight`.
Bounded york_courant_limit(double weight);

}  // namespace plumbline::reference
