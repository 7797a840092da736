// Normals as the gradient of a colour that is one on all points. [York 7.1-7.3, text]
#pragma once

#include <vector>

#include "kernel/normals/normals.hpp"
#include "kernel/normals/point_cells.hpp"

namespace plumbline {

// Colours and gradients on the nodes of the grid and of the margin around it, row by row along x. A gradient needs
// colour on one side alone: without points inside the membrane these methods see the same colour on both.
class ColourGradient : public NormalsMethod {
 public:
  bool sees_others() const override { return true; }
  void find(const NormalsInput& input, std::span<double> normal_x, std::span<double> normal_y) override;

 protected:
  struct Vector {
    double x = 0, y = 0;
  };
  // Node of the arrays at index (i, j) of the grid, both at least -margin.
  std::size_t node(int i, int j) const {
    return static_cast<std::size_t>(j + PointCells::margin) * row_ + static_cast<std::size_t>(i + PointCells::margin);
  }
  double logical(double position, int d) const {
    return (position - grid_.origin[static_cast<std::size_t>(d)]) / grid_.h;
  }
  // What a point adds to the grid, at (x, y) in cells from the first node line.
  virtual void add(double x, double y) = 0;
  // Once all have been added.
  virtual void finish() {}
  // The gradient at a point, up to a factor. Here: of the nodes, by linear shapes. [York 7.3]
  virtual Vector at(double x, double y) const;

  // Adds n_i to the nodes of the cell that (x, y) lies in: a colour there times the gradients of linear shapes, with
  // sign +1 the sum of (7.2).
  void add_gradients(double x, double y, double colour);

  GridSpec grid_;
  std::vector<double> colour_;
  std::vector<Vector> normal_;  // n_i

 private:
  void add_all(std::span<const double> x, std::span<const double> y);

  PointCells points_;
  std::size_t row_ = 0;
};

struct YorkSimple final : ColourGradient {
  void add(double x, double y) override;
};

// Colours stand at cell centres, numbered as the cell's lowest node.
struct YorkQuadratic final : ColourGradient {
  void add(double x, double y) override;
  void finish() override;
};

struct YorkCubic final : ColourGradient {
  void add(double x, double y) override;
  Vector at(double x, double y) const override;
};

}  // namespace plumbline
