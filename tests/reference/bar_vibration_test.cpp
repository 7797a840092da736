// The fixed and free bar: published frequency, elasticity, equation of motion, energies.
#include "reference/bar_vibration.hpp"

#include "reference/circle.hpp"
#include "tests/reference/checks.hpp"

namespace plumbline::reference::bar_vibration_test {
namespace {

const BarVibrationProblem third{2e5, 7.8, 0.3, 1.9, -0.4, 3};

TEST(BarVibration, TheVibratingBarOfTheLiterature) {  // E 100, rho 1, L 25, v0 0.1: pi c/(2 L) = 0.2 pi
  const BarVibration bar{BarVibrationProblem{}};
  expect_near(bar.omega(), 0.6283185307, 5e-11);
  expect_near(bar.period(), 10, 1e-10);
  expect_near(bar.amplitude(), 0.1591549431, 5e-11);
  expect_near(BarVibration({100, 1, 1, 25, 0.1, 10}).omega(), 11.93805208, 5e-9);  // its tenth mode
}

TEST(BarVibration, ObeysElasticityAndNewton) {
  for (const BarVibrationProblem& p : {BarVibrationProblem{}, third}) {
    const BarVibration bar(p);
    const double k = bar.wavenumber().value, w = bar.omega().value, h = 1e-4 / k, d = 1e-4 / w, t = 0.6 / w;
    const double stress = p.youngs_modulus * bar.amplitude().value * k;
    for (double x : {0.1 * p.length, 0.4 * p.length, 0.83 * p.length}) {
      const double strain = (bar.displacement(x + h, t).value - bar.displacement(x - h, t).value) / (2 * h);
      const double speed = (bar.displacement(x, t + d).value - bar.displacement(x, t - d).value) / (2 * d);
      const double force = (bar.stress(x + h, t).value - bar.stress(x - h, t).value) / (2 * h);
      const double push = p.density * (bar.velocity(x, t + d).value - bar.velocity(x, t - d).value) / (2 * d);
      EXPECT_NEAR(p.youngs_modulus * strain, bar.stress(x, t).value, 1e-7 * stress);  // (k h)^2/6 = 2e-9
      EXPECT_NEAR(speed, bar.velocity(x, t).value, 1e-7 * std::abs(p.velocity));
      EXPECT_NEAR(push, force, 1e-7 * stress * k);
    }
    expect_zero(bar.displacement(0, t), bar.amplitude().value, "fixed end");
    expect_zero(bar.stress(p.length, t), stress, "free end");
  }
}

TEST(BarVibration, StartsUnstretchedWithItsVelocity) {
  const BarVibration bar(third);
  EXPECT_EQ(bar.displacement(0.7, 0).value, 0);
  EXPECT_EQ(bar.stress(0.7, 0).value, 0);
  EXPECT_NEAR(bar.velocity(0.7, 0).value, -0.4 * std::sin(5 * pi.value / 2 / 1.9 * 0.7), 1e-15);
}

TEST(BarVibration, EnergiesAndMeanVelocityAreIntegrals) {
  for (const BarVibrationProblem& p : {BarVibrationProblem{}, third}) {
    const BarVibration bar(p);
    const double t = 0.9 / bar.omega().value;
    double kinetic = 0, elastic = 0, mean = 0;
    const int n = 4000;  // midpoints: sin^2 exact, the mean to (k L/n)^2/24 = 3e-7
    for (int i = 0; i < n; ++i) {
      const double x = p.length * (i + 0.5) / n, v = bar.velocity(x, t).value, e = bar.strain(x, t).value;
      kinetic += 0.5 * p.density * p.area * v * v * p.length / n;
      elastic += 0.5 * p.youngs_modulus * p.area * e * e * p.length / n;
      mean += v / n;
    }
    EXPECT_NEAR(kinetic, bar.kinetic_energy(t).value, 1e-11 * bar.energy().value);
    EXPECT_NEAR(elastic, bar.strain_energy(t).value, 1e-11 * bar.energy().value);
    EXPECT_NEAR(mean, bar.mean_velocity(t).value, 1e-6 * std::abs(p.velocity));
    expect_same(bar.kinetic_energy(t) + bar.strain_energy(t), bar.energy());
  }
}

TEST(BarVibrationProblem, WrongProblemsAreRefusedByKey) {
  auto key = [](const BarVibrationProblem& problem) { return refused_key([&] { BarVibration bar(problem); }); };
  EXPECT_EQ(key({0, 1, 1, 1, 1, 1}), "youngs_modulus");
  EXPECT_EQ(key({1, 0, 1, 1, 1, 1}), "density");
  EXPECT_EQ(key({1, 1, 0, 1, 1, 1}), "area");
  EXPECT_EQ(key({1, 1, 1, 0, 1, 1}), "length");
  EXPECT_EQ(key({1, 1, 1, 1, std::nan(""), 1}), "velocity");
  EXPECT_EQ(key({1, 1, 1, 1, 1, 0}), "mode");
  EXPECT_EQ(refused_key([] { BarVibration({}).stress(26, 0); }), "position");
}

}  // namespace
}  // namespace plumbline::reference::bar_vibration_test
