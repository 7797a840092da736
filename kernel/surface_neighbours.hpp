// Tangents of a surface in space from where its points stand: each point takes those near it at rest, found once by distance.
#pragma once

#include <array>
#include <vector>

#include "kernel/materials/surface_law.hpp"

namespace plumbline {

namespace column {
// 1 at points that have images behind a clamped edge. A body with this column bears from outside what its forces sum to.
inline const ColumnId clamped{"clamped", "1"};
}  // namespace column

// Stands at place - (x_p - X_p) with X_p where its partner p is at the start: the odd image of a point behind a clamped edge. It
// has neither mass nor energy, and what pulls at it pushes its partner. [Surface 4]
struct OddImage {
  int partner;
  std::array<double, 3> place;  // at the start, m
};

// f_a of point p is a sum over places, fixed weights times where points stand, by moving least squares of the start:
//   f_a(p) = fixed_a(p) + sum_k c_pka x_k. [Surface 1]
struct SurfaceNeighbours {
  // Of each point in turn: the points first[p] ... first[p + 1] - 1 of `other`, with c_1 and c_2, 1/m.
  struct Links {
    std::vector<int> first, other;
    std::vector<double> along, across;
  };
  Links of;                   // c_pka of the tangents of p
  Links on;                   // transposed: c_kpa of all k whose tangents p takes part in
  std::vector<double> fixed;  // of images: six numbers a point, f_1 then f_2. Empty without any
};

// Of points that stand as they do at the start, with the tangents that they have there: these say which lengths are at rest.
//   reach   m at rest, > 0: farther points are no neighbours
//   sheet   empty, or a number for each point: points of different sheets are no neighbours; -1: of all sheets
//   outward empty, or for each point the direction out of a free edge near it: then the weights are balanced, see balance_weights()
//   given   empty, or of each point those that alone may be its neighbours where they are within reach, as by a mesh: see
//           neighbours_in_mesh(). Images are neighbours of the points that their partners are
// Throws std::invalid_argument for neighbours that are no other points, and for a point with too few neighbours for a quadratic
// surface through it, or without tangents.
SurfaceNeighbours surface_neighbours(const Columns& points, double reach, const std::vector<OddImage>& images = {},
                                     const std::vector<int>& sheet = {},
                                     const std::vector<std::array<double, 3>>& outward = {},
                                     std::vector<std::vector<int>> given = {});

}  // namespace plumbline
