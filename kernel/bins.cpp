#include "kernel/bins.hpp"

#include <algorithm>
#include <utility>

namespace plumbline {

void Bins::build(std::span<const int> lowest, int layer, int height, bool in_order) {
  node_.clear();
  start_.clear();
  chunks_.clear();
  blocks_[0].clear();
  blocks_[1].clear();
  open_block_ = -1;
  const int points = static_cast<int>(lowest.size());
  int first_bin = 0, chunk_start = 0, block = 0;
  for (int p = 0; p < points; ++p) {
    const int node = lowest[static_cast<std::size_t>(p)];
    if (p > 0 && node == node_.back()) continue;
    const int own = in_order ? node / (layer * height) : 0;
    if (p > 0 && (own != block || p - chunk_start >= chunk_points)) {
      start_.push_back(p);
      close_chunk(first_bin, static_cast<int>(node_.size()), block);
      start_.pop_back();
      first_bin = static_cast<int>(node_.size());
      chunk_start = p;
    }
    block = own;
    node_.push_back(node);
    start_.push_back(p);
  }
  start_.push_back(points);
  if (points > 0) close_chunk(first_bin, static_cast<int>(node_.size()), block);
}

void Bins::close_chunk(int first_bin, int last_bin, int block) {
  chunks_.push_back({first_bin, last_bin, start_[static_cast<std::size_t>(first_bin)],
                     start_[static_cast<std::size_t>(last_bin)]});
  auto& same_colour = blocks_[block % 2];
  if (block == open_block_) {
    same_colour.back().last = chunk_count();
  } else {
    same_colour.push_back({chunk_count() - 1, chunk_count()});
  }
  open_block_ = block;
}

void sort_by_bin(std::span<const int> lowest, std::span<const int> id, std::vector<int>& counts,
                 std::vector<int>& order) {
  const std::size_t points = lowest.size();
  order.resize(points);
  for (const int node : lowest) ++counts[static_cast<std::size_t>(node)];
  int sum = 0;
  for (int& count : counts) sum += std::exchange(count, sum);
  for (std::size_t p = 0; p < points; ++p) {
    order[static_cast<std::size_t>(counts[static_cast<std::size_t>(lowest[p])]++)] = static_cast<int>(p);
  }
  // Within a bin by id, so that the order depends on where points stand and not on how they came there.
  const auto node_at = [&](std::size_t k) { return lowest[static_cast<std::size_t>(order[k])]; };
  const auto id_at = [&](std::size_t k) { return id[static_cast<std::size_t>(order[k])]; };
  for (std::size_t k = 1; k < points; ++k) {
    for (std::size_t j = k; j > 0 && node_at(j) == node_at(j - 1) && id_at(j) < id_at(j - 1); --j) {
      std::swap(order[j], order[j - 1]);
    }
  }
  std::fill(counts.begin(), counts.end(), 0);
}

}  // namespace plumbline
