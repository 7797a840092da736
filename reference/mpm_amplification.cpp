#include "reference/mpm_amplification.hpp"

#include <cmath>
#include <queue>

#include "reference/argument.hpp"
#include "reference/circle.hpp"
#include "reference/elementary.hpp"
#include "reference/grid_maps.hpp"
#include "reference/linear_step.hpp"
#include "reference/nodal_filter.hpp"

namespace plumbline::reference {
namespace {

using Complex = std::complex<double>;
constexpr int reach = PointWeights::nodes;

void check_layout(const MapScheme& scheme, const std::vector<double>& points) {
  if (points.empty()) throw ParameterError("points", 0, "at least one");
  for (double x : points) check_finite("points", x);
  check_within("order", scheme.order, 1, 1000);
  check_within("sharpening", scheme.sharpening, 0, 1);
}

// A value and its derivative by s.
struct Slope {
  Slope(Bounded value_, Bounded slope_ = 0) : value(value_), slope(slope_) {}
  explicit Slope(int value_) : value(value_) {}
  Bounded value, slope;
};
Slope operator+(Slope a, Slope b) { return {a.value + b.value, a.slope + b.slope}; }
Slope operator-(Slope a, Slope b) { return {a.value - b.value, a.slope - b.slope}; }
Slope operator*(Slope a, Slope b) { return {a.value * b.value, a.slope * b.value + a.value * b.slope}; }
Slope operator/(Slope a, Slope b) {
  const Bounded ratio = a.value / b.value;
  return {ratio, (a.slope - ratio * b.slope) / b.value};
}

// sum over the points of |sum_j u_j e^(i j theta)|^2, u = f or the product of f and g, as a polynomial of
// s = sin^2(theta/2).
class Correlation {
 public:
  void add(const std::array<Bounded, reach>& f, const std::array<Bounded, reach>& g, double mass) {
    static constexpr int cosine[reach][reach] = {{1}, {1, -2}, {1, -8, 8}, {1, -18, 48, -32}};  // of d theta, in s
    for (int i = 0; i < reach; ++i) {
      for (int j = 0; j < reach; ++j) {
        const Bounded product = Bounded(mass) * f[static_cast<std::size_t>(i)] * g[static_cast<std::size_t>(j)];
        for (int power = 0; power <= std::abs(i - j); ++power) {
          Bounded& term = terms_[static_cast<std::size_t>(power)];
          term = term + Bounded(cosine[std::abs(i - j)][power]) * product;
        }
      }
    }
  }
  template <class Number>
  Number at(const Number& s) const {
    Number sum(terms_[reach - 1]);
    for (std::size_t power = reach - 1; power-- > 0;) sum = sum * s + Number(terms_[power]);
    return sum;
  }

 private:
  std::array<Bounded, reach> terms_;
};

// B and K of [Stability 4] for waves on a layout of one cell, which has one node: numbers.
class Waves {
 public:
  Waves(const MapScheme& scheme, const std::vector<double>& points) : scheme_(scheme) {
    check_layout(scheme, points);
    const double mass = 1.0 / static_cast<double>(points.size());
    sharpening_ = Bounded(4 * scheme.sharpening) * blur(scheme.shape);
    for (double x : points) {
      const PointWeights at = point_weights(scheme.shape, x, mass);
      kept_.add(at.weight, at.weight, mass);
      stiffness_.add(at.gradient, at.gradient, mass);
      if (scheme.transfer != GridTransfer::apic) continue;
      std::array<Bounded, reach> turned;
      for (std::size_t k = 0; k < reach; ++k) turned[k] = at.weight[k] * at.arm[k];
      kept_.add(turned, at.affine, mass);
    }
  }
  template <class Number>
  Number kept(const Number& s) const {
    return kept_.at(s);
  }
  template <class Number>
  Number stiffness(const Number& s) const {
    const Number sharpened = Number(1) + Number(sharpening_) * s;
    return stiffness_.at(s) * sharpened * sharpened;
  }
  // 1/C^2 of this wave.
  template <class Number>
  Number burden(const Number& s) const {
    const Number b = kept(s), part = b * stiffness_share(scheme_, b);
    const bool last = scheme_.update == StressUpdate::last;
    return stiffness(s) * (last ? Number(Bounded(0.5)) - part : part);  // [Stability 5]
  }

 private:
  const MapScheme& scheme_;
  Correlation kept_, stiffness_;
  Bounded sharpening_;
};

// The largest value of `burden` for 0 <= s <= 1, by halving the interval that may hide the largest.
class Greatest {
 public:
  explicit Greatest(const Waves& waves) : waves_(waves) {
    probe(0);
    probe(1);
    look(0, 1);
  }
  Bounded value() {
    // Where rounding is most of what may be hidden, halving shows no more.
    for (int i = 0; i < most && open_.top().highest - found_ > 1e-13 * found_ + 4 * open_.top().rounded; ++i) {
      const Interval widest = open_.top();
      open_.pop();
      const double middle = 0.5 * (widest.left + widest.right);
      look(widest.left, middle);
      look(middle, widest.right);
    }
    const double half = 0.5 * (std::max(open_.top().highest, found_) - found_);
    return {found_ + half, (half + rounding::unit * found_) * rounding::inflate};
  }

