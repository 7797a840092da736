#include "kernel/points/columns.hpp"

#include <algorithm>
#include <utility>

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

void Columns::reorder(std::span<const int> order, std::span<const ColumnId> stale, int threads) {
  const int pieces = (points_ + piece - 1) / piece;
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    Column& column = columns_[c];
    const auto is_it = [&](const ColumnId& id) { return static_cast<std::size_t>(id.index()) == c; };
    if (column.components == 0 || std::any_of(stale.begin(), stale.end(), is_it)) continue;
    const auto components = static_cast<std::size_t>(column.components);
    if (spare_.size() <= components) spare_.resize(components + 1);
    std::vector<double>& spare = spare_[components];
    spare.resize(column.values.size());
    for_each_piece(pieces, threads, [&](int k) {
      const int first = k * piece, last = std::min(first + piece, points_);
      for (std::size_t d = 0; d < components; ++d) {
        const double* from = column.values.data() + d * stride();
        double* to = spare.data() + d * stride();
        for (int p = first; p < last; ++p) to[p] = from[order[static_cast<std::size_t>(p)]];
      }
    });
    std::copy(column.values.end() - padding, column.values.end(), spare.end() - padding);
    std::swap(spare, column.values);
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
