// The order of a body's points: binned by the lowest node they reach. Points of one bin share their nodes, so that loops
// take several at a time and write each node once.
#pragma once

#include <span>
#include <vector>

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

  // Of points that keep their order: consecutive ones of one node are a bin, and all are one block. lowest: the node of each.
  void build(std::span<const int> lowest);
  // Of bins in order: start: the first point of each, and behind them how many points there are. layer: nodes of one layer, the
  // part of the flat index below the last direction; a block is `height` layers.
  void build(std::span<const int> node, std::span<const int> start, int layer, int height);
  // Whether the points, whose nodes are these, are the same ones bin by bin.
  bool hold(std::span<const int> lowest) const;

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
  void find_chunks(int nodes_of_block);
  void close_chunk(int first_bin, int last_bin, int block);

  std::vector<int> node_, start_;
  std::vector<Chunk> chunks_;
  std::vector<Block> blocks_[2];
  int open_block_ = -1;
};

// The bins of points and their order by (lowest node, id): it depends on where points stand, not on how they came there.
// Scratch grows as needed.
class BinSort {
 public:
  // Which point becomes the k-th; lowest: the node of each, of `nodes` in all.
  std::span<const int> sort(std::span<const int> lowest, std::span<const int> id, int nodes);
  // The bins of that order.
  std::span<const int> node() const { return node_; }
  std::span<const int> start() const { return start_; }  // and behind the last bin's how many points there are

 private:
  std::vector<int> next_;  // per node: where its next point goes
  std::vector<int> order_, node_, start_;
};

}  // namespace plumbline
