// Loops over chunks, bins and packs, and the sums that leave them.
#pragma once

#include "kernel/engine/mechanics.hpp"

namespace plumbline {

template <class G, class S, class T>
template <class Work>
void Mechanics<G, S, T>::for_chunks(const Located& at, Work&& work) const {
  const auto& chunks = at.bins.chunks();
  for_each_piece(at.bins.chunk_count(), options_.threads, [&](int k) { work(chunks[static_cast<std::size_t>(k)]); });
}

template <class G, class S, class T>
template <class Work>
void Mechanics<G, S, T>::for_chunks_writing_nodes(const Located& at, Work&& work) const {
  for (int colour = 0; colour < 2; ++colour) {
    const auto& blocks = at.bins.blocks(colour);
    for_each_piece(static_cast<int>(blocks.size()), options_.threads, [&](int k) {
      const Bins::Block block = blocks[static_cast<std::size_t>(k)];
      for (int c = block.first; c < block.last; ++c) work(at.bins.chunks()[static_cast<std::size_t>(c)]);
    });
  }
}

template <class G, class S, class T>
template <class Sum, class Work>
Sum Mechanics<G, S, T>::sum_over_chunks(const Located& at, Work&& work) const {
  const auto& chunks = at.bins.chunks();
  if (chunks.size() == 1) return work(chunks.front());
  std::vector<Sum> sums(chunks.size());
  for_each_piece(at.bins.chunk_count(), options_.threads,
                 [&](int k) { sums[static_cast<std::size_t>(k)] = work(chunks[static_cast<std::size_t>(k)]); });
  return pairwise_sum(sums.data(), sums.size());
}

template <class G, class S, class T>
template <class Sum, class Work>
Sum Mechanics<G, S, T>::sum_over_chunks_writing_nodes(const Located& at, Work&& work) const {
  std::vector<Sum> sums(at.bins.chunks().size());
  for_chunks_writing_nodes(
      at, [&](const Chunk& chunk) { sums[static_cast<std::size_t>(&chunk - at.bins.chunks().data())] = work(chunk); });
  return pairwise_sum(sums.data(), sums.size());
}

template <class G, class S, class T>
template <class Visit>
[[gnu::always_inline]] inline void Mechanics<G, S, T>::for_bins(const Bins& bins, const Chunk& chunk,
                                                                Visit&& visit) const {
  Print print;
  for (int d = 0; d < dim; ++d) print.stride[d] = grid_.stride(d);
  for (int bin = chunk.first_bin; bin < chunk.last_bin; ++bin) {
    print.lowest = bins.node(bin);
    double anchor[dim];
    int rest = print.lowest;
    for (int d = dim - 1; d >= 0; --d) {
      const int index = rest / grid_.stride(d);
      rest -= index * grid_.stride(d);
      anchor[d] = index - Grid<dim>::ghosts - S::first;
    }
    visit(print, anchor, bins.start(bin), bins.end(bin));
  }
}

template <class G, class S, class T>
auto Mechanics<G, S, T>::places(const Body& body, const Located& at) const -> Places {
  Places places;
  for (int d = 0; d < dim; ++d) {
    places.x[d] = moved_ ? at.frozen[static_cast<std::size_t>(d)].data() : body.points(column::position, d);
    if (S::boxes) places.half_size[d] = body.points(column::half_size, d);
  }
  return places;
}

// Half size of the points' boxes along d, in cells.
template <class G, class S, class T>
[[gnu::always_inline]] inline Pack Mechanics<G, S, T>::box(const Places& places, int d, int p) const {
  if constexpr (S::boxes) {
    const Pack half = load(places.half_size[d] + p) * (1 / grid_.h());
    return min(max(half, Pack(S::narrowest)), Pack(S::widest));
  } else {
    return 0.0;
  }
}

// D_p / h^2 along d of points at x cells from the first node line, with boxes of the half size `half`.
template <class G, class S, class T>
template <class Number>
[[gnu::always_inline]] inline Number Mechanics<G, S, T>::inertia_at(const Number& x, const Number& half) {
  using std::floor;
  if constexpr (S::boxes)
    return S::inertia_at(x, half);
  else
    return S::inertia(Number(x - floor(x)));
}

template <class G, class S, class T>
[[gnu::always_inline]] inline auto Mechanics<G, S, T>::stencil(const Places& places, const double (&anchor)[dim],
                                                               int p) const -> PackStencil {
  Pack local[dim], half[dim];
  for (int d = 0; d < dim; ++d) {
    local[d] = (load(places.x[d] + p) - grid_.origin(d)) * (1 / grid_.h()) - anchor[d];
    half[d] = box(places, d, p);
  }
  return PackStencil(local, half, grid_.h());
}

template <class G, class S, class T>
template <class Visit>
[[gnu::always_inline]] inline void Mechanics<G, S, T>::for_stencil_nodes(const Print& print, Visit&& visit) {
  int k = 0;
  for (int z = 0; z < (dim > 2 ? support : 1); ++z) {
    for (int y = 0; y < (dim > 1 ? support : 1); ++y) {
      int node = print.lowest;
      if constexpr (dim > 1) node += y * print.stride[1];
      if constexpr (dim > 2) node += z * print.stride[2];
      for (int x = 0; x < support; ++x) visit(k++, static_cast<std::size_t>(node + x));
    }
  }
}

template <class G, class S, class T>
template <int components, class Add>
[[gnu::always_inline]] inline void Mechanics<G, S, T>::add_to_nodes(const Print& print,
                                                                    const Pack (&sums)[nodes * components],
                                                                    Add&& add) const {
  double total[nodes * components];
  sum_lanes<nodes * components>(sums, total);
  for_stencil_nodes(print, [&](int k, std::size_t i) { add(i, total + k * components); });
}

// Relative to the middle node's, because what the maps lose is a difference of squares; a node at the stencil's edge could
// be all but massless and fast.
template <class G, class S, class T>
[[gnu::always_inline]] inline auto Mechanics<G, S, T>::bin_velocity(const Print& print,
                                                                    const std::vector<Vec>& velocity) const
    -> BinVelocity {
  BinVelocity bin;
  int middle = print.lowest;
  for (int d = 0; d < dim; ++d) middle += support / 2 * print.stride[d];
  bin.base = velocity[static_cast<std::size_t>(middle)];
  for_stencil_nodes(print, [&](int k, std::size_t i) {
    bin.square[k] = 0;
    for (int d = 0; d < dim; ++d) {
      bin.u[k][d] = velocity[i][d] - bin.base[d];
      bin.square[k] += bin.u[k][d] * bin.u[k][d];
    }
  });
  return bin;
}

}  // namespace plumbline
