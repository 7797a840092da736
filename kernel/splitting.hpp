// Points that outgrow the kernel. A point further from its neighbours than shapes reach shares no node with them: it
// expands itself without limit, whatever the gas around it does. So a gas point whose volume has grown beyond a multiple
// of a cell's is split in two while it grows (tr C > 0, of rings tr C + v_r/r, and 0 < n . C n < c/h), which takes nothing
// from mass, momentum, centre of mass or energy. What is an eighth of a point of the start is not split again.
//
//   x' = x -+ d n,  v' = v -+ d C n,  m' = m/2,  V' = V/2,  e' = e            n: unit vector of one axis  [Splitting 1]
//   C' n = s C n,  s = sqrt(1 - d^2/D),  C' = C across n                                                [Splitting 2]
//
// since m/2 |d C n|^2 + m/2 D |s C n|^2 = m/2 D |C n|^2. The spin about the point does not stay, but for s = 1:
//   sum of m' x' cross v' + spins grows by m D s (1 - s) n cross C n, booked as `integration`            [Splitting 3]
//
// n: the axis along which C stretches most (without an affine transfer the axes take turns). d = V^(1/dim)/4, so that the
// halves stand as far apart as they are long; not above sqrt(D), and less beside a wall or piston. Axisymmetric: volume
// and mass per radian, V/r for V, and the axis of the radius no nearer than half a cell counts as r = h/2.
#pragma once

#include <string>

#include "kernel/ledger.hpp"
#include "kernel/scene.hpp"

namespace plumbline {

// Why points cannot be split under these choices; empty if they can.
std::string splitting_refusal(const std::string& shape, const std::string& transfer);

// Splits the points of all gases in the scene whose volume column exceeds scene.split h^dim and that grow, an eighth of
// a point excepted. New points go behind the
// others; their numbers go on where those of the body end, in the order of the points they come from. Returns how many
// came. time: s, for where pistons stand.
int split_points(Scene& scene, double time, int threads, Ledger& ledger);

}  // namespace plumbline
