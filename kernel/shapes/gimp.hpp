// Tents averaged over the point's own box, uniform GIMP: half sizes stay; contiguous: they follow the deformation.
//   N_ip = 1/(2 l) int_{x_p - l}^{x_p + l} N(x - x_i) dx,  dN_ip/dx = (N(x_p + l - x_i) - N(x_p - l - x_i)) / (2 l)  [GIMP 1]
// (Bardenhagen, Kober 2004, doi 10.3970/cmes.2004.005.477; Wallstedt, Guilkey 2008, doi 10.1016/j.jcp.2008.07.019)
#pragma once

#include <cmath>

namespace plumbline {

struct Gimp {
  static constexpr int support = 3, first = -1, ghosts = 1;
  static constexpr bool smooth_gradients = true;
  static constexpr bool fixed_inertia = false;
  static constexpr bool boxes = true;  // points have half sizes
  // Half sizes l in cells. A box wider than a cell would reach a fourth node and is cut; one of no width would make 0/0 of
  // the averages, which then are those of tents.
  static constexpr double widest = 0.5, narrowest = 1e-3;
  static constexpr double usual_half = 0.25;  // two points a cell
  // theta of S(k) = 1 - theta k^2 h^2 + ...: half the variance of the shape, 1/6 + l^2/3 [Sharpening 1]
  static constexpr double blur = (1.0 / 6 + usual_half * usual_half / 3) / 2;

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
  // f: local coordinate from the anchor node, -1/2 <= f <= 1/2; l: half size. Both in cells. The share u of the box that
  // lies on a node's side of the anchor gives an outer node l u^2, and f - l more once the whole box does; its gradient is
  // u. Differences of integrals would be the same, but lose the ratio g^2 / N = 1 / l where u is small: a node at the very
  // edge of a box would be so light that any force throws it away. [GIMP 1]
  template <class Number>
  [[gnu::always_inline]] static void weights(const Number& f, const Number& l, Number (&w)[support]) {
    using std::max;
    Number below, above;
    shares(f, l, below, above);
    w[0] = l * below * below + max(Number(-f - l), Number(0.0));
    w[2] = l * above * above + max(Number(f - l), Number(0.0));
    w[1] = 1.0 - w[0] - w[2];
  }
  // d N / d x in units of 1/h.
  template <class Number>
  [[gnu::always_inline]] static void gradients(const Number& f, const Number& l, Number (&g)[support]) {
    Number below, above;
    shares(f, l, below, above);
    g[0] = -below;
    g[2] = above;
    g[1] = -g[0] - g[2];
  }
  // D / h^2 = sum_i N_i r_i^2 / h^2 with r_i = x_i - x_p, of which sum_i N_i = 1 leaves terms that are never negative.
  template <class Number>
  [[gnu::always_inline]] static Number inertia(const Number& f, const Number& l) {
    Number w[support];
    weights(f, l, w);
    return f * f + w[0] * (1.0 + 2.0 * f) + w[2] * (1.0 - 2.0 * f);
  }
  // N_i r_i h / D. D is f (1 - f) where the box reaches no node and l / 2 at a node, never zero.
  template <class Number>
  [[gnu::always_inline]] static void affine_weights(const Number& f, const Number& l, Number (&a)[support]) {
    weights(f, l, a);
    using std::max;
    // Lanes of a pack that hold no point of the bin may be far from all its nodes; their zeros must stay zeros.
    const Number inverse = 1.0 / max(inertia(f, l), Number(narrowest / 4));
    for (int k = 0; k < support; ++k) a[k] *= inverse * (static_cast<double>(k + first) - f);
  }
  // The same at x cells from the first node line.
  template <class Number>
  [[gnu::always_inline]] static Number inertia_at(const Number& x, const Number& l) {
    using std::floor;
    return inertia(Number(x - floor(x + 0.5)), l);
  }

  // For those who ask for shapes without a point.
  template <class Number>
  static void weights(const Number& f, Number (&w)[support]) {
    weights(f, Number(usual_half), w);
  }

 private:
  // Of a box of half size l, what lies below and above the anchor.
  template <class Number>
  [[gnu::always_inline]] static void shares(const Number& f, const Number& l, Number& below, Number& above) {
    using std::max, std::min;
    const Number per_width = 0.5 / l;
    below = min(max(Number((l - f) * per_width), Number(0.0)), Number(1.0));
    above = min(max(Number((l + f) * per_width), Number(0.0)), Number(1.0));
  }
};

}  // namespace plumbline
