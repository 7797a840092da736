#include "kernel/points/columns.hpp"

#include <algorithm>

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

void Columns::add(const ColumnId& id, int components) {
  const auto index = static_cast<std::size_t>(id.index());
  if (data_.size() <= index) data_.resize(index + 1);
  if (data_[index].empty()) data_[index].assign(stride() * static_cast<std::size_t>(components), 0.0);
}

int Columns::components(const ColumnId& id) const {
  const auto index = static_cast<std::size_t>(id.index());
  if (index >= data_.size() || points_ == 0) return 0;
  return static_cast<int>(data_[index].size() / stride());
}

void Columns::reorder(std::span<const int> order) {
  std::vector<double> sorted(stride());
  for (auto& column : data_) {
    for (std::size_t start = 0; start < column.size(); start += stride()) {
      for (std::size_t k = 0; k < stride(); ++k) sorted[k] = column[start + static_cast<std::size_t>(order[k])];
      std::copy(sorted.begin(), sorted.end(), column.begin() + static_cast<std::ptrdiff_t>(start));
    }
  }
}

int Columns::doubles_per_point() const {
  std::size_t total = 0;
  for (const auto& column : data_) total += column.size();
  return points_ == 0 ? 0 : static_cast<int>(total / stride());
}

}  // namespace plumbline
