// Points of the plane and their images in symmetry walls, by the grid's cells.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "kernel/grid.hpp"

namespace plumbline {

// Cells of the grid and `margin` more beyond each side, where the images of points within `margin` cells of a symmetry
// wall stand. Points keep their order inside a cell. All arrays are kept between calls.
class PointCells {
 public:
  static constexpr int margin = 4;  // a spline at the first node beyond a side reaches so far

  // dim = 2; x, y: m, inside the grid. Points outside it count for its nearest cell.
  void sort(const GridSpec& grid, std::span<const double> x, std::span<const double> y);

  const GridSpec& grid() const { return grid_; }
  // Sorted points, images among them: positions, and the number in what was sorted (negative: an image).
  const std::vector<double>& x() const { return x_; }
  const std::vector<double>& y() const { return y_; }
  const std::vector<int>& number() const { return number_; }
  // The cell along d of a coordinate, 0 ... cells - 1 for all inside.
  int cell(double position, int d) const {
    const auto k = static_cast<std::size_t>(d);
    const double logical = (position - grid_.origin[k]) / grid_.h;
    return static_cast<int>(std::clamp(std::floor(logical), 0.0, grid_.cells[k] - 1.0));
  }
  // Range of the sorted points in the cells (from ... to, j) of a row, cut where the margin ends.
  std::array<int, 2> row(int from, int to, int j) const;

 private:
  int padded(int d) const { return grid_.cells[static_cast<std::size_t>(d)] + 2 * margin; }
  int index(double position, int d) const;
  void add_images();

  GridSpec grid_;
  std::vector<double> all_x_, all_y_, x_, y_;
  std::vector<int> cell_, start_, number_;
  int own_ = 0;  // points that are no images
};

}  // namespace plumbline
