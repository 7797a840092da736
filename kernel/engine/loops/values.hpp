// Single values of points to nodes and back.
#pragma once

#include "kernel/engine/loops/shape_loops.hpp"

namespace plumbline {

template <class G, class S>
void ShapeLoops<G, S>::spread(const Columns& points, const At& at, const Chunk& chunk,
                              std::span<const Spread> all) const {
  constexpr int most = Base::most_spread;
  const Places<dim> places = at.places(points, S::boxes);
  for_bins(at.bins, chunk, [&](const Print& print, const double(&anchor)[dim], int first, int last) {
    Pack sums[nodes * most];
    clear(sums);
    const auto with_pack = [&](int p, int count) __attribute__((always_inline)) {
      const PackStencil weights = stencil(places, anchor, p);
      for (std::size_t k = 0; k < all.size(); ++k) {
        const Pack q = load(all[k].values + p);
        weights.spread(all[k].mass ? kept(load(all[k].mass + p), count) * q : kept(q, count), sums + k, most);
      }
    };
    for_packs(first, last, with_pack);
    for_stencil_nodes(print, [&](int node, std::size_t i) {
      double totals[most] = {};
      add_lane_sums<most>(sums + node * most, totals);
      for (std::size_t k = 0; k < all.size(); ++k)
        all[k].nodes[i * static_cast<std::size_t>(all[k].stride)] += totals[k];
    });
  });
}

template <class G, class S>
void ShapeLoops<G, S>::gather(const Columns& points, const At& at, const Chunk& chunk,
                              std::span<const Gather> all) const {
  const Places<dim> places = at.places(points, S::boxes);
  for_bins(at.bins, chunk, [&](const Print& print, const double(&anchor)[dim], int first, int last) {
    for_packs(first, last, [&](int p, int count) {
      const PackStencil weights = stencil(places, anchor, p);
      for (const Gather& one : all) {
        const auto at_node = [&](std::size_t i) { return Pack(one.nodes[i * static_cast<std::size_t>(one.stride)]); };
        store(one.values + p, weights.gather(print, at_node).value, count);
      }
    });
  });
}

}  // namespace plumbline
