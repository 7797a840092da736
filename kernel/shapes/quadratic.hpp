// Quadratic B-splines centred on the nodes. [York A.3.2]
#pragma once

#include <cmath>

namespace plumbline {

struct Quadratic {
  static constexpr int support = 3, first = -1, ghosts = 1;
  static constexpr bool smooth_gradients = true;
  static constexpr bool fixed_inertia = true;
  static constexpr int degree = 2;  // of the B-splines
  static constexpr bool boxes = false;
  static constexpr double blur =
      1.0 / 8;  // theta of S(k) = 1 - theta k^2 h^2 + ...: half the variance of the shape [Sharpening 1]

  // The nearest node, and the distance to it in cells: -1/2 <= local <= 1/2.
  template <class Number>
  static Number anchor_node(const Number& x, int) {
    using std::floor;
    return floor(x + 0.5);
  }
  static int anchor(double x, int cells, double& local) {
    const double node = anchor_node(x, cells);
    local = x - node;
    return static_cast<int>(node);
  }
  template <class Number>
  static void weights(const Number& f, Number (&w)[support]) {
    w[0] = 0.5 * (0.5 - f) * (0.5 - f);
    w[1] = 0.75 - f * f;
    w[2] = 0.5 * (0.5 + f) * (0.5 + f);
  }
  template <class Number>
  static void gradients(const Number& f, Number (&g)[support]) {
    g[0] = f - 0.5;
    g[1] = -2.0 * f;
    g[2] = f + 0.5;
  }
  // The share of each node's kernel that lies above the point. [Pressure 4]
  template <class Number>
  static void above(const Number& f, Number (&c)[support]) {
    const Number below = 0.5 - f, beyond = 0.5 + f;
    c[0] = below * below * below / 6.0;
    c[1] = 0.5 - f * (0.75 - f * f / 3.0);
    c[2] = 1.0 - beyond * beyond * beyond / 6.0;
  }
  template <class Number>
  static Number inertia(const Number&) {
    return 0.25;
  }  // [EC-APIC 5] D = h^2/4
  template <class Number>
  static void affine_weights(const Number& f, Number (&a)[support]) {
    weights(f, a);
    for (int k = 0; k < support; ++k) a[k] *= 4.0 * (k + first) - 4.0 * f;
  }
};

}  // namespace plumbline
