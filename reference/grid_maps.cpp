#include "reference/grid_maps.hpp"

#include <cmath>

#include "reference/elementary.hpp"

namespace plumbline::reference {
namespace {

struct Value {
  Bounded weight, gradient;
};

// The integral of the tent from far left, and the tent itself.
Bounded tent_integral(Bounded r) {
  if (r.value <= -1) return 0;
  if (r.value >= 1) return 1;
  const Bounded rest = Bounded(1) - abs(r), tail = rest * rest / 2;
  return r.value < 0 ? tail : Bounded(1) - tail;
}
Bounded tent(Bounded r) { return std::abs(r.value) < 1 ? Bounded(1) - abs(r) : Bounded(0); }

// Mean over the box, and of the tent's slope. (S. G. Bardenhagen, E. M. Kober, 2004, doi 10.3970/cmes.2004.005.477)
Value box_mean(Bounded r, double box) {
  const Bounded low = r - box / 2, high = r + box / 2;
  return {(tent_integral(high) - tent_integral(low)) / box, (tent(high) - tent(low)) / box};
}

// (M. Steffen, R. M. Kirby, M. Berzins, 2008, doi 10.1002/nme.2360)
Value quadratic_spline(Bounded r) {
  const Bounded a = abs(r);
  if (a.value <= 0.5) return {Bounded(0.75) - r * r, Bounded(-2) * r};
  if (a.value >= 1.5) return {};
  const Bounded rest = Bounded(1.5) - a;
  return {rest * rest / 2, r.value > 0 ? -rest : rest};
}

Value cubic_spline(Bounded r) {
  const Bounded a = abs(r);
  if (a.value >= 2) return {};
  const double sign = r.value > 0 ? 1 : -1;
  if (a.value >= 1) {
    const Bounded rest = Bounded(2) - a;
    return {rest * rest * rest / 6, Bounded(-0.5 * sign) * rest * rest};
  }
  return {Bounded(2) / 3 - a * a + a * a * a / 2, Bounded(sign) * (Bounded(1.5) * a * a - Bounded(2) * a)};
}

// At the distance r of the point from the node; `above` tells on which side of a tent's top it is.
Value shape_value(GridShape shape, Bounded r, bool above, double box) {
  if (shape == GridShape::boxes) return box_mean(r, box);
  if (shape == GridShape::quadratic) return quadratic_spline(r);
  if (shape == GridShape::cubic) return cubic_spline(r);
  return {tent(r), above ? -1 : 1};
}

Bounded inertia(GridShape shape, const PointWeights& at) {
  if (shape == GridShape::quadratic) return 0.25;
  if (shape == GridShape::cubic) return Bounded(1) / 3;
  Bounded sum;
  for (std::size_t k = 0; k < PointWeights::nodes; ++k) sum = sum + at.weight[k] * at.arm[k] * at.arm[k];
  return sum;
}

}  // namespace

PointWeights point_weights(GridShape shape, double x, double box) {
  PointWeights at;
  const int below = static_cast<int>(std::floor(x));
  at.first = below - 1;
  for (std::size_t k = 0; k < PointWeights::nodes; ++k) {
    const int node = at.first + static_cast<int>(k);
    if (shape == GridShape::linear && (node < below || node > below + 1)) continue;
    at.arm[k] = Bounded(node) - x;
    const Value value = shape_value(shape, -at.arm[k], node == below, box);
    at.weight[k] = value.weight;
    at.gradient[k] = value.gradient;
  }
  const Bounded own = inertia(shape, at);
  for (std::size_t k = 0; k < PointWeights::nodes; ++k) {
    at.affine[k] = shape == GridShape::linear ? at.gradient[k] : at.weight[k] * at.arm[k] / own;
  }
  return at;
}

Bounded blur(GridShape shape) {
  switch (shape) {
    case GridShape::linear:
      return Bounded(1) / 12;
    case GridShape::boxes:
      return Bounded(1) / 12 + Bounded(1) / 96;
    case GridShape::quadratic:
      return 0.125;
    case GridShape::cubic:
      break;
  }
  return Bounded(1) / 6;
}

}  // namespace plumbline::reference
