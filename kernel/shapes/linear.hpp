// Linear (tent) shape functions on one cell. [York 3.15, appendix A.3.1]
#pragma once

#include <cmath>

namespace plumbline {

struct Linear {
  static constexpr int support = 2;                // nodes per direction
  static constexpr int first = 0;                  // lowest node of the support, relative to the anchor node
  static constexpr int ghosts = 0;                 // node layers beyond a wall that a point inside can reach
  static constexpr bool smooth_gradients = false;  // across the sides of cells
  static constexpr bool fixed_inertia = false;     // D depends on where the point stands in its cell
  static constexpr int degree = 1;                 // of the B-splines
  static constexpr bool boxes = false;
  static constexpr double blur =
      1.0 / 12;  // theta of S(k) = 1 - theta k^2 h^2 + ...: half the variance of the shape [Sharpening 1]

  // The anchor node of a point at `x` (in cells from the first node line, 0 <= x <= cells), and its local coordinate.
  // A point on the last node line belongs to the last cell.
  template <class Number>
  static Number anchor_node(const Number& x, int cells) {
    using std::floor, std::min;
    return min(floor(x), Number(cells - 1.0));
  }
  static int anchor(double x, int cells, double& local) {
    const double node = anchor_node(x, cells);
    local = x - node;
    return static_cast<int>(node);
  }
  template <class Number>
  static void weights(const Number& f, Number (&w)[support]) {
    w[0] = 1.0 - f;
    w[1] = f;
  }
  // d N / d x in units of 1/h.
  template <class Number>
  static void gradients(const Number&, Number (&g)[support]) {
    g[0] = -1.0;
    g[1] = 1.0;
  }
  // The share of each node's kernel that lies above the point. [Pressure 4]
  template <class Number>
  static void above(const Number& f, Number (&c)[support]) {
    c[0] = 0.5 * (1.0 - f) * (1.0 - f);
    c[1] = 1.0 - 0.5 * f * f;
  }
  // D / h^2 = sum_i N_i r_i^2 / h^2 with r_i = x_i - x_p.
  template <class Number>
  static Number inertia(const Number& f) {
    return f * (1.0 - f);
  }
  // N_i r_i h / D: for tents this is the gradient, finite even where D vanishes.
  template <class Number>
  static void affine_weights(const Number& f, Number (&a)[support]) {
    gradients(f, a);
  }
};

}  // namespace plumbline
