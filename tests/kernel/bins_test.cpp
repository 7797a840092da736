#include "kernel/bins.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <span>

#include "tests/kernel/scenes.hpp"

namespace plumbline::bins_test {
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

// Of sorted nodes.
Bins bins_of(const std::vector<int>& lowest) {
  std::vector<int> node, start;
  for (std::size_t p = 0; p < lowest.size(); ++p) {
    if (p > 0 && lowest[p] == lowest[p - 1]) continue;
    node.push_back(lowest[p]);
    start.push_back(static_cast<int>(p));
  }
  start.push_back(static_cast<int>(lowest.size()));
  Bins bins;
  bins.build(node, start, layer, height);
  return bins;
}

TEST(Bins, HoldThePointsOfOneNodeEach) {
  for (int points : {1, 2, 255, 256, 257, 5000}) {
    const std::vector<int> lowest = sorted_nodes(points, layer, 40);
    const Bins bins = bins_of(lowest);
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
  Bins bins = bins_of(sorted_nodes(100, layer, 40));
  bins.build({}, std::vector<int>{0}, layer, height);
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
    if (in_order)
      bins = bins_of(lowest);
    else
      bins.build(lowest);
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
      EXPECT_LT(bins.start(chunk.last_bin - 1) - chunk.first,
                Bins::chunk_points);  // without its last bin it is not full
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
      const Bins bins = bins_of(lowest);
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
  bins.build(lowest);
  ASSERT_EQ(bins.blocks(0).size(), 1u);
  EXPECT_TRUE(bins.blocks(1).empty());
  EXPECT_EQ(bins.blocks(0)[0].first, 0);
  EXPECT_EQ(bins.blocks(0)[0].last, bins.chunk_count());
}

std::vector<int> shuffled_numbers(int points, unsigned long seed) {
  std::vector<int> id(static_cast<std::size_t>(points));
  std::iota(id.begin(), id.end(), 100);
  scenes::Random random(seed);
  for (std::size_t i = id.size(); i > 1; --i) std::swap(id[i - 1], id[static_cast<std::size_t>(random(0, 1.0 * i))]);
  return id;
}

// By node, within a node by number.
std::vector<int> expected_order(const std::vector<int>& lowest, const std::vector<int>& id) {
  std::vector<int> order(lowest.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b);
    return std::pair(lowest[i], id[i]) < std::pair(lowest[j], id[j]);
  });
  return order;
}

std::vector<int> taken(const std::vector<int>& values, const std::vector<int>& order) {
  std::vector<int> result;
  for (const int p : order) result.push_back(values[static_cast<std::size_t>(p)]);
  return result;
}
std::vector<int> copy_of(std::span<const int> order) { return {order.begin(), order.end()}; }

// Whatever the order they are given in, and as often as the same sorter is used, for fewer nodes and points as for more.
TEST(BinSort, PointsAreSortedByNodeAndNumber) {
  BinSort sorter;
  for (const auto& [points, layers] : {std::pair{3000, 10}, {1, 1}, {0, 3}, {500, 40}, {3000, 10}}) {
    const std::vector<int> lowest = random_nodes(points, layer, layers, 9), id = shuffled_numbers(points, 11);
    EXPECT_EQ(copy_of(sorter.sort(lowest, id, layer * layers)), expected_order(lowest, id));
  }
}

// From the order of the step before: a share of the points has gone to the next node, to any node, or nowhere; some bins
// lose all their points, some nodes get their first. Many times over, one after another.
TEST(BinSort, FindsTheBinsOfItsOrder) {
  constexpr int points = 2500, layers = 12, nodes = layer * layers;
  for (const double share : {0.0, 0.02, 0.4, 1.0}) {
    SCOPED_TRACE(share);
    scenes::Random random(21);
    std::vector<int> lowest = random_nodes(points, layer, layers, 9), id = shuffled_numbers(points, 11);
    BinSort sorter;
    Bins bins;
    bool moved = true;  // before the first sort they stand in no order
    for (int step = 0; step < 12; ++step) {
      if (step > 0) {
        EXPECT_EQ(bins.hold(lowest), !moved) << "step " << step;
      }
      const std::vector<int> order = copy_of(sorter.sort(lowest, id, nodes));
      ASSERT_EQ(order, expected_order(lowest, id)) << "step " << step;
      lowest = taken(lowest, order);
      id = taken(id, order);
      bins.build(sorter.node(), sorter.start(), layer, height);
      EXPECT_TRUE(bins.hold(lowest));
      const Bins same = bins_of(lowest);
      ASSERT_EQ(same.bins(), bins.bins());
      for (int bin = 0; bin < bins.bins(); ++bin) {
        ASSERT_EQ(same.node(bin), bins.node(bin));
        ASSERT_EQ(same.end(bin), bins.end(bin));
      }
      moved = false;
      for (int& node : lowest) {
        if (random(0, 1) >= share) continue;
        const int far = static_cast<int>(random(0, nodes)), near = std::min(nodes - 1, node + 1);
        const int next = step % 2 ? far : near;
        moved = moved || next != node;
        node = next;
      }
    }
    EXPECT_EQ(moved, share > 0);
  }
}

}  // namespace
}  // namespace plumbline::bins_test
