// What a membrane in space stores, by the metric of its tangents. [Surface 2]
#include "kernel/materials/surface_law.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <vector>

#include "tests/kernel/dense.hpp"
#include "tests/kernel/scenes.hpp"

namespace plumbline::surface_law_test {
namespace {

using Metric = SurfaceLaw::Metric;

SurfaceLaw law_of(bool one_way, bool neo_hookean) {
  return {.youngs_modulus = 7,
          .poissons_ratio = 0.3,
          .density = 2,
          .thickness = 0.1,
          .one_way = one_way,
          .neo_hookean = neo_hookean};
}

Eigen::Matrix2d matrix(const Metric& c) {
  return (Eigen::Matrix2d() << c.first, c.mixed, c.mixed, c.second).finished();
}

// As printed, by eigenvalues.
double printed_energy(const SurfaceLaw& law, const Metric& c) {
  const Eigen::Vector2d values = dense::symmetric_spectrum(matrix(c)).values;
  if (law.neo_hookean) return law.youngs_modulus / 6 * (values.sum() + 1 / values.prod() - 3);
  const double nu = law.poissons_ratio, e = law.youngs_modulus, low = (values[0] - 1) / 2, high = (values[1] - 1) / 2;
  if (law.one_way && high <= 0) return 0;
  if (law.one_way && low + nu * high < 0) return e * high * high / 2;
  return e / (1 - nu * nu) / 2 * ((1 - nu) * (low * low + high * high) + nu * (low + high) * (low + high));
}

// Some far from rest, and some close to the borders of the three regions of the one-way law.
std::vector<Metric> metrics() {
  scenes::Random random(5);
  std::vector<Metric> all;
  for (int k = 0; k < 300; ++k) {
    const Eigen::Matrix2d f = Eigen::Matrix2d::NullaryExpr([&] { return random(-0.4, 0.4); }) +
                              Eigen::Matrix2d::Identity();
    const Eigen::Matrix2d c = f.transpose() * f;
    all.push_back({c(0, 0), c(0, 1), c(1, 1)});
  }
  for (int k = 0; k < 60; ++k) {
    const double high = random(0.05, 0.3), angle = random(0, 3), low = -0.3 * high + random(-1e-3, 1e-3);
    const Eigen::Vector2d n(std::cos(angle), std::sin(angle)), m(-n[1], n[0]);
    const Eigen::Matrix2d c = (1 + 2 * high) * n * n.transpose() + (1 + 2 * low) * m * m.transpose();
    all.push_back({c(0, 0), c(0, 1), c(1, 1)});
  }
  return all;
}

// S_ab = 2 dW/dc_ab, the mixed component of which counts twice. Central differences of 1e-5: errors of 1e-10 times third
// derivatives, which are below 1e3 E; at a border second derivatives jump by E, which gives 1e-5 E.
TEST(SurfaceLaw, StressesAreSlopesOfTheEnergy) {
  constexpr double d = 1e-5;
  for (const SurfaceLaw& law : {law_of(false, false), law_of(true, false), law_of(false, true)}) {
    for (const Metric& c : metrics()) {
      const SurfaceLaw::State s = law.state(c);
      EXPECT_NEAR(s.energy, printed_energy(law, c), 1e-12 * law.youngs_modulus);
      const auto slope = [&](const Metric& high, const Metric& low) {
        return (printed_energy(law, high) - printed_energy(law, low)) / d;
      };
      const double tolerance = 2e-5 * law.youngs_modulus;
      EXPECT_NEAR(s.first, slope({c.first + d, c.mixed, c.second}, {c.first - d, c.mixed, c.second}), tolerance);
      EXPECT_NEAR(s.second, slope({c.first, c.mixed, c.second + d}, {c.first, c.mixed, c.second - d}), tolerance);
      EXPECT_NEAR(2 * s.mixed, slope({c.first, c.mixed + d, c.second}, {c.first, c.mixed - d, c.second}), tolerance);
    }
  }
}

// Eigenvalues of S_ab f_a f_b^T / |f_1 x f_2| in space, of which one is zero, across the surface.
TEST(SurfaceLaw, PrincipalStressesAreThoseOfTheResultantInSpace) {
  scenes::Random random(11);
  for (const SurfaceLaw& law : {law_of(false, false), law_of(true, false), law_of(false, true)}) {
    for (int k = 0; k < 100; ++k) {
      const Eigen::Matrix<double, 3, 2> f = Eigen::Matrix<double, 3, 2>::NullaryExpr([&] { return random(-1, 1); }) +
                                            Eigen::Matrix<double, 3, 2>::Identity() * 1.5;
      const Eigen::Matrix2d c = f.transpose() * f;
      const Metric metric{c(0, 0), c(0, 1), c(1, 1)};
      const SurfaceLaw::State s = law.state(metric);
      const Eigen::Matrix3d stress = f * matrix({s.first, s.mixed, s.second}) * f.transpose() /
                                     Eigen::Vector3d(f.col(0)).cross(Eigen::Vector3d(f.col(1))).norm();
      const Eigen::Vector3d all = dense::symmetric_spectrum(stress).values;
      std::vector<double> within(all.begin(), all.end());  // the least in size is the one across
      within.erase(
          std::min_element(within.begin(), within.end(), [](double a, double b) { return std::abs(a) < std::abs(b); }));
      const SurfaceLaw::Stresses found = law.principal_stresses(metric);
      const double tolerance =
          1e-6 * law.youngs_modulus;  // the root of a difference that rounds at 1e-13 of stresses near 10 E
      EXPECT_NEAR(found.largest, within[1], tolerance);
      EXPECT_NEAR(found.least, within[0], tolerance);
    }
  }
}

// A wrinkled membrane gives way across the wrinkles: its energy is the least that more of that strain could give. [Surface 2]
TEST(SurfaceLaw, WrinklesAreTheLeastEnergy) {
  const SurfaceLaw wrinkles = law_of(true, false), taut = law_of(false, false);
  for (const double first : {0.7, 1.0, 1.3}) {
    for (const double second : {0.6, 0.9, 1.1}) {
      double least = 1e9;
      for (double more_first = 0; more_first < 0.6; more_first += 1e-3) {
        for (double more_second = 0; more_second < 0.6; more_second += 1e-3) {
          least = std::min(least, taut.state({first + more_first, 0, second + more_second}).energy);
        }
      }
      EXPECT_NEAR(wrinkles.state({first, 0, second}).energy, least, 1e-5 * taut.youngs_modulus)
          << first << ' ' << second;
    }
  }
}

// Small longitudinal waves along the longer stretch: rho c^2 = l^2 d(l S)/dl, by differences of the nominal stress l S.
TEST(SurfaceLaw, WaveSpeedIsThatOfTheTangent) {
  for (const SurfaceLaw& law : {law_of(false, false), law_of(false, true)}) {
    for (const double along : {1.0, 1.2, 1.6}) {
      for (const double across : {1.0, 1.1}) {
        if (across > along) continue;
        const auto nominal = [&](double l) { return l * law.state({l * l, 0, across * across}).first; };
        const double stiff = (nominal(along + 1e-6) - nominal(along - 1e-6)) / 2e-6;
        EXPECT_NEAR(law.wave_speed({along * along, 0, across * across}), along * std::sqrt(stiff / law.density), 1e-6);
      }
    }
  }
}

TEST(SurfaceLaw, RefusesWhatExcludesEachOther) {
  EXPECT_THROW(law_of(true, true).refuse_what_cannot_work(3), std::invalid_argument);
  EXPECT_THROW(law_of(false, false).refuse_what_cannot_work(2), std::invalid_argument);
  EXPECT_NO_THROW(law_of(false, true).refuse_what_cannot_work(3));
}

}  // namespace
}  // namespace plumbline::surface_law_test
