// The lowest nodes of points, pack by pack, and which of them have come to another bin.
#pragma once

#include <vector>

#include "kernel/bins.hpp"
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

// The same; appends the points of a chunk that stand in another bin now, in their order.
template <class LowestNode>
bool append_movers(const Bins& bins, const Chunk& chunk, std::vector<Mover>& movers, LowestNode&& lowest_node) {
  PackMask inside = first_lanes(lanes);
  for (int bin = chunk.first_bin; bin < chunk.last_bin; ++bin) {
    const double own = bins.node(bin);
    for_packs(
        bins.start(bin), bins.end(bin), [&](int p, int count) __attribute__((always_inline)) {
          const Pack node = lowest_node(p, count, inside);
          if (none_of(node != own && first_lanes(count))) return;
          for (int k = 0; k < count; ++k) {
            const double there = node[static_cast<std::size_t>(k)];
            if (there != own) movers.push_back({p + k, static_cast<int>(there)});
          }
        });
  }
  return all_of(inside);
}

}  // namespace plumbline
