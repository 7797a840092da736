// Loops over the chunks of one body, and the sums that leave them.
#pragma once

#include <vector>

#include "kernel/bins.hpp"
#include "kernel/parallel.hpp"
#include "kernel/summation.hpp"

namespace plumbline {

// work(chunk) for each, in any order.
template <class Work>
void for_chunks(const Bins& bins, int threads, Work&& work) {
  const auto& chunks = bins.chunks();
  for_each_piece(bins.chunk_count(), threads, [&](int k) { work(chunks[static_cast<std::size_t>(k)]); });
}

// work(chunk) for each; chunks that could write the same node are never under way together, and always in the same order.
template <class Work>
void for_chunks_writing_nodes(const Bins& bins, int threads, Work&& work) {
  for (int colour = 0; colour < 2; ++colour) {
    const auto& blocks = bins.blocks(colour);
    for_each_piece(static_cast<int>(blocks.size()), threads, [&](int k) {
      const Bins::Block block = blocks[static_cast<std::size_t>(k)];
      for (int c = block.first; c < block.last; ++c) work(bins.chunks()[static_cast<std::size_t>(c)]);
    });
  }
}

// The sum of work(chunk) over all chunks, which does not depend on threads.
template <class Sum, class Work>
Sum sum_over_chunks(const Bins& bins, int threads, Work&& work) {
  const auto& chunks = bins.chunks();
  if (chunks.size() == 1) return work(chunks.front());
  std::vector<Sum> sums(chunks.size());
  for_each_piece(bins.chunk_count(), threads,
                 [&](int k) { sums[static_cast<std::size_t>(k)] = work(chunks[static_cast<std::size_t>(k)]); });
  return pairwise_sum(sums.data(), sums.size());
}

// The same for work that writes nodes.
template <class Sum, class Work>
Sum sum_over_chunks_writing_nodes(const Bins& bins, int threads, Work&& work) {
  std::vector<Sum> sums(bins.chunks().size());
  for_chunks_writing_nodes(bins, threads, [&](const Chunk& chunk) {
    sums[static_cast<std::size_t>(&chunk - bins.chunks().data())] = work(chunk);
  });
  return pairwise_sum(sums.data(), sums.size());
}

}  // namespace plumbline
