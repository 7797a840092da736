// The plane between two clouds.
#include "kernel/contact/separation.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <random>

namespace plumbline::separation_test {
namespace {

using Vec = Eigen::Vector2d;

// Rows of points below and above y = gap * x + height in the box |x|, |y| <= 2, as far as `keep` has it.
Clouds<2> rows(double slope, double height, const std::function<bool(const Vec&, bool second)>& keep) {
  Clouds<2> clouds;
  const Vec along = Vec(1, slope).normalized(), across(-along[1], along[0]);
  for (int i = -12; i <= 12; ++i) {
    for (int j = -6; j < 6; ++j) {
      const Vec xi = 0.5 * (i + 0.25) * along + (0.5 * (j + 0.5) + height) * across;
      if (xi.cwiseAbs().maxCoeff() < 2 && keep(xi, j >= 0)) (j >= 0 ? clouds.second : clouds.first).push_back(xi);
    }
  }
  return clouds;
}
bool all(const Vec&, bool) { return true; }

// The same function, written out.
double misfit(const Clouds<2>& clouds, double reach, const Vec& a, double b) {
  double value = 0.5 * 1e-4 * a.squaredNorm();
  for (const bool second : {false, true}) {
    double sum = 0, weights = 0;
    for (const Vec& xi : second ? clouds.second : clouds.first) {
      double w = 1;
      for (int d = 0; d < 2; ++d) w *= std::pow(std::max(0.0, 1 - std::pow(xi[d] / reach, 2)), 2);
      sum += w * std::log(1 + std::exp((second ? -1 : 1) * (a.dot(xi) + b)));
      weights += w;
    }
    value += sum / weights;
  }
  return value;
}

// Least over length and offset of a plane of a given direction: by golden sections, one inside the other.
double least(const std::function<double(double)>& f, double low, double high) {
  const double golden = 0.5 * (std::sqrt(5.0) - 1);
  for (int k = 0; k < 60; ++k) {
    const double a = high - golden * (high - low), b = low + golden * (high - low);
    (f(a) < f(b) ? high : low) = f(a) < f(b) ? b : a;
  }
  return f(0.5 * (low + high));
}
double least_misfit(const Clouds<2>& clouds, double reach, double angle) {
  const Vec n(std::cos(angle), std::sin(angle));
  return least(
      [&](double length) { return least([&](double b) { return misfit(clouds, reach, length * n, b); }, -40, 40); }, 0,
      40);
}

TEST(Separation, IsTheMinimum) {  // [Touching 2]
  std::mt19937 random(5);
  std::uniform_real_distribution<double> draw(-0.2, 0.2);
  Clouds<2> clouds = rows(0.3, 0.1, all);
  for (auto* cloud : {&clouds.first, &clouds.second}) {
    for (Vec& xi : *cloud) xi += Vec(draw(random), draw(random));
  }
  const Vec n = separating_direction<2>(clouds, 2);
  EXPECT_NEAR(n.norm(), 1, 1e-15);
  const double at = std::atan2(n[1], n[0]), step = 0.02;
  const double here = least_misfit(clouds, 2, at), left = least_misfit(clouds, 2, at - step),
               right = least_misfit(clouds, 2, at + step);
  // The vertex of the parabola through the three: off by a share of step^2 for what is not a parabola.
  EXPECT_GT(left, here);
  EXPECT_GT(right, here);
  EXPECT_NEAR(0.5 * step * (left - right) / (left - 2 * here + right), 0, 2 * step * step);
}

TEST(Separation, OfStraightFacesIsTheirNormal) {
  for (const double slope : {0.0, 0.4, 1.0}) {
    const Vec n = separating_direction<2>(rows(slope, 0.05, all), 2), normal = Vec(-slope, 1).normalized();
    EXPECT_NEAR(n[0] * normal[1] - n[1] * normal[0], 0, slope == 0.4 ? 0.03 : 0.015)
        << slope;  // rows end at a box's sides
    EXPECT_GT(n.dot(normal), 0);
  }
}

// A disk on a floor: around a node beside the patch that is touched the disk's points all stand to one side.
TEST(Separation, IsHardlyTurnedByACloudThatIsThereOnOneSideAlone) {
  const Clouds<2> clouds = rows(0, 0, [](const Vec& xi, bool second) { return !second || xi[0] > 0.5; });
  const Vec n = separating_direction<2>(clouds, 2);
  EXPECT_NEAR(n[0], 0, 0.1);
  // Fisher's discriminant, by means and covariances, leans more.
  const auto mean = [](const std::vector<Vec>& cloud) {
    Vec sum = Vec::Zero();
    for (const Vec& xi : cloud) sum += xi;
    return Vec(sum / static_cast<double>(cloud.size()));
  };
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  for (const auto* cloud : {&clouds.first, &clouds.second}) {
    for (const Vec& xi : *cloud) {
      spread += (xi - mean(*cloud)) * (xi - mean(*cloud)).transpose() / static_cast<double>(cloud->size());
    }
  }
  const Vec fisher = (spread.inverse() * (mean(clouds.second) - mean(clouds.first))).normalized();
  EXPECT_GT(std::abs(fisher[0]), 2 * std::abs(n[0]));
}

TEST(Separation, TurnsWithItsSidesAndForgetsWhatIsFar) {
  Clouds<2> clouds = rows(0.2, 0.1, all), swapped{clouds.second, clouds.first};
  const Vec n = separating_direction<2>(clouds, 2), back = separating_direction<2>(swapped, 2);
  EXPECT_NEAR((n + back).norm(), 0, 1e-9);
  clouds.first.push_back({2.1, 1.5});  // beyond the reach, on the wrong side
  EXPECT_EQ((separating_direction<2>(clouds, 2) - n).norm(), 0);
}

TEST(Separation, OfOneCloudIsNone) {
  Clouds<2> clouds = rows(0, 0, all);
  clouds.second = {{2, 0}, {0, -3}};
  EXPECT_EQ(separating_direction<2>(clouds, 2).norm(), 0);
}

TEST(Separation, OnALineAndInSpace) {
  Clouds<1> line;
  for (const double xi : {-1.4, -0.9, -0.4}) line.first.push_back(Eigen::Matrix<double, 1, 1>(xi));
  line.second.push_back(Eigen::Matrix<double, 1, 1>(-1.6));
  EXPECT_EQ(separating_direction<1>(line, 2)[0], -1);
  Clouds<3> space;
  const Eigen::Vector3d normal = Eigen::Vector3d(1, 2, 2) / 3;
  for (int i = -4; i < 4; ++i)
    for (int j = -4; j < 4; ++j)
      for (int k = -4; k < 4; ++k) {
        const Eigen::Vector3d xi = 0.5 * Eigen::Vector3d(i + 0.5, j + 0.5, k + 0.5);
        (xi.dot(normal) > 0 ? space.second : space.first).push_back(xi);
      }
  EXPECT_NEAR(separating_direction<3>(space, 2).dot(normal), 1, 1e-3);  // stairs: an angle of .04
}

}  // namespace
}  // namespace plumbline::separation_test
