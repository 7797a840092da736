// Cubic B-splines centred on the nodes. (Steffen, Kirby, Berzins 2008, doi 10.1002/nme.2360)
#pragma once

#include <cmath>

namespace plumbline {

struct Cubic {
  static constexpr int support = 4, first = -1, ghosts = 1;
  static constexpr bool smooth_gradients = true;
  static constexpr bool fixed_inertia = true;
  static constexpr int degree = 3;  // of the B-splines
  static constexpr bool boxes = false;
  static constexpr double blur =
      1.0 / 6;  // theta of S(k) = 1 - theta k^2 h^2 + ...: half the variance of the shape [Sharpening 1]

  // The node below the point, and the distance above it in cells: 0 <= local <= 1.
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
    const Number b = 1.0 - f;
    w[0] = b * b * b / 6.0;
    w[1] = 2.0 / 3.0 - f * f + 0.5 * f * f * f;
    w[2] = 2.0 / 3.0 - b * b + 0.5 * b * b * b;
    w[3] = f * f * f / 6.0;
  }
  template <class Number>
  static void gradients(const Number& f, Number (&g)[support]) {
    const Number b = 1.0 - f;
    g[0] = -0.5 * b * b;
    g[1] = -2.0 * f + 1.5 * f * f;
    g[2] = 2.0 * b - 1.5 * b * b;
    g[3] = 0.5 * f * f;
  }
  // The share of each node's kernel that lies above the point. [Pressure 4]
  template <class Number>
  static void above(const Number& f, Number (&c)[support]) {
    const Number b = 1.0 - f;
    c[0] = b * b * b * b / 24.0;
    c[1] = 0.5 - f * (2.0 / 3.0 - f * f * (1.0 / 3.0 - f / 8.0));
    c[2] = 0.5 + b * (2.0 / 3.0 - b * b * (1.0 / 3.0 - b / 8.0));
    c[3] = 1.0 - f * f * f * f / 24.0;
  }
  template <class Number>
  static Number inertia(const Number&) {
    return 1.0 / 3.0;
  }  // [EC-APIC 5] D = h^2/3
  template <class Number>
  static void affine_weights(const Number& f, Number (&a)[support]) {
    weights(f, a);
    for (int k = 0; k < support; ++k) a[k] *= 3.0 * (k + first) - 3.0 * f;
  }
};

}  // namespace plumbline
