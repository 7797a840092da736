// A spring that has mass: bar with a tip mass, x tan x = mu [Rao 8.3].
#include "reference/heavy_spring.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace plumbline::reference::heavy_spring_test {
namespace {

/// A bar of stiffness, length and wave speed 1 with the mass ratio mu: L/c = 1, m g/k = 1.
SpringProblem unit_bar(double mu) { return {1, 1, 1, 1 / mu, 1, mu}; }

struct Row {
  double mu, first, second;
};

// H. S. Carslaw, J. C. Jaeger, Conduction of Heat in Solids, 2nd ed., appendix IV, table I (alpha tan alpha = C).
TEST(TipMassRoot, PublishedTable) {  // [Rao 8.3]
  for (const Row& row : {Row{0.01, 0.0998, 3.1448}, Row{0.1, 0.3111, 3.1731}, Row{1, 0.8603, 3.4256},
                         Row{10, 1.4289, 4.3058}, Row{100, 1.5552, 4.6658}}) {
    EXPECT_NEAR(tip_mass_root(row.mu, 1).value, row.first, 5e-5) << row.mu;  // half of the last printed digit
    EXPECT_NEAR(tip_mass_root(row.mu, 2).value, row.second, 5e-5) << row.mu;
  }
}

TEST(TipMassRoot, IsARootInItsOwnInterval) {  // [Rao 8.3]
  const double pi = std::acos(-1.0);
  for (double mu : {1e-12, 1e-3, 0.4, 1.0, 7.0, 300.0}) {
    for (int n : {1, 2, 3, 10, 77}) {
      const Bounded x = tip_mass_root(mu, n);
      EXPECT_GE(x.value, (n - 1) * pi - x.bound);
      EXPECT_LE(x.value, (n - 0.5) * pi + x.bound);
      const Bounded residual = x * sin(x) - Bounded(mu) * cos(x);
      EXPECT_LE(std::abs(residual.value), residual.bound);
      EXPECT_LE(x.bound, 1e-14 * x.value);
    }
  }
}

TEST(TipMassRoot, LightSpringHasOneThirdOfItsMassAtTheEnd) {  // [Rao 8.3], x^2 = mu (1 - mu/3 + 4 mu^2/45 - ...)
  for (double mu : {1e-8, 1e-4, 1e-2, 0.1}) {
    const Bounded x = tip_mass_root(mu, 1);
    const double share = 1 - mu / 3 + 4 * mu * mu / 45;
    // the series alternates: the error is below its next term, 16 mu^3/945
    EXPECT_NEAR(x.value * x.value / mu, share, 16 * mu * mu * mu / 945 + 1e-15);
  }
}

TEST(TipMassRoot, RefusesNumberZero) { EXPECT_THROW(tip_mass_root(1.0, 0), std::invalid_argument); }

TEST(HeavySpring, YorksProblem) {  // x tan x = m_s/m, m_s = rho A L = 0.003: mu/6 longer than without
  const HeavySpring spring{SpringProblem{}};
  EXPECT_NEAR(spring.mass_ratio().value, 0.003 / 3.33, 1e-18);
  EXPECT_NEAR(spring.period().value, 0.0198622, 5e-8);  // six digits of a separate computation by Brent's method
  EXPECT_LE(spring.period().bound, 1e-14 * spring.period().value);
}

TEST(HeavySpring, BoundOfTheMassRatioCountsItsRounding) {
  for (double density : {0.1, 0.3, 0.7, 1.1, 1e-7}) {
    SpringProblem problem;
    problem.density = density;
    const Bounded mu = HeavySpring(problem).mass_ratio();
    const long double exact = static_cast<long double>(density) * problem.area * problem.length / problem.mass;
    EXPECT_LE(std::abs(mu.value - exact), mu.bound);
    EXPECT_GE(mu.bound, rounding::unit * mu.value);  // two products and a quotient, half a unit each
    EXPECT_LE(mu.bound, 8 * rounding::unit * mu.value);
  }
}

// Until the wave from the support arrives at t = L/c the lower end falls freely, whatever the masses: this tests every
// participation factor at once.
TEST(HeavySpring, FallsFreelyUntilTheFirstWaveArrives) {
  for (double mu : {0.01, 0.3, 1.0, 4.0}) {
    const HeavySpring spring(unit_bar(mu));
    for (double t : {0.0, 0.2, 0.6, 0.99}) {
      const Bounded d = spring.displacement(t), v = spring.velocity(t);
      EXPECT_LE(std::abs(d.value - 0.5 * mu * t * t), d.bound) << mu << " " << t;
      EXPECT_LE(std::abs(v.value - mu * t), v.bound) << mu << " " << t;
      EXPECT_LE(d.bound, 1e-8);
    }
  }
}

// Then, until t = 3 L/c, the support's answer is one wave: d = g t^2/2 - 2 g a I, with a = mu, tau = t - 1 and
// I = tau^2/(2a) - tau/a^2 + (1 - exp(-a tau))/a^3, from the Laplace transform of the equation of motion.
TEST(HeavySpring, AnswersTheFirstWaveAsDAlembertSays) {
  for (double mu : {0.3, 1.0, 4.0}) {
    const HeavySpring spring(unit_bar(mu));
    for (double t : {1.01, 1.4, 2.0, 2.99}) {
      const double tau = t - 1;
      const double wave = tau * tau / (2 * mu) - tau / (mu * mu) - std::expm1(-mu * tau) / (mu * mu * mu);
      const Bounded d = spring.displacement(t);
      EXPECT_NEAR(d.value, 0.5 * mu * t * t - 2 * mu * mu * wave, d.bound + 1e-13) << mu << " " << t;
    }
  }
}

TEST(HeavySpring, BecomesTheMasslessSpringAsItsMassVanishes) {
  const SpringProblem york;
  const MasslessSpring massless(york);
  for (double density : {0.0, 1e-9, 1e-3, 0.1}) {
    SpringProblem problem = york;
    problem.density = density;
    const HeavySpring spring(problem);
    const double mu = spring.mass_ratio().value, scale = massless.max_displacement().value;
    EXPECT_NEAR(spring.period().value, massless.period().value * std::sqrt(1 + mu / 3),
                massless.period().value * (mu * mu + 1e-15));
    EXPECT_NEAR(spring.static_displacement().value, massless.static_displacement().value * (1 + mu / 2), 1e-15 * scale);
    EXPECT_NEAR(spring.max_displacement().value, massless.max_displacement().value, mu * scale + 1e-15 * scale);
    for (double t : {0.001, 0.007, 0.013}) {
      EXPECT_NEAR(spring.displacement(t).value, massless.displacement(t).value, mu * scale + 1e-13 * scale) << density;
    }
  }
}

TEST(HeavySpring, VelocityIsTheRateOfDisplacement) {
  const HeavySpring spring(unit_bar(0.5));
  for (double t : {0.5, 1.7, 2.6, 4.2}) {
    const double h = 1e-4;
    const double slope = (spring.displacement(t + h).value - spring.displacement(t - h).value) / (2 * h);
    EXPECT_NEAR(spring.velocity(t).value, slope, 1e-7);  // h^2/6 times a third derivative below 10
  }
}

TEST(HeavySpring, FirstExtremumIsARestOfTheLowerEnd) {
  for (double mu : {0.01, 0.5, 3.0}) {
    const HeavySpring spring(unit_bar(mu));
    const Bounded most = spring.max_displacement();
    double largest = 0;
    const double half = spring.period().value / 2;
    for (int i = 0; i <= 400; ++i) largest = std::max(largest, spring.displacement(1.3 * half * i / 400).value);
    EXPECT_GE(most.value, largest - most.bound - spring.displacement(half).bound);
    EXPECT_NEAR(most.value, largest, 1e-4 * most.value);  // (pi 1.3/800)^2/2 between two samples
  }
}

TEST(HeavySpring, GravityMayPointTheOtherWayOrVanish) {
  SpringProblem up, none;
  up.gravity = -up.gravity;
  none.gravity = 0;
  const HeavySpring down{SpringProblem{}}, upward(up), still(none);
  EXPECT_EQ(upward.max_displacement().value, -down.max_displacement().value);
  EXPECT_EQ(still.max_displacement().value, 0);
  EXPECT_EQ(still.displacement(0.01).value, 0);
}

TEST(HeavySpring, MasslessSpringHasOneFrequency) {
  SpringProblem problem;
  problem.density = 0;
  EXPECT_THROW(HeavySpring(problem).omega(2), std::invalid_argument);
}

TEST(HeavySpring, ExtremeMassRatiosStillAnswerWithABound) {
  for (double mu : {1e-200, 1e-30, 1e6, 1e15}) {
    const HeavySpring spring(unit_bar(mu));
    EXPECT_TRUE(std::isfinite(spring.period().bound)) << mu;
    EXPECT_LE(spring.period().bound, 1e-13 * spring.period().value) << mu;
    EXPECT_TRUE(std::isfinite(spring.max_displacement().bound)) << mu;
  }
}

}  // namespace
}  // namespace plumbline::reference::heavy_spring_test
