// Limits of bars with free ends: the whole step's matrix, the known table, a light node, York's five points.
#include "reference/mpm_amplification.hpp"

#include "reference/circle.hpp"
#include "tests/reference/checks.hpp"

namespace plumbline::reference::free_bar_amplification_test {
namespace {

using Shape = GridShape;
using Transfer = GridTransfer;
using Update = StressUpdate;

double growth_of(const MapScheme& scheme, const std::vector<double>& points, double spacing, double courant) {
  return spectral_radius(free_bar_amplification(scheme, points, spacing, courant)).value;
}

TEST(FreeBar, WholeStepsGrowBeyondTheLimitAndNotBelow) {  // [Stability 4, 5]
  const std::vector<double> uneven{0.13, 0.41, 0.77, 1.2, 1.5, 1.88, 2.2, 2.43, 3.01};
  for (Update update : {Update::first, Update::last, Update::modified_last, Update::averaged}) {
    for (Shape shape : {Shape::linear, Shape::boxes, Shape::quadratic, Shape::cubic}) {
      for (Transfer transfer : {Transfer::pic, Transfer::flip, Transfer::apic, Transfer::xpic, Transfer::fmpm}) {
        const MapScheme scheme{update, shape, transfer, 3, shape == Shape::cubic ? 0.6 : 0.0};
        const Bounded limit = free_bar_courant_limit(scheme, uneven, 0.33);
        const int name = static_cast<int>(update) * 100 + static_cast<int>(shape) * 10 + static_cast<int>(transfer);
        for (double share : {0.1, 0.3, 0.5, 0.7, 0.9, 0.9999}) {
          EXPECT_LE(growth_of(scheme, uneven, 0.33, share * limit.value), 1 + 1e-6) << name;
        }
        EXPECT_GT(growth_of(scheme, uneven, 0.33, 1.0001 * limit.value), 1 + 1e-6) << name;
        EXPECT_LE(limit.bound, 1e-9) << name;
      }
    }
  }
}

TEST(FreeBar, TheKnownTableOfEdges) {  // 16 points on 8 cells, FLIP; rounded to the last digit
  struct Row {
    double depth, linear, linear_last, boxes, boxes_last, quadratic, quadratic_last;
  };
  for (const Row& row :
       {Row{.25, 1.732, .657, 1.732, .657, 2.282, .999}, Row{.1, 1.617, .435, 1.939, .704, 2.235, .963},
        Row{.01, 1.435, .141, 1.967, .709, 2.170, .917}, Row{1e-4, 1.411, .0141, 1.967, .708, 2.162, .910}}) {
    auto limit = [&](Update update, Shape shape) {
      return free_bar_courant_limit({update, shape, Transfer::flip}, edge_points(2, 8, row.depth), 0.5).value;
    };
    EXPECT_NEAR(limit(Update::first, Shape::linear), row.linear, 6e-4);
    EXPECT_NEAR(limit(Update::modified_last, Shape::linear), row.linear, 6e-4);
    EXPECT_NEAR(limit(Update::last, Shape::linear), row.linear_last, row.linear_last < 0.1 ? 6e-5 : 6e-4);
    EXPECT_NEAR(limit(Update::first, Shape::boxes), row.boxes, 6e-4);
    EXPECT_NEAR(limit(Update::last, Shape::boxes), row.boxes_last, 6e-4);
    EXPECT_NEAR(limit(Update::first, Shape::quadratic), row.quadratic, 6e-4);
    EXPECT_NEAR(limit(Update::last, Shape::quadratic), row.quadratic_last, 6e-4);
  }
}

// A point that barely touches the outermost node: its mass is depth times the point's own, its share of the stiffness
// all of it, so 1/C^2 = (2 - B)/(4) K -> 1/(2 depth) of a single light node with B = depth: C = sqrt(2 depth).
TEST(FreeBar, StressLastVanishesWithTheDepth) {
  for (double depth : {1e-3, 1e-4, 1e-6}) {
    const Bounded limit = free_bar_courant_limit({Update::last, Shape::linear, Transfer::flip},
                                                 edge_points(2, 8, depth), 0.5);
    EXPECT_NEAR(limit.value / std::sqrt(2 * depth), 1, 2 * depth + 1e-6);
  }
}

// The interior of a long bar holds the worst wave of the periodic layout but for one half wave in its length: a bar of
// n cells has a limit larger by 1 + (pi/n)^2/2 at most, whatever its ends do.
TEST(FreeBar, ALongBarHasTheLimitOfItsInterior) {
  for (Update update : {Update::first, Update::last}) {
    for (Shape shape : {Shape::linear, Shape::boxes, Shape::quadratic, Shape::cubic}) {
      const MapScheme scheme{update, shape, Transfer::flip};
      const double periodic = periodic_courant_limit(scheme, regular_points(2)).value;
      EXPECT_LE(free_bar_courant_limit(scheme, edge_points(2, 30, 0.25), 0.5).value, 1.006 * periodic);
    }
  }
}

/// Limits of a bar whose standing waves have these shares s = sin^2(theta/2), B = 1 - s, K = 4 s.
void expect_standing_waves(Bounded (*limit_of)(const MapScheme&, const std::vector<double>&, double),
                           const std::vector<double>& points, const std::vector<double>& shares) {
  double first = 0, last = 0;
  for (const double s : shares) {
    first = std::max(first, s * (1 - s));
    last = std::max(last, s * (1 + s));
  }
  const Bounded early = limit_of({Update::first}, points, 1), late = limit_of({Update::last}, points, 1);
  EXPECT_NEAR(early.value, 1 / std::sqrt(first), early.bound + 1e-15) << points.size();
  EXPECT_NEAR(late.value, 1 / std::sqrt(last), late.bound + 1e-15) << points.size();
}

// One point at the centre of each of n cells, free ends: standing waves of theta = k pi/n, k = 1 to n, on nodes that
// all carry the mass of their cells.
TEST(FreeBar, PointsAtCentresHaveStandingWaves) {
  for (int count : {2, 5, 6, 11}) {
    std::vector<double> points, shares;
    for (int k = 1; k <= count; ++k) {
      points.push_back(k + 0.5);
      shares.push_back(std::pow(std::sin(k * pi.value / (2 * count)), 2));
    }
    expect_standing_waves(free_bar_courant_limit, points, shares);
  }
}

// Half of a bar of 2 n cells: the standing waves of odd k alone, whose velocity is odd about the wall.
TEST(LeaningBar, PointsAtCentresHaveEveryOtherStandingWave) {  // [Stability 4, 5]
  for (int count : {1, 2, 5, 6}) {
    std::vector<double> points, shares;
    for (int k = 0; k < count; ++k) {
      points.push_back(k + 0.5);
      shares.push_back(std::pow(std::sin((2 * k + 1) * pi.value / (4 * count)), 2));
    }
    expect_standing_waves(leaning_bar_courant_limit, points, shares);
  }
}

// A mode of the bar alone is one of it and its image; where they do not reach each other they are the same.
TEST(LeaningBar, HasNoSmallerLimitThanTheBarWithItsImage) {
  for (Update update : {Update::first, Update::last}) {
    for (Shape shape : {Shape::linear, Shape::boxes, Shape::quadratic, Shape::cubic}) {
      for (Transfer transfer : {Transfer::flip, Transfer::apic}) {
        std::vector<double> points, both;
        for (int k = 0; k < 24; ++k) points.push_back(12.1 - 0.5 * k);
        for (double x : points) both.insert(both.end(), {x, -x});
        const MapScheme scheme{update, shape, transfer};
        const Bounded whole = free_bar_courant_limit(scheme, both, 0.5);
        const Bounded half = leaning_bar_courant_limit(scheme, points, 0.5);
        EXPECT_GE(half.value + half.bound, whole.value - whole.bound);
      }
    }
  }
  const MapScheme last{Update::last, Shape::linear, Transfer::flip};
  std::vector<double> points;
  for (int k = 0; k < 24; ++k) points.push_back(12.01 - 0.5 * k);
  EXPECT_NEAR(leaning_bar_courant_limit(last, points, 0.5).value,
              free_bar_courant_limit(last, edge_points(2, 12, 0.01), 0.5).value, 1e-12);
}

TEST(FreeBar, YorksFivePoints) {  // [York 8.36, 8.41]
  const MapScheme york{Update::modified_last, Shape::linear, Transfer::flip};
  const Bounded centres = free_bar_courant_limit(york, york_points(0.5), 1);
  EXPECT_GT(centres.value,
            2);  // his bound is the infinite bar's, whose worst wave, s = 1/2, is none of these five points'
  EXPECT_NEAR(centres.value, 2.1029244485, 5e-11);  // 1/sqrt(s (1 - s)) = 2/sin(72 degrees), of the waves 2 and 3
  const Bounded sides = free_bar_courant_limit(york, york_points(1e-4), 1);
  EXPECT_GT(sides.value, 1);
  EXPECT_LT(sides.value, 1.1);  // 1.1 is the first of his steps that he saw unstable
  EXPECT_GT(growth_of(york, york_points(1e-4), 1, 1.1), 1.5);
  EXPECT_LE(growth_of(york, york_points(1e-4), 1, 1.0), 1 + 1e-6);
}

TEST(FreeBar, WrongArgumentsAreRefusedByKey) {
  EXPECT_EQ(refused_key([] { free_bar_courant_limit({}, {}, 1); }), "points");
  EXPECT_EQ(refused_key([] { free_bar_courant_limit({}, {0.5}, 0); }), "spacing");
  EXPECT_EQ(refused_key([] { free_bar_courant_limit({.shape = Shape::boxes}, {0.5}, 1.5); }), "spacing");
  EXPECT_EQ(refused_key([] { free_bar_courant_limit({.order = 0}, {0.5}, 1); }), "order");
  EXPECT_EQ(refused_key([] { free_bar_amplification({}, {0.5}, 1, 0); }), "courant");
  EXPECT_EQ(refused_key([] { leaning_bar_courant_limit({}, {0.5, -0.5}, 1); }), "points");
  EXPECT_EQ(refused_key([] { edge_points(2, 8, 0.6); }), "depth");
  EXPECT_EQ(refused_key([] { edge_points(0, 8, 0.1); }), "per_cell");
  EXPECT_EQ(refused_key([] { york_points(1.5); }), "offset");
}

}  // namespace
}  // namespace plumbline::reference::free_bar_amplification_test