 private:
  struct Interval {
    double left, right, highest, rounded;
    bool operator<(const Interval& other) const { return highest < other.highest; }
  };
  static constexpr int most = 20000;

  Bounded probe(double s) {
    const Bounded here = waves_.burden(Bounded(s));
    if (std::isfinite(here.bound)) found_ = std::max(found_, lowest(here));
    return here;
  }
  void look(double left, double right) {
    const double middle = 0.5 * (left + right), radius = 0.5 * (right - left) * rounding::inflate;
    const Bounded slope = waves_.burden(Slope({middle, radius}, 1)).slope, here = probe(middle);
    const double most_here = highest(here) + (std::abs(slope.value) + slope.bound) * radius * rounding::inflate;
    open_.push({left, right, std::isfinite(most_here) ? most_here : rounding::infinity, here.bound});
  }

  const Waves& waves_;
  double found_ = 0;
  std::priority_queue<Interval> open_;
};

Bounded limit_of(Bounded burden) { return Bounded(1) / sqrt(burden); }

// The larger root in magnitude of z^2 - trace z + determinant.
Bounded larger_root(Bounded trace, Bounded determinant) {
  const Bounded half = trace / 2, square = half * half - determinant;
  if (highest(square) < 0) return sqrt(determinant);
  const Bounded real = abs(half) + sqrt(square);
  return lowest(square) > 0 ? real : hull(real, sqrt(determinant));
}

}  // namespace

std::vector<double> regular_points(int per_cell, double offset) {
  check_within("per_cell", per_cell, 1, 1000);
  std::vector<double> points;
  for (int i = 0; i < per_cell; ++i) points.push_back((i + 0.5) / per_cell + offset);
  return points;
}

ComplexMatrix amplification_matrix(const MapScheme& scheme, const std::vector<double>& points, double theta,
                                   double courant) {
  check_layout(scheme, points);
  check_positive("courant", courant);
  const int count = static_cast<int>(points.size());
  const Dense<Complex> column(count, 1), one = selection<Complex>(1, 1, 0);
  const double s = std::pow(std::sin(theta / 2), 2), mass = 1.0 / count;
  const double sharpen = 1 + 4 * scheme.sharpening * blur(scheme.shape).value * s;
  GridMaps<Complex> maps{column, column,        column, column,
                         one,    sharpen * one, mass};  // a node carries the mass of a cell
  for (int p = 0; p < count; ++p) {
    const PointWeights at = point_weights(scheme.shape, points[static_cast<std::size_t>(p)], mass);
    for (std::size_t k = 0; k < reach; ++k) {
      const Complex phase = std::polar(1.0, theta * (at.first + static_cast<int>(k)));
      maps.weight(p, 0) += phase * at.weight[k].value;
      maps.gradient(p, 0) += phase * at.gradient[k].value;
      maps.arm(p, 0) += phase * at.weight[k].value * at.arm[k].value;
      maps.affine(p, 0) += phase * at.affine[k].value;
    }
  }
  return LinearStep<Complex>(scheme, maps, courant).matrix();
}

Bounded wave_growth(const MapScheme& scheme, const std::vector<double>& points, double theta, double courant) {
  check_finite("theta", theta);
  check_positive("courant", courant);
  const Waves waves(scheme, points);
  const Bounded sine = sin(Bounded(theta) / 2), s = sine * sine, square = Bounded(courant) * courant;
  const Bounded b = waves.kept(s), pull = square * waves.stiffness(s);
  const NodalFilter<Bounded> filter = nodal_filter(scheme, b);
  const Bounded pushed = b * filter.share * pull;
  const Bounded both = Bounded(1) + filter.keeps;
  if (scheme.update != StressUpdate::last) return larger_root(both - pushed, filter.keeps);
  return larger_root(both - pull, filter.keeps * (Bounded(1) - pull) + pushed);
}

Bounded periodic_courant_limit(const MapScheme& scheme, const std::vector<double>& points) {
  return limit_of(Greatest(Waves(scheme, points)).value());
}

WorstOffset worst_rigid_offset(const MapScheme& scheme, int per_cell) {
  constexpr int samples = 200;
  const double step = 1.0 / per_cell / samples;
  auto limit = [&](double offset) { return periodic_courant_limit(scheme, regular_points(per_cell, offset)); };
  WorstOffset worst{0, limit(0)};
  auto look = [&](double offset) {
    const Bounded here = limit(offset);
    if (certainly_below(here, worst.limit)) worst = {offset, here};
  };
  for (int i = 1; i < samples; ++i) look(i * step);
  for (double width = step / 2; width > 1e-9 / per_cell; width /= 2) {
    const double centre = worst.offset;
    look(centre - width);
    look(centre + width);
  }
  return worst;
}

}  // namespace plumbline::reference
