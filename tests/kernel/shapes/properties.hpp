// What every family of shape functions must satisfy, whatever its order.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace plumbline::shape_properties {

// A handful of operations on numbers of order one, each good to 1.1e-16.
inline constexpr double rounding = 4e-15;
inline constexpr int cells = 5;

// Places all over the grid in cells, both ends, node lines and cell middles included.
inline std::vector<double> places() {
  std::vector<double> all;
  for (int k = 0; k <= 20 * cells; ++k) all.push_back(k / 20.0);
  for (double x : {0.123456789, 2.71828, 3.14159265, 4.999999}) all.push_back(x);
  return all;
}

template <class Shape>
struct At {
  int node;
  double local;
  double n[Shape::support], g[Shape::support], a[Shape::support];
  explicit At(double x) {
    node = Shape::anchor(x, cells, local);
    Shape::weights(local, n);
    Shape::gradients(local, g);
    Shape::affine_weights(local, a);
  }
  double distance(int k) const { return k + Shape::first - local; }  // x_i - x_p in cells
};

template <class Shape>
void expect_partition_of_unity() {
  for (double x : places()) {
    const At<Shape> at(x);
    double sum = 0, gradient = 0;
    for (int k = 0; k < Shape::support; ++k) {
      EXPECT_GE(at.n[k], 0) << x;
      sum += at.n[k];
      gradient += at.g[k];
    }
    EXPECT_NEAR(sum, 1, rounding) << x;
    EXPECT_NEAR(gradient, 0, rounding) << x;
  }
}

// sum N_i x_i = x and sum x_i grad N_i = 1: fields that are linear in space come through unchanged.
template <class Shape>
void expect_linear_reproduction() {
  for (double x : places()) {
    const At<Shape> at(x);
    EXPECT_NEAR(at.node + at.local, x, rounding);
    double first_moment = 0, slope = 0;
    for (int k = 0; k < Shape::support; ++k) {
      first_moment += at.n[k] * at.distance(k);
      slope += at.g[k] * at.distance(k);
    }
    EXPECT_NEAR(first_moment, 0, rounding) << x;
    EXPECT_NEAR(slope, 1, rounding) << x;
  }
}

// D = sum N_i r_i^2, and a_i = N_i r_i / D wherever D does not vanish; sum a_i r_i = 1 everywhere. [EC-APIC 5]
template <class Shape>
void expect_inertia() {
  for (double x : places()) {
    const At<Shape> at(x);
    double second_moment = 0, slope = 0, sum = 0;
    for (int k = 0; k < Shape::support; ++k) {
      second_moment += at.n[k] * at.distance(k) * at.distance(k);
      slope += at.a[k] * at.distance(k);
      sum += at.a[k];
    }
    EXPECT_NEAR(Shape::inertia(at.local), second_moment, rounding) << x;
    EXPECT_NEAR(slope, 1, 2 * rounding) << x;
    EXPECT_NEAR(sum, 0, 2 * rounding) << x;
    for (int k = 0; k < Shape::support && second_moment > 1e-3; ++k) {
      EXPECT_NEAR(at.a[k] * second_moment, at.n[k] * at.distance(k), 2 * rounding) << x;
    }
  }
}

// Central differences with step d are off by d^2/6 |N'''| <= d^2/6 and by rounding 1e-16/d: below 2e-10 for d =
// 1e-5.
template <class Shape>
void expect_gradients_are_derivatives() {
  const double d = 1e-5;
  for (double f : {-0.4, -0.2, 0.1, 0.3, 0.45}) {
    const double local = Shape::first == 0 || Shape::support == 4 ? f + 0.5 : f;
    double low[Shape::support], high[Shape::support], g[Shape::support];
    Shape::weights(local - d, low);
    Shape::weights(local + d, high);
    Shape::gradients(local, g);
    for (int k = 0; k < Shape::support; ++k) EXPECT_NEAR(g[k], (high[k] - low[k]) / (2 * d), 2e-10);
  }
}

// Points at both ends of the grid reach `ghosts` node layers beyond it and not one more.
template <class Shape>
void expect_reach() {
  EXPECT_GE(At<Shape>(0.0).node + Shape::first, -Shape::ghosts);
  EXPECT_LE(At<Shape>(cells).node + Shape::first + Shape::support - 1, cells + Shape::ghosts);
}

// Weight of the node at distance u cells from the point, whichever anchor serves it.
template <class Shape>
double weight_at_distance(double u) {
  const At<Shape> there(2.0 + u);
  for (int k = 0; k < Shape::support; ++k) {
    if (there.node + Shape::first + k == 2) return there.n[k];
  }
  return 0;
}

}  // namespace plumbline::shape_properties
