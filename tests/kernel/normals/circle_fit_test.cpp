#include "kernel/normals/circle_fit.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <numeric>

#include "tests/kernel/dense.hpp"
#include "tests/kernel/normals/curves.hpp"

namespace plumbline::circle_fit_test {
namespace {

TEST(CircleFit, IsExactOnLinesInAnyDirection) {
  for (int degrees = 0; degrees < 180; degrees += 5) {
    const test::Curve c = test::line(0.5, 0.5, degrees, {-0.41, -0.4, -0.22, -0.1, 0.05, 0.2, 0.33, 0.4});
    EXPECT_LT(test::largest_angle(test::find("modern", test::square(1, 1), c), c), 1e-10) << degrees;
    EXPECT_LT(test::largest_angle(test::find("modern", test::square(10, 0.1), c), c), 1e-10) << degrees;
  }
}

TEST(CircleFit, IsExactOnCircles) {
  const test::Curve quarter = test::arc(0, 0, 1, 0, 90, 179);
  EXPECT_LT(test::largest_angle(test::find("modern", test::square(15, 0.1), quarter), quarter), 1e-10);
  for (int turn = 0; turn < 360; turn += 15) {
    for (const double span : {60.0, 90.0, 180.0, 270.0}) {
      const test::Curve c = test::arc(0.5, 0.5, 0.4, turn, turn + span, 8);
      EXPECT_LT(test::largest_angle(test::find("modern", test::square(1, 1), c), c), 1e-10) << turn << " " << span;
    }
  }
}

// Points on an ellipse are on no circle: errors fall with the second power of their spacing, and those of mirrors with
// them.
TEST(CircleFit, ConvergesOnOtherCurves) {
  const auto error = [](int points) {
    test::Curve c;
    for (int p = 0; p < points; ++p) {
      const double a = (p + 0.5) / points * std::numbers::pi / 2;
      c.add(std::cos(a), 0.5 * std::sin(a), std::cos(a), 2 * std::sin(a));
    }
    return test::largest_angle(test::find("modern", test::square(15, 0.1, true), c), c);
  };
  const double coarse = error(180), fine = error(360);
  EXPECT_LT(coarse, 0.1);
  EXPECT_GT(std::log2(coarse / fine), 1.5);
}

// The same from the definition: all pairs, weights as stated, and the least of the quadratic form over all directions.
TEST(CircleFit, IsTheMinimumOverAllPoints) {  // [Circle 1-3]
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0, 1e-3);
  test::Curve c = test::arc(0.5, 0.2, 0.6, 20, 160, 100);
  for (std::size_t p = 0; p < c.size(); ++p) c.x[p] += noise(random), c.y[p] += noise(random);
  const double h = 0.1;
  const test::Normals n = test::find("modern", test::square(11, h), c);
  for (std::size_t p = 0; p < c.size(); ++p) {
    struct Row {
      double u, v, z;
    };
    std::vector<Row> rows;
    for (std::size_t q = 0; q < c.size(); ++q) {
      const double u = c.x[q] - c.x[p], v = c.y[q] - c.y[p], z = u * u + v * v;
      if (z < h * h) rows.push_back({u, v, z});
    }
    std::sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) { return a.z < b.z; });
    ASSERT_GE(rows.size(), 6u);  // p itself, then the nearest five
    const double d2 = rows[5].z;
    // min sum w (A z + D + n . r)^2 over A, D for n at an angle: the residual of a linear regression.
    const auto best = [&](const std::vector<double>& w, bool intercept, double& bend) {
      const auto residual = [&](double angle) {
        Eigen::MatrixXd a(static_cast<Eigen::Index>(rows.size()), intercept ? 2 : 1);
        Eigen::VectorXd b(a.rows());
        for (std::size_t k = 0; k < rows.size(); ++k) {
          const auto at = static_cast<Eigen::Index>(k);
          const double root = std::sqrt(w[k]);
          a(at, 0) = root * rows[k].z;
          if (intercept) a(at, 1) = root;
          b[at] = -root * (std::cos(angle) * rows[k].u + std::sin(angle) * rows[k].v);
        }
        const Eigen::VectorXd solution = dense::solve(a, b);
        bend = solution[0];
        return (a * solution - b).squaredNorm();
      };
      // The form is a cosine of twice the angle: three values give its minimum.
      const double third = std::numbers::pi / 3, e0 = residual(0), e1 = residual(third), e2 = residual(2 * third);
      const double cosine = (2 * e0 - e1 - e2) / 3, sine = (e1 - e2) / std::sqrt(3.0);
      const double angle = 0.5 * std::atan2(-sine, -cosine);
      residual(angle);
      return angle;
    };
    std::vector<double> w(rows.size());
    for (std::size_t k = 1; k < 5; ++k) w[k] = std::pow(1 - rows[k].z / d2, 2);
    double bend = 0;
    const double first = best(w, false, bend);
    const double s = std::sqrt(d2) / 10, b2 = std::min(h * h, 6.25 * d2);
    for (std::size_t k = 0; k < rows.size(); ++k) {
      const double e = bend * rows[k].z + std::cos(first) * rows[k].u + std::sin(first) * rows[k].v;
      w[k] = rows[k].z < b2 ? std::pow((1 - rows[k].z / b2) / (1 + e * e / (s * s * (1 + rows[k].z / d2))), 2) : 0;
    }
    const double second = best(w, true, bend);
    EXPECT_LT(test::angle(n.x[p], n.y[p], std::cos(second), std::sin(second)), 1e-7) << "point " << p;
  }
}

