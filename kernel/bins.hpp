// The order of a body's points: binned by the lowest node they reach. Points of one bin share their nodes, so that loops
// take several at a time and write each node once.
#pragma once

#include <span>
#include <vector>

#include "kernel/points/runs.hpp"

namespace plumbline {

// Consecutive bins of a few hundred points: a piece of work that stays in the cache, and whose sums are summed alone.
struct Chunk {
  int first_bin, last_bin;  // [first, last)
  int first, last;          // their points
};

// Neighbouring blocks are never under way together: a block is taller than a stencil reaches.
class Bins {
 public:
  static constexpr int chunk_points = 256;

  // lowest: node of each point in the order of the points; consecutive equal ones are a bin. layer: nodes of one layer,
  // the part of the flat index below the last direction; a block is `height` layers. in_order: nodes do not decrease;
  // otherwise (a chain of points) all is one block.
  void build(std::span<const int> lowest, int layer, int height, bool in_order);
  // The same of bins in order: start: the first point of each, and behind them how many points there are.
  void build(std::span<const int> node, std::span<const int> start, int layer, int height);

  int points() const { return start_.empty() ? 0 : start_.back(); }
  int node(int bin) const { return node_[static_cast<std::size_t>(bin)]; }
  int start(int bin) const { return start_[static_cast<std::size_t>(bin)]; }
  int end(int bin) const { return start_[static_cast<std::size_t>(bin) + 1]; }
  int bins() const { return static_cast<int>(node_.size()); }
  const std::vector<Chunk>& chunks() const { return chunks_; }
  int chunk_count() const { return static_cast<int>(chunks_.size()); }

  // Blocks of one colour (0 or 1) may run side by side. A block: [first, last) of chunks().
  struct Block {
    int first, last;
  };
  const std::vector<Block>& blocks(int colour) const { return blocks_[colour]; }

 private:
  void find_chunks(int layer, int height, bool in_order);
  void close_chunk(int first_bin, int last_bin, int block);

  std::vector<int> node_, start_;
  std::vector<Chunk> chunks_;
  std::vector<Block> blocks_[2];
  int open_block_ = -1;
};

// A point that has come to another bin, and that bin's node.
struct Mover {
  int point, node;
};

// The order of points by (lowest node, id): it depends on where points stand, not on how they came there. Scratch grows as
// needed.
class BinSort {
 public:
  // From any order: which point becomes the k-th.
  std::span<const int> sort(std::span<const int> lowest, std::span<const int> id, int nodes);

  // From the order of `bins`, in each of which ids ascend. movers: in the order of the points. Finds the new bins, whose
  // points are the runs() of what they were.
  void sort_again(const Bins& bins, std::span<const Mover> movers, std::span<const int> id, int nodes);
  std::span<const int> node() const { return node_; }
  std::span<const int> start() const { return start_; }  // and behind the last bin's how many points there are
  std::span<const PointRun> runs() const { return runs_; }

 private:
  void sort_arrivals(std::span<const Mover> movers, std::span<const int> id, int nodes);
  void append(int first, int last);

  std::vector<int> next_;              // per node: where its next point goes
  std::vector<int> order_, arrivals_;  // arrivals_: movers by (node, id)
  std::vector<int> node_, start_;
  std::vector<PointRun> runs_;
  int placed_ = 0;
};

}  // namespace plumbline
