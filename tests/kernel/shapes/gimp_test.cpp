#include "kernel/shapes/gimp.hpp"

#include <algorithm>

#include "tests/kernel/shapes/properties.hpp"

namespace plumbline::gimp_test {
namespace {

using shape_properties::rounding;

constexpr double halves[] = {Gimp::narrowest, 0.03, 0.1, 0.25, 0.3, 0.45, Gimp::widest};
const std::vector<double>& places() {
  static const std::vector<double> all{-0.5, -0.499, -0.4, -0.25, -0.1, -1e-4, 0.0, 0.02, 0.1, 0.25, 0.37, 0.5};
  return all;
}
// Weights and gradients are differences of numbers of order one over 2 l: a handful of roundings over that.
double rounding_of(double l) { return rounding / (2 * l); }

double tent(double u) { return std::max(0.0, 1 - std::abs(u)); }

// The mean of f over the box from x - l to x + l. Tents, and products of them with x, are polynomials of low degree between
// the kinks at whole numbers: Simpson's rule is exact there.
template <class Function>
double mean_over_box(double x, double l, Function&& f) {
  std::vector<double> ends{x - l, x + l};
  for (double kink = -3; kink <= 3; ++kink) {
    if (kink > x - l && kink < x + l) ends.push_back(kink);
  }
  std::sort(ends.begin(), ends.end());
  double sum = 0;
  for (std::size_t k = 1; k < ends.size(); ++k) {
    const double a = ends[k - 1], b = ends[k];
    sum += (b - a) / 6 * (f(a) + 4 * f((a + b) / 2) + f(b));
  }
  return sum / (2 * l);
}

struct Of {
  double n[3], g[3], a[3], d, f, l;
  Of(double place, double half) : f(place), l(half) {
    Gimp::weights(f, l, n);
    Gimp::gradients(f, l, g);
    Gimp::affine_weights(f, l, a);
    d = Gimp::inertia(f, l);
  }
  double distance(int k) const { return k - 1 - f; }  // x_i - x_p in cells
};

template <class Check>
void everywhere(Check&& check) {
  for (double l : halves) {
    for (double f : places()) {
      SCOPED_TRACE(testing::Message() << "f " << f << ", l " << l);
      check(Of(f, l));
    }
  }
}

// sum N = 1, sum grad N = 0; sum N x_i = x, sum x_i grad N = 1. [GIMP 1]
TEST(Gimp, PartitionOfUnityKeepsLinearFields) {
  everywhere([](const Of& at) {
    double sum = 0, gradient = 0, moment = 0, slope = 0;
    for (int k = 0; k < 3; ++k) {
      EXPECT_GE(at.n[k], 0);
      sum += at.n[k];
      gradient += at.g[k];
      moment += at.n[k] * at.distance(k);
      slope += at.g[k] * at.distance(k);
    }
    EXPECT_NEAR(sum, 1, rounding_of(at.l));
    EXPECT_NEAR(gradient, 0, rounding_of(at.l));
    EXPECT_NEAR(moment, 0, rounding_of(at.l));
    EXPECT_NEAR(slope, 1, 2 * rounding_of(at.l));
  });
}

// The mean of the tents over the box, and that of their slopes, integrated piece by piece. [GIMP 1]
TEST(Gimp, IsTheMeanOfTentsOverTheBox) {
  everywhere([](const Of& at) {
    for (int k = 0; k < 3; ++k) {
      const double node = k - 1;
      EXPECT_NEAR(at.n[k], mean_over_box(at.f, at.l, [&](double y) { return tent(y - node); }), rounding_of(at.l));
    }
  });
}

// Central differences of a piecewise parabola are exact but where a kink lies between, and rounding over d. [GIMP 1]
TEST(Gimp, GradientsAreDerivatives) {
  const double d = 1e-5;
  for (double l : {0.1, 0.25, 0.4, 0.5}) {
    for (double f : {-0.41, -0.2, 0.05, 0.13, 0.3, 0.45}) {
      double low[3], high[3], g[3];
      Gimp::weights(f - d, l, low);
      Gimp::weights(f + d, l, high);
      Gimp::gradients(f, l, g);
      for (int k = 0; k < 3; ++k) EXPECT_NEAR(g[k], (high[k] - low[k]) / (2 * d), 1e-9) << f << ' ' << l;
    }
  }
}

// A box of no width leaves the tents: the mean over it differs by its share of the kink, at most l/2. [GIMP 1]
TEST(Gimp, NarrowBoxesLeaveTents) {
  for (double l : {0.1, 0.01, Gimp::narrowest}) {
    double largest = 0;
    for (double f : places()) {
      const Of at(f, l);
      for (int k = 0; k < 3; ++k) largest = std::max(largest, std::abs(at.n[k] - tent(at.distance(k))));
      if (std::abs(f) < l) continue;
      for (int k = 0; k < 3; ++k) EXPECT_NEAR(at.n[k], tent(at.distance(k)), rounding_of(l)) << f << ' ' << l;
    }
    EXPECT_NEAR(largest, l / 2, rounding_of(l));  // at the node itself
  }
}

// D = sum N r^2: f (1 - f) wherever the box reaches no node, whatever its width, l/2 at a node; N r / D is what turns the
// nodes' velocities into C, and reproduces a linear field. [GIMP 1] [EC-APIC 5]
TEST(Gimp, InertiaIsTheSecondMoment) {
  everywhere([](const Of& at) {
    double second = 0, slope = 0, sum = 0;
    for (int k = 0; k < 3; ++k) {
      second += at.n[k] * at.distance(k) * at.distance(k);
      slope += at.a[k] * at.distance(k);
      sum += at.a[k];
      EXPECT_NEAR(at.a[k] * at.d, at.n[k] * at.distance(k), 2 * rounding_of(at.l));
    }
    EXPECT_NEAR(at.d, second, rounding_of(at.l));
    // Over D, which is at least l/2.
    EXPECT_NEAR(slope, 1, 4 * rounding_of(at.l) / at.d);
    EXPECT_NEAR(sum, 0, 4 * rounding_of(at.l) / at.d);
    const double u = std::abs(at.f);
    if (u >= at.l) {
      EXPECT_NEAR(at.d, u * (1 - u), 2 * rounding_of(at.l));
    }
    if (u == 0) {
      EXPECT_NEAR(at.d, at.l / 2, rounding_of(at.l));
    }
    EXPECT_GE(at.d, at.l / 2 - rounding_of(at.l));
  });
}

// The same from any place of the grid.
TEST(Gimp, InertiaAtAPlace) {
  for (double x : {0.0, 0.2, 0.5, 0.51, 2.7, 4.0, 5.0}) {
    double local;
    Gimp::anchor(x, 5, local);
    EXPECT_EQ(Gimp::inertia_at(x, 0.3), Gimp::inertia(local, 0.3)) << x;
    EXPECT_NEAR(Gimp::inertia_at(x + 1, 0.3), Gimp::inertia_at(x, 0.3), 4 * rounding);
  }
}

// Points at both ends of the grid, with the widest box, reach one layer of nodes beyond it and not more; half way between
// nodes either anchor gives the same weights. [GIMP 1]
TEST(Gimp, ReachesNoFurtherThanItsGhosts) {
  double local;
  EXPECT_EQ(Gimp::anchor(0.0, 5, local) + Gimp::first, -Gimp::ghosts);
  EXPECT_EQ(Gimp::anchor(5.0, 5, local) + Gimp::first + Gimp::support - 1, 5 + Gimp::ghosts);
  for (double l : halves) {
    const Of below(0.5, l), above(-0.5, l);
    EXPECT_EQ(below.n[0], 0);
    EXPECT_EQ(above.n[2], 0);
    for (int k = 0; k < 2; ++k) {
      EXPECT_NEAR(below.n[k + 1], above.n[k], rounding_of(l));
      EXPECT_NEAR(below.g[k + 1], above.g[k], rounding_of(l));
    }
  }
}

// Half the variance of the shape, 1/6 of the tent and l^2/3 of the box. [Sharpening 1]
TEST(Gimp, BlurIsHalfTheVariance) {
  const double l = Gimp::usual_half;
  const int pieces = 400;
  double variance = 0;
  for (int k = 0; k < 3 * pieces; ++k) {  // midpoint rule: off by 3 (1/400)^2 / 24 of a second derivative below 20
    const double y = -1.5 + (k + 0.5) / pieces;
    variance += y * y * mean_over_box(y, l, tent) / pieces;
  }
  EXPECT_NEAR(Gimp::blur, variance / 2, 1e-5);
}

}  // namespace
}  // namespace plumbline::gimp_test
