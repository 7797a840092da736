// Where a box barely reaches a node, its weight is as precise as its gradient: no force throws so light a node away.
#include <gtest/gtest.h>

#include <cmath>

#include "kernel/shapes/gimp.hpp"

namespace plumbline::gimp_edge_test {
namespace {

// A box that reaches e beyond the anchor gives the next node e^2 / (4 l) and the gradient e / (2 l): their ratio g^2 / N
// is 1 / l however small e is. Lattices of two points a cell stand at f = l exactly. [GIMP 1]
TEST(GimpEdge, TheRatioOfGradientAndWeightIsBounded) {
  for (double l : {0.05, 0.125, 0.25, 0.4}) {
    for (double e = 1e-2; e > 1e-15; e /= 3) {
      for (int side : {-1, 1}) {
        const double f = side * (l - e);
        double n[3], g[3];
        Gimp::weights(f, l, n);
        Gimp::gradients(f, l, g);
        const int outer = side > 0 ? 0 : 2;
        if (g[outer] == 0) continue;  // e is lost in l
        ASSERT_GT(n[outer], 0) << l << ' ' << e;
        EXPECT_NEAR(g[outer] * g[outer] / n[outer] * l, 1, 1e-14) << l << ' ' << e;
      }
    }
  }
}

}  // namespace
}  // namespace plumbline::gimp_edge_test
