#include "kernel/bins.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace plumbline {

void Bins::build(std::span<const int> lowest, int layer, int height, bool in_order) {
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
  find_chunks(layer, height, in_order);
}

void Bins::build(std::span<const int> node, std::span<const int> start, int layer, int height) {
  node_.assign(node.begin(), node.end());
  start_.assign(start.begin(), start.end());
  find_chunks(layer, height, true);
}

void Bins::find_chunks(int layer, int height, bool in_order) {
  chunks_.clear();
  blocks_[0].clear();
  blocks_[1].clear();
  open_block_ = -1;
  int first_bin = 0, block = 0;
  for (int bin = 0; bin < bins(); ++bin) {
    const int own = in_order ? node(bin) / (layer * height) : 0;
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

std::span<const int> BinSort::sort(std::span<const int> lowest, std::span<const int> id, int nodes) {
  next_.assign(static_cast<std::size_t>(nodes) + 1, 0);
  order_.resize(lowest.size());
  for (const int node : lowest) ++next_[static_cast<std::size_t>(node) + 1];
  std::partial_sum(next_.begin(), next_.end(), next_.begin());
  const std::vector<int> first = next_;
  for (std::size_t p = 0; p < lowest.size(); ++p) {
    const auto node = static_cast<std::size_t>(lowest[p]);
    int k = next_[node]++;
    for (; k > first[node]; --k) {
      const int before = order_[static_cast<std::size_t>(k - 1)];
      if (id[static_cast<std::size_t>(before)] < id[p]) break;
      order_[static_cast<std::size_t>(k)] = before;
    }
    order_[static_cast<std::size_t>(k)] = static_cast<int>(p);
  }
  return order_;
}

// After it, those of a node end at next_[node].
void BinSort::sort_arrivals(std::span<const Mover> movers, std::span<const int> id, int nodes) {
  next_.assign(static_cast<std::size_t>(nodes) + 1, 0);
  arrivals_.resize(movers.size());
  for (const Mover& mover : movers) ++next_[static_cast<std::size_t>(mover.node) + 1];
  std::partial_sum(next_.begin(), next_.end(), next_.begin());
  for (const Mover& mover : movers) {
    const auto k = static_cast<std::size_t>(next_[static_cast<std::size_t>(mover.node)]++);
    arrivals_[k] = mover.point;
  }
  const auto by_id = [&](int a, int b) { return id[static_cast<std::size_t>(a)] < id[static_cast<std::size_t>(b)]; };
  int first = 0;
  for (int node = 0; node < nodes; ++node) {
    const int last = next_[static_cast<std::size_t>(node)];
    if (last - first > 1) std::sort(arrivals_.begin() + first, arrivals_.begin() + last, by_id);
    first = last;
  }
}

// Points first ... last-1 come next.
void BinSort::append(int first, int last) {
  if (first == last) return;
  const bool follows = !runs_.empty() && runs_.back().from + (placed_ - runs_.back().to) == first;
  if (!follows) runs_.push_back({placed_, first});
  placed_ += last - first;
}

void BinSort::sort_again(const Bins& bins, std::span<const Mover> movers, std::span<const int> id, int nodes) {
  sort_arrivals(movers, id, nodes);
  node_.clear();
  start_.clear();
  runs_.clear();
  placed_ = 0;
  std::size_t leaver = 0;
  const auto append_but_leavers = [&](int first, int last) {
    for (; leaver < movers.size() && movers[leaver].point < last; ++leaver) {
      append(first, movers[leaver].point);
      first = movers[leaver].point + 1;
    }
    append(first, last);
  };
  int bin = 0, arrival = 0;
  for (int node = 0; node < nodes; ++node) {
    const int last_arrival = next_[static_cast<std::size_t>(node)];
    const bool was = bin < bins.bins() && bins.node(bin) == node;
    if (!was && arrival == last_arrival) continue;
    const int before = placed_;
    int stayer = was ? bins.start(bin) : 0;
    const int end = was ? bins.end(bin) : 0;
    for (; arrival < last_arrival; ++arrival) {
      const int point = arrivals_[static_cast<std::size_t>(arrival)];
      int behind = stayer;
      while (behind < end && id[static_cast<std::size_t>(behind)] < id[static_cast<std::size_t>(point)]) ++behind;
      if (was) append_but_leavers(stayer, behind);
      append(point, point + 1);
      stayer = behind;
    }
    if (was) append_but_leavers(stayer, end);
    bin += was;
    if (placed_ == before) continue;
    node_.push_back(node);
    start_.push_back(before);
  }
  start_.push_back(placed_);
  runs_.push_back({placed_, -1});
}

}  // namespace plumbline
