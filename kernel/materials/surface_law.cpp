#include "kernel/materials/surface_law.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace plumbline {
namespace {

using Metric = SurfaceLaw::Metric;
using State = SurfaceLaw::State;

// A symmetric 2 x 2 by its eigenvalues, low <= high, and the direction of the higher.
struct Principal {
  double low, high, cosine, sine;
  explicit Principal(const Metric& of) {
    const double mean = 0.5 * (of.first + of.second), half = 0.5 * (of.first - of.second);
    const double radius = std::hypot(half, of.mixed), angle = 0.5 * std::atan2(of.mixed, half);
    low = mean - radius;
    high = mean + radius;
    cosine = std::cos(angle);
    sine = std::sin(angle);
  }
};

}  // namespace

State SurfaceLaw::taut(const Metric& e) const {
  const double stiff = youngs_modulus / (1 - poissons_ratio * poissons_ratio), nu = poissons_ratio;
  const State s{0, stiff * (e.first + nu * e.second), stiff * (1 - nu) * e.mixed, stiff * (e.second + nu * e.first)};
  return {0.5 * (s.first * e.first + 2 * s.mixed * e.mixed + s.second * e.second), s.first, s.mixed, s.second};
}

State SurfaceLaw::state(const Metric& c) const {  // [Surface 2]
  if (neo_hookean) {
    const double mu = youngs_modulus / 3, per = 1 / c.determinant();
    return {0.5 * mu * (c.first + c.second + per - 3), mu * (1 - c.second * per * per), mu * c.mixed * per * per,
            mu * (1 - c.first * per * per)};
  }
  const Metric e{0.5 * (c.first - 1), 0.5 * c.mixed, 0.5 * (c.second - 1)};
  if (!one_way) return taut(e);
  const Principal p(e);
  if (p.high <= 0) return {};
  if (p.low + poissons_ratio * p.high >= 0) return taut(e);
  const double s = youngs_modulus * p.high;
  return {0.5 * s * p.high, s * p.cosine * p.cosine, s * p.cosine * p.sine, s * p.sine * p.sine};
}

// Of the resultant t S_ab f_a f_b / |f_1 x f_2| the trace is t S : c / root det c, and the determinant t^2 det S.
SurfaceLaw::Stresses SurfaceLaw::principal_stresses(const Metric& c) const {
  const State s = state(c);
  const double trace = s.first * c.first + 2 * s.mixed * c.mixed + s.second * c.second;
  const double mean = 0.5 * trace / std::sqrt(c.determinant());
  const double radius = std::sqrt(std::max(mean * mean - (s.first * s.second - s.mixed * s.mixed), 0.0));
  return {mean + radius, mean - radius};
}

// Of longitudinal waves along the longer stretch: those see the stress beside the stiffness.
double SurfaceLaw::wave_speed(const Metric& c) const {
  if (neo_hookean) {
    const double longest = Principal(c).high;
    return std::sqrt(youngs_modulus / 3 * (longest + 3 / c.determinant()) / density);
  }
  const Metric e{0.5 * (c.first - 1), 0.5 * c.mixed, 0.5 * (c.second - 1)};
  const Principal p(e);
  const double stiff = youngs_modulus / (1 - poissons_ratio * poissons_ratio), square = 1 + 2 * p.high;
  const double stress = std::max(stiff * (p.high + poissons_ratio * p.low), 0.0);
  return std::sqrt((stiff * square * square + stress * square) / density);
}

double SurfaceLaw::fastest_wave(const Columns& points, int first, int last) const {
  double fastest = 0;
  for (int p = first; p < last; ++p) fastest = std::max(fastest, wave_speed(metric_of(points, p)));
  return fastest;
}

void SurfaceLaw::refuse_what_cannot_work(int dim) const {
  if (dim != 3)
    throw std::invalid_argument("a membrane with two tangents lives in space, not in dimension " + std::to_string(dim));
  if (neo_hookean && one_way) {
    throw std::invalid_argument(
        "a membrane is neo_hookean or one_way: the law that wrinkles is of St. Venant, Kirchhoff");
  }
}

Metric metric_of(const Columns& points, int p) {
  Metric c{0, 0, 0};
  for (int d = 0; d < 3; ++d) {
    const double first = points(column::tangents, d)[p], second = points(column::tangents, 3 + d)[p];
    c.first += first * first;
    c.mixed += first * second;
    c.second += second * second;
  }
  return c;
}

Eigen::Vector3d place_of(const Columns& points, int p) {
  return {points(column::position, 0)[p], points(column::position, 1)[p], points(column::position, 2)[p]};
}

}  // namespace plumbline
