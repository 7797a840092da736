// A new order of points as runs of points that stay neighbours.
#pragma once

#include <algorithm>
#include <cstring>
#include <span>
#include <vector>

namespace plumbline {

// to, to + 1, ... were from, from + 1, ... up to the next run's `to`; behind the last run stands {points, -1}.
struct PointRun {
  int to, from;
};

// The runs of an order in which point k was order[k]. Replaces what `runs` holds.
inline void find_runs(std::span<const int> order, std::vector<PointRun>& runs) {
  runs.clear();
  int expected = -1;
  for (std::size_t p = 0; p < order.size(); ++p) {
    if (order[p] != expected) runs.push_back({static_cast<int>(p), order[p]});
    expected = order[p] + 1;
  }
  runs.push_back({static_cast<int>(order.size()), -1});
}

// The points' values in the order of consecutive runs, the last of which only says where they end. readable: values from
// `from` on that may be read. Runs are copied in whole pieces: what one writes beyond its end, the next writes over.
template <class Value>
void copy_runs(std::span<const PointRun> runs, const Value* from, Value* to, int readable) {
  constexpr int piece = 8;
  const int end = runs.back().to;
  for (std::size_t r = 0; r + 1 < runs.size(); ++r) {
    const PointRun run = runs[r];
    const int length = runs[r + 1].to - run.to, pieces = (length + piece - 1) / piece;
    if (run.to + pieces * piece <= end && run.from + pieces * piece <= readable) {
      for (int k = 0; k < pieces; ++k)  // of a constant size: a few instructions instead of a call
        std::memcpy(to + run.to + k * piece, from + run.from + k * piece, piece * sizeof(Value));
    } else {
      std::copy_n(from + run.from, length, to + run.to);
    }
  }
}

}  // namespace plumbline
