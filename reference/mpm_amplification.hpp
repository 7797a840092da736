#pragma once
// Stability limits of the material-point method on a linear elastic bar, for any places of the points, shapes,
// transfers and the four orders of straining: by linear algebra alone. Units c = h = rho = 1, so that a step is a
// Courant number C; places of the points frozen, in cells.
//
// With weights S_pi and gradients G_pi, nodal masses M = S'm and the scaled matrices
//   B = M^-1/2 S' m S M^-1/2,  K = M^-1/2 G' V G M^-1/2                                             [Stability 4]
// (affine transfers: B also has S1' m D^-1 S1, S1_pi = S_pi (x_i - x_p)), nodal velocities q and forces f follow a step
// of their own, whatever else the points remember: in the integrator's order f' = f + C K q, q' = alpha q - C beta f,
//   flip (alpha, beta) = (1, B), pic and apic (B, B), xpic (1 - (1 - B)^m, B), fmpm twice 1 - (1 - B)^m.
// All other eigenvalues of a step are 0 or 1. B is symmetric and between 0 and 1, alpha and beta are polynomials of it,
// beta <= alpha <= 1. For an eigenvector z straining first, half and half, or last after a second map give
//   a t^2 - (a + b - C^2 z*Kz) t + b = 0,  a = z* beta^-1 z,  b = z* beta^-1 alpha z <= a:
// real coefficients, so a root can leave the unit disc through -1 alone. Straining last without a second map,
//   z* (t - 1)(t - alpha)/(t - alpha + beta) z = -C^2 z*Kz,
// whose left side has an imaginary part of one sign on either half of the unit circle (or is the above, where
// alpha = beta = 1): again only -1 is left. There
//   1/C^2 = lambda_max(W K),  W = beta/(2 (1 + alpha)), or (1 + alpha - beta)/(2 (1 + alpha))       [Stability 5]
// is the limit, the stable steps are an interval, and the first three orders of straining have the same.
#include <vector>

#include "reference/bar_stability.hpp"
#include "reference/spectral_radius.hpp"

namespace plumbline::reference {

/// Tents; their means over a box of the points' spacing (uniform GIMP); B-splines centred on the nodes.
enum class GridShape { linear, boxes, quadratic, cubic };

/// What points take from the nodes. With P = M^-1 S'm S, w~ the updated and w the mapped velocity, a = (w~ - w)/C:
/// pic S w~; flip v + C S a; apic S w~ and C_p = D^-1 S1 w~; xpic S (sum_{j<m} (1 - P)^j w + C a) (C. C. Hammerquist,
/// J. A. Nairn, 2017, doi 10.1016/j.cma.2016.10.036); fmpm S sum_{j<m} (1 - P)^j w~ (J. A. Nairn, C. C. Hammerquist,
/// 2021, doi 10.1016/j.cma.2021.113964). For m = 1 both are pic.
enum class GridTransfer { pic, flip, apic, xpic, fmpm };

/// `sharpening` > 0: accelerations and straining velocities go through
/// (Q u)_i = u_i + sharpening theta/M_i sum_j 2 M_i M_j/(M_i + M_j) (u_i - u_j), j = i -+ 1, theta half the shape's
/// variance (boxes: of half a cell), so that K becomes Q K Q.
struct MapScheme {
  StressUpdate update = StressUpdate::modified_last;
  GridShape shape = GridShape::linear;
  GridTransfer transfer = GridTransfer::flip;
  int order = 2;  // m of xpic and fmpm, from 1
  double sharpening = 0;
};

// Periodic layouts: every cell holds points at the places `points`, 0 <= x < 1 or shifted by whole cells, which share
// its mass; waves of the phase theta a cell.

/// (i + 1/2)/per_cell + offset.
std::vector<double> regular_points(int per_cell, double offset = 0);

/// One step on (v_p, [C_p,] eps_p) of all points, C_p for apic alone.
/// Throws ParameterError with the key `points`, `order`, `sharpening` or `courant`.
ComplexMatrix amplification_matrix(const MapScheme& scheme, const std::vector<double>& points, double theta,
                                   double courant);

/// The largest magnitude of the two eigenvalues that nodes see. Throws as above.
Bounded wave_growth(const MapScheme& scheme, const std::vector<double>& points, double theta, double courant);

/// The limit over all waves. [Stability 5] as a function of sin^2(theta/2) is enclosed on intervals that are halved
/// until none may hide a larger value. Throws as above.
Bounded periodic_courant_limit(const MapScheme& scheme, const std::vector<double>& points);

struct WorstOffset {
  double offset = 0;
  Bounded limit;
};
/// The regular layout shifted as a whole, where the limit is least: sampled, the lowest sample refined. The bound is that
/// of the limit at this offset. Throws as above, key `per_cell`.
WorstOffset worst_rigid_offset(const MapScheme& scheme, int per_cell);

// Finite bars with free ends, in a grid of unit cells without walls: a node takes part if it carries mass.

/// Regular points, the leading one `depth` inside the cell that nothing else touches: -depth + i/per_cell, per_cell
/// times `cells` of them. 0 < depth <= 1/per_cell. Throws ParameterError with the key `per_cell`, `cells` or `depth`.
std::vector<double> edge_points(int per_cell, int cells, double depth);

/// York's five points, one a cell: i + offset. [York 8.41] at 0.5, [York 8.36] at 1e-4.
std::vector<double> york_points(double offset);

/// One step on (v_p, [C_p,] eps_p) of points of the mass `spacing` each, their boxes as wide.
/// Throws ParameterError with the key `points`, `spacing`, `order`, `sharpening` or `courant`.
SquareMatrix free_bar_amplification(const MapScheme& scheme, const std::vector<double>& points, double spacing,
                                    double courant);

/// The limit of that bar. Its motion as a whole meets no stiffness and is left out by that. The bound is from the
/// rounding of the two symmetric eigenproblems and of the matrices. Throws as above.
Bounded free_bar_courant_limit(const MapScheme& scheme, const std::vector<double>& points, double spacing);

/// The limit of a bar that leans on a rigid frictionless wall at zero, points beyond it: of those motions of the points and
/// their mirror images that the mirror keeps. Throws as above, key `points` where one is not beyond the wall.
Bounded leaning_bar_courant_limit(const MapScheme& scheme, const std::vector<double>& points, double spacing);

}  // namespace plumbline::reference
