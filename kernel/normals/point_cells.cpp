#include "kernel/normals/point_cells.hpp"

namespace plumbline {

// Those along x first; along y all of these again, so that corners have images of images.
void PointCells::add_images() {
  for (int d = 0; d < 2; ++d) {
    const auto k = static_cast<std::size_t>(d);
    std::vector<double>&along = d == 0 ? all_x_ : all_y_, &across = d == 0 ? all_y_ : all_x_;
    const std::size_t count = along.size();
    for (std::size_t side = 0; side < 2; ++side) {
      if (grid_.walls[k][side] != Wall::symmetry) continue;
      const double wall = grid_.origin[k] + (side == 0 ? 0 : grid_.cells[k] * grid_.h);
      for (std::size_t p = 0; p < count; ++p) {
        if (std::abs(along[p] - wall) >= margin * grid_.h) continue;
        along.push_back(2 * wall - along[p]);
        across.push_back(across[p]);
      }
    }
  }
}

int PointCells::index(double position, int d) const {
  const auto k = static_cast<std::size_t>(d);
  const double logical = (position - grid_.origin[k]) / grid_.h;
  // The last line belongs to the last cell, for a point on it as for its image.
  if (logical == grid_.cells[k]) return grid_.cells[k] - 1 + margin;
  return static_cast<int>(std::clamp(std::floor(logical) + margin, 0.0, padded(d) - 1.0));
}

void PointCells::sort(const GridSpec& grid, std::span<const double> x, std::span<const double> y) {
  grid_ = grid;
  all_x_.assign(x.begin(), x.end());
  all_y_.assign(y.begin(), y.end());
  own_ = static_cast<int>(x.size());
  add_images();
  const std::size_t count = all_x_.size();
  start_.assign(static_cast<std::size_t>(padded(0) * padded(1)) + 1, 0);
  for (std::vector<double>* sorted : {&x_, &y_}) sorted->resize(count);
  number_.resize(count);
  cell_.resize(count);
  for (std::size_t p = 0; p < count; ++p) {
    cell_[p] = index(all_y_[p], 1) * padded(0) + index(all_x_[p], 0);
    ++start_[static_cast<std::size_t>(cell_[p]) + 1];
  }
  for (std::size_t c = 1; c < start_.size(); ++c) start_[c] += start_[c - 1];
  for (std::size_t p = 0; p < count; ++p) {
    const auto at = static_cast<std::size_t>(start_[static_cast<std::size_t>(cell_[p])]++);
    x_[at] = all_x_[p];
    y_[at] = all_y_[p];
    number_[at] = static_cast<int>(p) < own_ ? static_cast<int>(p) : -1;
  }
  for (std::size_t c = start_.size() - 1; c > 0; --c) start_[c] = start_[c - 1];
  start_[0] = 0;
}

std::array<int, 2> PointCells::row(int from, int to, int j) const {
  const int low = std::max(from + margin, 0), high = std::min(to + margin, padded(0) - 1), line = j + margin;
  if (line < 0 || line >= padded(1) || low > high) return {0, 0};
  const auto first = static_cast<std::size_t>(line * padded(0) + low),
             last = static_cast<std::size_t>(line * padded(0) + high);
  return {start_[first], start_[last + 1]};
}

}  // namespace plumbline
