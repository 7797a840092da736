// The lowest nodes of points, pack by pack.
#pragma once

#include "kernel/materials/material.hpp"
#include "kernel/pack.hpp"

namespace plumbline {

// lowest_node(p, count, inside): of a pack of points; inside: whether all so far stand on the grid, which is returned.
template <class LowestNode>
bool store_lowest_nodes(PointRange range, int* lowest, LowestNode&& lowest_node) {
  PackMask inside = first_lanes(lanes);
  for_packs(
      range.first, range.last, [&](int p, int count) __attribute__((always_inline)) {
        store_as_integers(lowest + p, lowest_node(p, count, inside), count);
      });
  return all_of(inside);
}

}  // namespace plumbline