TEST(CircleFit, DoesNotAskForTheOrderOfPoints) {
  const test::Curve c = test::arc(0.3, 0.3, 0.5, -40, 130, 71);
  std::vector<std::size_t> order(c.size());
  std::iota(order.begin(), order.end(), 0u);
  std::shuffle(order.begin(), order.end(), std::mt19937(5));
  test::Curve mixed;
  for (const std::size_t p : order) mixed.add(c.x[p], c.y[p], c.nx[p], c.ny[p]);
  const test::Normals a = test::find("modern", test::square(12, 0.1), c),
                      b = test::find("modern", test::square(12, 0.1), mixed);
  for (std::size_t k = 0; k < order.size(); ++k) {
    EXPECT_LT(test::angle(a.x[order[k]], a.y[order[k]], b.x[k], b.y[k]), 1e-10);
  }
}

TEST(CircleFit, MirrorsAreAsGoodAsTheOtherHalf) {
  // An ellipse that meets the walls at right angles: one-sided fits would be off.
  test::Curve quarter;
  for (int p = 0; p < 40; ++p) {
    const double a = (p + 0.5) / 40 * std::numbers::pi / 2;
    quarter.add(std::cos(a), 0.6 * std::sin(a), std::cos(a), std::sin(a) / 0.6);
  }
  const GridSpec grid = test::square(12, 0.1, true);
  const test::Normals folded = test::find("modern", grid, quarter);
  const test::Normals whole = test::find("modern", test::unfolded(grid), test::unfolded(quarter));
  for (std::size_t p = 0; p < quarter.size(); ++p) {
    EXPECT_LT(test::angle(folded.x[p], folded.y[p], whole.x[p], whole.y[p]), 1e-10) << p;
  }
}

TEST(CircleFit, APointOnAMirrorStandsOnItsOwnImage) {
  test::Curve c = test::arc(0, 0, 1, 0, 90, 30);
  c.add(0, 1, 0, 1);
  c.add(1, 0, 1, 0);
  EXPECT_LT(test::largest_angle(test::find("modern", test::square(12, 0.1, true), c), c), 1e-10);
}

// Two parallel sheets six spacings apart, unevenly placed: what counts of the other sheet are weights below
// (1 + 18^2/3)^-2 = 1e-4 at any distance, times lever arms of order one.
TEST(CircleFit, AnotherSheetDoesNotCount) {
  const double spacing = 0.01;
  test::Curve c;
  for (int sheet = 0; sheet < 2; ++sheet) {
    for (int p = 0; p < 90; ++p) {
      const double along = spacing * (p + 0.3 * sheet + 0.1 * std::sin(2.7 * p)), off = 6 * spacing * sheet;
      c.add(0.1 + 0.8 * along - 0.6 * off, 0.1 + 0.6 * along + 0.8 * off, -0.6, 0.8);
    }
  }
  EXPECT_LT(test::largest_angle(test::find("modern", test::square(12, 0.1), c), c), 1);
  EXPECT_LT(test::mean_angle(test::find("modern", test::square(12, 0.1), c), c), 0.1);
}

TEST(CircleFit, AveragesNoiseAwayThatTheMeanOfTwoSegmentsKeeps) {
  std::mt19937 random(11);
  test::Curve c = test::arc(0, 0, 1, 0, 90, 179);
  std::normal_distribution<double> noise(0, 0.05 * std::numbers::pi / 2 / 179);
  for (std::size_t p = 0; p < c.size(); ++p) c.x[p] += noise(random), c.y[p] += noise(random);
  const GridSpec grid = test::square(12, 0.1, true);
  EXPECT_LT(test::mean_angle(test::find("modern", grid, c), c),
            0.5 * test::mean_angle(test::find("connectivity", grid, c), c));
}

TEST(CircleFit, FewPointsGiveWhatTheyCan) {
  const GridSpec grid = test::square(40, 0.1);
  const test::Curve two = test::line(1.5, 1.5, 35, {-0.7, 0.7});  // far beyond a cell: the chord
  EXPECT_LT(test::largest_angle(test::find("modern", grid, two), two), 1e-10);
  const test::Curve three = test::arc(2, 2, 1.5, 0, 150, 3);
  EXPECT_LT(test::largest_angle(test::find("modern", grid, three), three), 1e-10);
  const test::Curve one = test::line(1.5, 1.5, 0, {0});
  const std::vector<double> before_x{0.6}, before_y{0.8};
  std::vector<double> nx(1), ny(1);
  make_normals("modern")->find({grid, one.x, one.y, {}, {}, before_x, before_y, false}, nx, ny);
  EXPECT_EQ(nx[0], 0.6);
  make_normals("modern")->find({grid, one.x, one.y, {}, {}, {}, {}, false}, nx, ny);
  EXPECT_EQ(std::hypot(nx[0], ny[0]), 0);
}

}  // namespace
}  // namespace plumbline::circle_fit_test
