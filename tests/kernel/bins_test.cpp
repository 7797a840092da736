#include "kernel/bins.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "tests/kernel/scenes.hpp"

namespace plumbline {
namespace {

// Lowest nodes of points on a grid of `layer` nodes a layer, some bins full, some with one point, many empty.
std::vector<int> random_nodes(int points, int layer, int layers, unsigned long seed) {
  scenes::Random random(seed);
  std::vector<int> lowest(static_cast<std::size_t>(points));
  for (int& node : lowest) {
    node = static_cast<int>(random(0, layers)) * layer + static_cast<int>(layer * random(0, 1) * random(0, 1));
  }
  return lowest;
}

std::vector<int> sorted_nodes(int points, int layer, int layers, unsigned long seed = 3) {
  std::vector<int> lowest = random_nodes(points, layer, layers, seed);
  std::sort(lowest.begin(), lowest.end());
  return lowest;
}

constexpr int layer = 30, height = 4;

TEST(Bins, HoldThePointsOfOneNodeEach) {
  for (int points : {1, 2, 255, 256, 257, 5000}) {
    const std::vector<int> lowest = sorted_nodes(points, layer, 40);
    Bins bins;
    bins.build(lowest, layer, height, true);
    int met = 0;
    for (int bin = 0; bin < bins.bins(); ++bin) {
      EXPECT_EQ(bins.start(bin), met);
      EXPECT_GT(bins.end(bin), bins.start(bin));
      for (; met < bins.end(bin); ++met) EXPECT_EQ(lowest[static_cast<std::size_t>(met)], bins.node(bin));
      if (bin > 0) {
        EXPECT_NE(bins.node(bin), bins.node(bin - 1));
      }
    }
    EXPECT_EQ(met, points);
  }
}

TEST(Bins, OfNoPointsAreNone) {
  Bins bins;
  bins.build(sorted_nodes(100, layer, 40), layer, height, true);
  bins.build({}, layer, height, true);
  EXPECT_EQ(bins.bins(), 0);
  EXPECT_EQ(bins.chunk_count(), 0);
  EXPECT_TRUE(bins.blocks(0).empty());
  EXPECT_TRUE(bins.blocks(1).empty());
}

// Whole bins, all of them, one after another; a chunk ends with the bin that fills it, or with its block.
TEST(Bins, ChunksAreConsecutiveBins) {
  for (bool in_order : {true, false}) {
    const std::vector<int> lowest = in_order ? sorted_nodes(20000, layer, 40) : random_nodes(20000, layer, 40, 5);
    Bins bins;
    bins.build(lowest, layer, height, in_order);
    int bin = 0, point = 0;
    for (int c = 0; c < bins.chunk_count(); ++c) {
      const Chunk& chunk = bins.chunks()[static_cast<std::size_t>(c)];
      EXPECT_EQ(chunk.first_bin, bin);
      EXPECT_EQ(chunk.first, point);
      EXPECT_GT(chunk.last_bin, chunk.first_bin);
      EXPECT_EQ(chunk.first, bins.start(chunk.first_bin));
      EXPECT_EQ(chunk.last, bins.end(chunk.last_bin - 1));
      bin = chunk.last_bin;
      point = chunk.last;
      EXPECT_LT(bins.start(chunk.last_bin - 1) - chunk.first, Bins::chunk_points);  // without its last bin it is not full
      if (c + 1 == bins.chunk_count()) continue;
      const bool same_block = !in_order || bins.node(chunk.first_bin) / (layer * height) ==
                                               bins.node(chunk.last_bin) / (layer * height);
      if (same_block) {
        EXPECT_GE(chunk.last - chunk.first, Bins::chunk_points);
      }
    }
    EXPECT_EQ(bin, bins.bins());
    EXPECT_EQ(point, 20000);
  }
}

// Every chunk is in one block; the points of a block lie in its layers; two blocks of one colour are a block apart, and a
// stencil of four nodes, the largest there is, reaches three layers beyond its lowest: they share no node.
TEST(Bins, BlocksOfOneColourShareNoNode) {
  for (unsigned long seed : {1ul, 2ul, 3ul}) {
    for (int points : {40, 3000, 30000}) {
      const std::vector<int> lowest = sorted_nodes(points, layer, 60, seed);
      Bins bins;
      bins.build(lowest, layer, height, true);
      std::vector<int> seen(static_cast<std::size_t>(bins.chunk_count()));
      for (int colour = 0; colour < 2; ++colour) {
        int reached = -1;
        for (const Bins::Block& block : bins.blocks(colour)) {
          ASSERT_LT(block.first, block.last);
          int low = 1 << 30, high = -1;
          for (int c = block.first; c < block.last; ++c) {
            ++seen[static_cast<std::size_t>(c)];
            const Chunk& chunk = bins.chunks()[static_cast<std::size_t>(c)];
            for (int bin = chunk.first_bin; bin < chunk.last_bin; ++bin) {
              low = std::min(low, bins.node(bin) / layer);
              high = std::max(high, bins.node(bin) / layer);
            }
          }
          EXPECT_EQ(low / height, high / height);
          EXPECT_GT(low, reached);
          reached = high + 3;
        }
      }
      EXPECT_TRUE(std::all_of(seen.begin(), seen.end(), [](int n) { return n == 1; }));
      if (points == 30000) {
        EXPECT_GT(bins.blocks(0).size() + bins.blocks(1).size(), 10u);
      }
    }
  }
}

// The points of a chain stand as they are joined, and any two may share nodes: one block, one thread.
TEST(Bins, AChainIsOneBlock) {
  const std::vector<int> lowest = random_nodes(5000, layer, 40, 7);
  Bins bins;
  bins.build(lowest, layer, height, false);
  ASSERT_EQ(bins.blocks(0).size(), 1u);
  EXPECT_TRUE(bins.blocks(1).empty());
  EXPECT_EQ(bins.blocks(0)[0].first, 0);
  EXPECT_EQ(bins.blocks(0)[0].last, bins.chunk_count());
}

// By node, within a node by number, whatever the order they are given in.
TEST(Bins, PointsAreSortedByNodeAndNumber) {
  const int points = 3000;
  std::vector<int> lowest = random_nodes(points, layer, 10, 9), id(static_cast<std::size_t>(points));
  std::iota(id.begin(), id.end(), 100);
  scenes::Random random(11);
  for (std::size_t i = id.size() - 1; i > 0; --i) std::swap(id[i], id[static_cast<std::size_t>(random(0, i + 1.0))]);
  std::vector<int> counts(static_cast<std::size_t>(layer * 10)), order;
  sort_by_bin(lowest, id, counts, order);
  ASSERT_EQ(order.size(), lowest.size());
  std::vector<int> expected(order.size());
  std::iota(expected.begin(), expected.end(), 0);
  std::sort(expected.begin(), expected.end(), [&](int a, int b) {
    const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b);
    return std::pair(lowest[i], id[i]) < std::pair(lowest[j], id[j]);
  });
  EXPECT_EQ(order, expected);
  EXPECT_TRUE(std::all_of(counts.begin(), counts.end(), [](int n) { return n == 0; }));
}

}  // namespace
}  // namespace plumbline
