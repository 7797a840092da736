#include "kernel/points/columns.hpp"

#include <algorithm>
#include <type_traits>
#include <utility>

#include "kernel/pack.hpp"
#include "kernel/parallel.hpp"
#include "kernel/points/column_registry.hpp"

namespace plumbline {
namespace {

struct Description {
  std::string name, unit;
};

std::vector<Description>& descriptions() {
  static std::vector<Description> all;
  return all;
}

}  // namespace

ColumnId::ColumnId(const char* name, const char* unit) {
  auto& all = descriptions();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Description& d) { return d.name == name; });
  index_ = static_cast<int>(found - all.begin());
  if (found == all.end()) all.push_back({name, unit});
}

const std::string& ColumnId::name() const { return descriptions()[static_cast<std::size_t>(index_)].name; }
const std::string& ColumnId::unit() const { return descriptions()[static_cast<std::size_t>(index_)].unit; }

std::vector<ColumnId> registered_columns() {
  std::vector<ColumnId> all;
  for (const Description& d : descriptions()) all.emplace_back(d.name.c_str(), d.unit.c_str());
  return all;
}

void Columns::add(const ColumnId& id, int components) {
  const auto index = static_cast<std::size_t>(id.index());
  if (columns_.size() <= index) columns_.resize(index + 1);
  Column& column = columns_[index];
  if (column.components > 0) return;
  column.components = components;
  column.values.assign(stride() * static_cast<std::size_t>(components) + static_cast<std::size_t>(padding), 0.0);
}

int Columns::components(const ColumnId& id) const {
  const auto index = static_cast<std::size_t>(id.index());
  return index < columns_.size() && points_ > 0 ? columns_[index].components : 0;
}

void find_runs(std::span<const int> order, std::vector<PointRun>& runs) {
  runs.clear();
  int expected = -1;
  for (std::size_t p = 0; p < order.size(); ++p) {
    if (order[p] != expected) runs.push_back({static_cast<int>(p), order[p]});
    expected = order[p] + 1;
  }
  runs.push_back({static_cast<int>(order.size()), -1});
}

// Run after run in whole packs: what one writes beyond its end, the next writes over. The last of `runs` is their end.
void Columns::copy_runs(std::span<const PointRun> runs, const Copied& all) {
  const int end = runs.back().to;
  for (std::size_t r = 0; r + 1 < runs.size(); ++r) {
    const auto [to, from] = runs[r];
    const int length = runs[r + 1].to - to;
    const auto copy_packs = [&](auto packs) __attribute__((always_inline)) {
      for (int a = 0; a < all.count; ++a) {
        Pack values[packs];
        for (int k = 0; k < packs; ++k) values[k] = load(all.from[a] + from + k * lanes);
        for (int k = 0; k < packs; ++k) store(all.to[a] + to + k * lanes, values[k], lanes);
      }
    };
    static_assert(4 * lanes <= padding);
    if (length <= 2 * lanes && to + 2 * lanes <= end) {
      copy_packs(std::integral_constant<int, 2>());
    } else if (length <= 4 * lanes && to + 4 * lanes <= end) {
      copy_packs(std::integral_constant<int, 4>());
    } else {
      for (int a = 0; a < all.count; ++a) std::copy_n(all.from[a] + from, length, all.to[a] + to);
    }
  }
}

void Columns::reorder(std::span<const int> order, std::span<const ColumnId> stale, int threads) {
  std::vector<PointRun> runs;
  find_runs(order, runs);
  reorder(runs, stale, threads);
}

void Columns::reorder(std::span<const PointRun> runs, std::span<const ColumnId> stale, int threads) {
  const int pieces = (static_cast<int>(runs.size()) - 2) / piece + 1;
  std::vector<Column*> group;
  Copied all;
  const auto copy_group = [&] {
    for_each_piece(pieces, threads, [&](int k) {
      const std::size_t first = static_cast<std::size_t>(k) * piece;
      copy_runs(runs.subspan(first, std::min(static_cast<std::size_t>(piece) + 1, runs.size() - first)), all);
    });
    for (std::size_t g = 0; g < group.size(); ++g) std::swap(spare_[g], group[g]->values);
    group.clear();
    all.count = 0;
  };
  constexpr int most = static_cast<int>(std::size(Copied().to));
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    Column& column = columns_[c];
    const auto is_it = [&](const ColumnId& id) { return static_cast<std::size_t>(id.index()) == c; };
    if (column.components == 0 || std::any_of(stale.begin(), stale.end(), is_it)) continue;
    if (all.count > 0 && all.count + column.components > most) copy_group();
    if (spare_.size() <= group.size()) spare_.emplace_back();
    std::vector<double>& spare = spare_[group.size()];
    spare.resize(column.values.size());
    std::copy(column.values.end() - padding, column.values.end(), spare.end() - padding);
    group.push_back(&column);
    for (int k = 0; k < column.components; ++k) {
      if (all.count == most) {  // a column of many components takes several turns
        std::vector<Column*> later;
        std::swap(group, later);
        copy_group();
        std::swap(group, later);
      }
      const std::size_t start = static_cast<std::size_t>(k) * stride();
      all.from[all.count] = column.values.data() + start;
      all.to[all.count++] = spare.data() + start;
    }
  }
  copy_group();
}

void Columns::append_copies(std::span<const int> of) {
  const std::size_t before = stride(), now = before + of.size();
  for (Column& column : columns_) {
    if (column.components == 0) continue;
    std::vector<double> values(now * static_cast<std::size_t>(column.components) + static_cast<std::size_t>(padding),
                               0.0);
    for (std::size_t k = 0; k < static_cast<std::size_t>(column.components); ++k) {
      const double* from = column.values.data() + k * before;
      double* to = std::copy(from, from + before, values.data() + k * now);
      for (const int p : of) *to++ = from[p];
    }
    column.values = std::move(values);
  }
  points_ = static_cast<int>(now);
}

int Columns::doubles_per_point() const {
  int total = 0;
  for (const Column& column : columns_) total += column.components;
  return total;
}

}  // namespace plumbline
