// Weights on the nodes: sums, moments, slopes, and what the affine weights give back.
#include "reference/grid_maps.hpp"

#include "tests/reference/checks.hpp"

namespace plumbline::reference::grid_maps_test {
namespace {

constexpr GridShape shapes[] = {GridShape::linear, GridShape::boxes, GridShape::quadratic, GridShape::cubic};
constexpr double places[] = {-2.6, 0, 0.1, 0.25, 0.4999, 0.5, 0.75, 1.9, 3};

Bounded sum(const std::array<Bounded, PointWeights::nodes>& of) {
  Bounded total;
  for (Bounded value : of) total = total + value;
  return total;
}

double weight_on(GridShape shape, double x, double box, int node) {
  const PointWeights at = point_weights(shape, x, box);
  const int k = node - at.first;
  return k < 0 || k >= PointWeights::nodes ? 0 : at.weight[static_cast<std::size_t>(k)].value;
}

TEST(GridMaps, UnityAndLinearFieldsAreKept) {
  for (GridShape shape : shapes) {
    for (double x : places) {
      const PointWeights at = point_weights(shape, x, 0.5);
      expect_zero(sum(at.weight) - 1, 1, "sum of weights");
      expect_zero(sum(at.gradient), 1, "sum of gradients");
      Bounded moment, slope;
      for (std::size_t k = 0; k < PointWeights::nodes; ++k) {
        moment = moment + at.weight[k] * at.arm[k];
        slope = slope + at.gradient[k] * at.arm[k];
      }
      expect_zero(moment, 1, "first moment");
      expect_zero(slope - 1, 1, "slope of x");
    }
  }
}

TEST(GridMaps, GradientsAreSlopesOfWeights) {
  for (GridShape shape : shapes) {
    for (double x : {-2.6, 0.1, 0.26, 0.51, 0.77, 1.9}) {
      const PointWeights at = point_weights(shape, x, 0.4);
      for (std::size_t k = 0; k < PointWeights::nodes; ++k) {
        const int node = at.first + static_cast<int>(k);
        const double h = 1e-5;  // errors h^2/6 of a third derivative of 3 at most
        const double slope = (weight_on(shape, x + h, 0.4, node) - weight_on(shape, x - h, 0.4, node)) / (2 * h);
        EXPECT_NEAR(at.gradient[k].value, slope, 1e-9);
      }
    }
  }
}

TEST(GridMaps, AffineWeightsGiveASlopeBack) {
  for (GridShape shape : shapes) {
    for (double x : places) {
      const PointWeights at = point_weights(shape, x, 0.5);
      Bounded back;
      for (std::size_t k = 0; k < PointWeights::nodes; ++k) back = back + at.affine[k] * at.arm[k];
      expect_zero(back - 1, 1, "slope of an affine field", 1e-10);
    }
  }
}

TEST(GridMaps, BoxesAreMeansOfTents) {
  const double x = 0.9, box = 0.4;
  for (int node : {0, 1, 2}) {
    double mean = 0;
    const int n = 4000;
    for (int i = 0; i < n; ++i) mean += weight_on(GridShape::linear, x + box * ((i + 0.5) / n - 0.5), 0, node) / n;
    EXPECT_NEAR(weight_on(GridShape::boxes, x, box, node), mean, 1e-7);  // midpoints around a kink: 1/n^2
  }
}

TEST(GridMaps, BlurIsHalfTheVarianceOverAllPlaces) {
  for (GridShape shape : shapes) {
    double variance = 0;
    const int n = 1000;
    for (int i = 0; i < n; ++i) {
      const PointWeights at = point_weights(shape, (i + 0.5) / n, 0.5);
      for (std::size_t k = 0; k < PointWeights::nodes; ++k) {
        variance += at.weight[k].value * at.arm[k].value * at.arm[k].value / n;
      }
    }
    EXPECT_NEAR(blur(shape).value, variance / 2, 1e-6);  // midpoints: 1/n^2
  }
}

}  // namespace
}  // namespace plumbline::reference::grid_maps_test
