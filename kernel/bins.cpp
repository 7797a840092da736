#include "kernel/bins.hpp"

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

void BinSort::place_from_counts() {
  int sum = 0;
  for (std::size_t node = 0; node < next_.size(); ++node) {
    const int count = next_[node];
    start_[node] = next_[node] = sum;
    sum += count;
  }
}

// Within a bin by id, so that the order depends on where points stand and not on how they came there.
void BinSort::insert(int point, int node, std::span<const int> id) {
  const auto at = static_cast<std::size_t>(node);
  const auto id_of = [&](int p) { return id[static_cast<std::size_t>(p)]; };
  int k = next_[at]++;
  for (; k > start_[at] && id_of(order_[static_cast<std::size_t>(k - 1)]) > id_of(point); --k) {
    order_[static_cast<std::size_t>(k)] = order_[static_cast<std::size_t>(k - 1)];
  }
  order_[static_cast<std::size_t>(k)] = point;
}

std::span<const int> BinSort::sort(std::span<const int> lowest, std::span<const int> id, int nodes) {
  start_.resize(static_cast<std::size_t>(nodes));
  next_.assign(static_cast<std::size_t>(nodes), 0);
  order_.resize(lowest.size());
  for (const int node : lowest) ++next_[static_cast<std::size_t>(node)];
  place_from_counts();
  for (std::size_t p = 0; p < lowest.size(); ++p) insert(static_cast<int>(p), lowest[p], id);
  return order_;
}

std::span<const int> BinSort::sort_again(const Bins& bins, std::span<const int> lowest, std::span<const int> id,
                                         int nodes) {
  start_.resize(static_cast<std::size_t>(nodes));
  next_.assign(static_cast<std::size_t>(nodes), 0);
  order_.resize(lowest.size());
  movers_.clear();
  for (int bin = 0; bin < bins.bins(); ++bin) {
    const int node = bins.node(bin);
    int stay = 0;
    for (int p = bins.start(bin); p < bins.end(bin); ++p) {
      const int now = lowest[static_cast<std::size_t>(p)];
      if (now == node) {
        ++stay;
      } else {
        ++next_[static_cast<std::size_t>(now)];
        movers_.push_back(p);
      }
    }
    next_[static_cast<std::size_t>(node)] += stay;
  }
  place_from_counts();
  std::size_t mover = 0;
  for (int bin = 0; bin < bins.bins(); ++bin) {
    int& next = next_[static_cast<std::size_t>(bins.node(bin))];
    for (int p = bins.start(bin); p < bins.end(bin); ++p) {
      if (mover < movers_.size() && movers_[mover] == p) {
        ++mover;
      } else {
        order_[static_cast<std::size_t>(next++)] = p;
      }
    }
  }
  for (const int p : movers_) insert(p, lowest[static_cast<std::size_t>(p)], id);
  return order_;
}

}  // namespace plumbline
