#include "kernel/normals/colour_gradient.hpp"

#include "kernel/normals/directions.hpp"
#include "kernel/shapes/cubic.hpp"
#include "kernel/shapes/linear.hpp"
#include "kernel/shapes/quadratic.hpp"

namespace plumbline {
namespace {

// Lowest node, weights and gradients of a tent or spline along both axes.
template <class Shape>
struct Stencil {
  int i, j;
  double wx[Shape::support], wy[Shape::support], gx[Shape::support], gy[Shape::support];

  Stencil(double x, double y) {
    double f;
    // Cells are not cut at the last node line: images stand beyond it.
    const int beyond = 1 << 30;
    i = Shape::anchor(x, beyond, f) + Shape::first;
    Shape::weights(f, wx);
    Shape::gradients(f, gx);
    j = Shape::anchor(y, beyond, f) + Shape::first;
    Shape::weights(f, wy);
    Shape::gradients(f, gy);
  }
};

}  // namespace

void ColourGradient::add_all(std::span<const double> x, std::span<const double> y) {
  points_.sort(grid_, x, y);
  for (std::size_t p = 0; p < points_.x().size(); ++p) {
    const double i = logical(points_.x()[p], 0), j = logical(points_.y()[p], 1);
    // The cells along the rim lack neighbours, and nobody asks for their colours.
    const auto inside = [&](double at, std::size_t d) {
      return at >= 1 - PointCells::margin && at < grid_.cells[d] + PointCells::margin - 1;
    };
    if (inside(i, 0) && inside(j, 1)) add(i, j);
  }
}

void ColourGradient::find(const NormalsInput& input, std::span<double> normal_x, std::span<double> normal_y) {
  grid_ = input.grid;
  row_ = static_cast<std::size_t>(grid_.cells[0] + 2 * PointCells::margin + 1);
  const std::size_t nodes = row_ * static_cast<std::size_t>(grid_.cells[1] + 2 * PointCells::margin + 1);
  colour_.assign(nodes, 0);
  normal_.assign(nodes, {});
  add_all(input.x, input.y);
  add_all(input.other_x, input.other_y);
  finish();
  for (std::size_t p = 0; p < input.x.size(); ++p) {
    const Vector n = at(logical(input.x[p], 0), logical(input.y[p], 1));
    set_normal(input, p, n.x, n.y, normal_x, normal_y);
  }
}

void ColourGradient::add_gradients(double x, double y, double colour) {
  const Stencil<Linear> s(x, y);
  for (int b = 0; b < 2; ++b) {
    for (int a = 0; a < 2; ++a) {
      Vector& n = normal_[node(s.i + a, s.j + b)];
      n.x += s.gx[a] * s.wy[b] * colour;
      n.y += s.wx[a] * s.gy[b] * colour;
    }
  }
}

// n_p = sum_i n_i N_i(x_p) [York 7.3]
auto ColourGradient::at(double x, double y) const -> Vector {
  const Stencil<Linear> s(x, y);
  Vector sum;
  for (int b = 0; b < 2; ++b) {
    for (int a = 0; a < 2; ++a) {
      const Vector& n = normal_[node(s.i + a, s.j + b)];
      sum.x += n.x * s.wx[a] * s.wy[b];
      sum.y += n.y * s.wx[a] * s.wy[b];
    }
  }
  return sum;
}

// n_i = sum_p G_ip chi_p [York 7.2]
void YorkSimple::add(double x, double y) { add_gradients(x, y, 1); }

// chi_c = sum_p chi_p S2_c(x_p) [York 7.4]
void YorkQuadratic::add(double x, double y) {
  const Stencil<Quadratic> s(x - 0.5, y - 0.5);
  for (int b = 0; b < 3; ++b) {
    for (int a = 0; a < 3; ++a) colour_[node(s.i + a, s.j + b)] += s.wx[a] * s.wy[b];
  }
}

// n_i = sum_c G_ci chi_c [York 7.5]
void YorkQuadratic::finish() {
  for (int j = -1; j <= grid_.cells[1]; ++j) {
    for (int i = -1; i <= grid_.cells[0]; ++i) add_gradients(i + 0.5, j + 0.5, colour_[node(i, j)]);
  }
}

// chi_i = sum_p chi_p S3_i(x_p) [York 7.6]
void YorkCubic::add(double x, double y) {
  const Stencil<Cubic> s(x, y);
  for (int b = 0; b < 4; ++b) {
    for (int a = 0; a < 4; ++a) colour_[node(s.i + a, s.j + b)] += s.wx[a] * s.wy[b];
  }
}

// n_p = sum_i grad S3_i(x_p) chi_i [York 7.7]
auto YorkCubic::at(double x, double y) const -> Vector {
  const Stencil<Cubic> s(x, y);
  Vector sum;
  for (int b = 0; b < 4; ++b) {
    for (int a = 0; a < 4; ++a) {
      const double chi = colour_[node(s.i + a, s.j + b)];
      sum.x += chi * s.gx[a] * s.wy[b];
      sum.y += chi * s.wx[a] * s.gy[b];
    }
  }
  return sum;
}

}  // namespace plumbline
