#include "kernel/bins.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

namespace plumbline {

void Bins::build(std::span<const int> lowest) {
  node_.clear();
  start_.clear();
  const int points = static_cast<int>(lowest.size());
  for (int p = 0; p < points; ++p) {
    const int node = lowest[static_cast<std::size_t>(p)];
    if (p > 0 && node == node_.back()) continue;
    node_.push_back(node);
    start_.push_back(p);
  }
  start_.push_back(points);
  find_chunks(std::numeric_limits<int>::max());
}

void Bins::build(std::span<const int> node, std::span<const int> start, int layer, int height) {
  node_.assign(node.begin(), node.end());
  start_.assign(start.begin(), start.end());
  find_chunks(layer * height);
}

void Bins::find_chunks(int nodes_of_block) {
  chunks_.clear();
  blocks_[0].clear();
  blocks_[1].clear();
  open_block_ = -1;
  int first_bin = 0, block = 0;
  for (int bin = 0; bin < bins(); ++bin) {
    const int own = node(bin) / nodes_of_block;
    if (bin > 0 && (own != block || start(bin) - start(first_bin) >= chunk_points)) {
      close_chunk(first_bin, bin, block);
      first_bin = bin;
    }
    block = own;
  }
  if (bins() > 0) close_chunk(first_bin, bins(), block);
}

void Bins::close_chunk(int first_bin, int last_bin, int block) {
  chunks_.push_back(
      {first_bin, last_bin, start_[static_cast<std::size_t>(first_bin)], start_[static_cast<std::size_t>(last_bin)]});
  auto& same_colour = blocks_[block % 2];
  if (block == open_block_) {
    same_colour.back().last = chunk_count();
  } else {
    same_colour.push_back({chunk_count() - 1, chunk_count()});
  }
  open_block_ = block;
}

bool Bins::hold(std::span<const int> lowest) const {
  for (int bin = 0; bin < bins(); ++bin) {
    for (int p = start(bin); p < end(bin); ++p) {
      if (lowest[static_cast<std::size_t>(p)] != node(bin)) return false;
    }
  }
  return true;
}

std::span<const int> BinSort::sort(std::span<const int> lowest, std::span<const int> id, int nodes) {
  next_.assign(static_cast<std::size_t>(nodes), 0);
  for (const int node : lowest) ++next_[static_cast<std::size_t>(node)];
  node_.clear();
  start_.clear();
  int placed = 0;
  for (int node = 0; node < nodes; ++node) {
    const int count = std::exchange(next_[static_cast<std::size_t>(node)], placed);
    if (count == 0) continue;
    node_.push_back(node);
    start_.push_back(placed);
    placed += count;
  }
  start_.push_back(placed);
  order_.resize(lowest.size());
  for (std::size_t p = 0; p < lowest.size(); ++p) {
    int& next = next_[static_cast<std::size_t>(lowest[p])];
    order_[static_cast<std::size_t>(next++)] = static_cast<int>(p);
  }
  const auto before = [&](int a, int b) { return id[static_cast<std::size_t>(a)] < id[static_cast<std::size_t>(b)]; };
  for (std::size_t bin = 0; bin < node_.size(); ++bin) {
    const auto first = order_.begin() + start_[bin], last = order_.begin() + start_[bin + 1];
    if (!std::is_sorted(first, last, before)) std::sort(first, last, before);
  }
  return order_;
}

}  // namespace plumbline
