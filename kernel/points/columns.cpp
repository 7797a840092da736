#include "kernel/points/columns.hpp"

#include <algorithm>
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

void Columns::find_runs(std::span<const int> order, int threads) {
  const int pieces = (points_ + stretch - 1) / stretch;
  runs_.resize(static_cast<std::size_t>(points_ + pieces));
  run_count_.resize(static_cast<std::size_t>(pieces));
  for_each_piece(pieces, threads, [&](int piece) {
    const int first = piece * stretch, last = std::min(first + stretch, points_);
    Run* runs = runs_.data() + first + piece;
    int count = 0, expected = -1;
    for (int p = first; p < last; ++p) {
      const int from = order[static_cast<std::size_t>(p)];
      runs[count] = {p, from};
      count += from != expected;
      expected = from + 1;
    }
    runs[count] = {last, -1};
    run_count_[static_cast<std::size_t>(piece)] = count;
  });
}

// Run after run in whole packs: what one writes beyond its end, the next writes over.
void Columns::copy_runs(int piece, const double* from, double* to) const {
  using std::experimental::element_aligned;
  constexpr int at_once = padding;
  const Run* run = runs_.data() + piece * (stretch + 1);
  const Run* last = run + run_count_[static_cast<std::size_t>(piece)];
  for (; run < last; ++run) {
    const int length = run[1].to - run->to;
    if (run[1].to + at_once > last->to) {
      std::copy_n(from + run->from, length, to + run->to);
      continue;
    }
    for (int start = 0; start < length; start += at_once) {  // hardly ever twice: a loop that is easily foretold
      for (int k = start; k < start + at_once; k += lanes) {
        load(from + run->from + k).copy_to(to + run->to + k, element_aligned);
      }
    }
  }
}

void Columns::reorder(std::span<const int> order, std::span<const ColumnId> stale, int threads) {
  find_runs(order, threads);
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    Column& column = columns_[c];
    const auto is_it = [&](const ColumnId& id) { return static_cast<std::size_t>(id.index()) == c; };
    if (column.components == 0 || std::any_of(stale.begin(), stale.end(), is_it)) continue;
    spare_.resize(column.values.size());
    for_each_piece(static_cast<int>(run_count_.size()), threads, [&](int piece) {
      for (int k = 0; k < column.components; ++k) {
        const std::size_t start = static_cast<std::size_t>(k) * stride();
        copy_runs(piece, column.values.data() + start, spare_.data() + start);
      }
    });
    std::copy(column.values.end() - padding, column.values.end(), spare_.end() - padding);
    std::swap(spare_, column.values);
  }
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
