// Modes of the hanging chain: frequencies, equation of motion, energies.
#include "reference/hanging_chain.hpp"

#include "reference/bessel.hpp"
#include "tests/reference/checks.hpp"

namespace plumbline::reference::hanging_chain_test {
namespace {

TEST(HangingChain, Frequencies) {  // j_{0,n}/2 sqrt(9.81): Abramowitz & Stegun, table 9.5
  expect_near(HangingChain({1, 9.81, 1, 1, 0.01}).omega(), 3.76607, 5e-6);
  expect_near(HangingChain({1, 9.81, 1, 2, 0.01}).omega(), 8.64470, 5e-6);
  expect_near(HangingChain({1, 9.81, 1, 3, 0.01}).omega(), 13.5521, 5e-5);
  expect_near(HangingChain({4, 1, 7, 1, 0.01}).omega(), 2.4048255577 / 4, 2e-11);
}

TEST(HangingChain, ObeysTheWaveEquationWithTensionByWeight) {  // y_tt = g (s y_s)_s
  for (int mode : {1, 2, 5}) {
    const HangingChainProblem p{2.3, 4.1, 0.7, mode, 0.05};
    const HangingChain chain(p);
    const double w = chain.omega().value, k = w * w / p.gravity, t = 0.37, h = 1e-4 / k;
    for (double share : {0.05, 0.3, 0.62, 0.9}) {
      const double s = share * p.length;
      auto pull = [&](double at) { return at * chain.slope(at, t).value; };
      const double rate = (pull(s + h) - pull(s - h)) / (2 * h);
      // truncation (k h)^2 = 1e-8 times derivatives of order one, rounding 1e-15/(k h)
      EXPECT_NEAR(p.gravity * rate, -w * w * chain.displacement(s, t).value, 1e-7 * p.gravity * k * p.amplitude);
      const double slope = (chain.displacement(s + h, t).value - chain.displacement(s - h, t).value) / (2 * h);
      EXPECT_NEAR(slope, chain.slope(s, t).value, 1e-7 * k * p.amplitude);
      const double d = 1e-4 / w;
      const double speed = (chain.displacement(s, t + d).value - chain.displacement(s, t - d).value) / (2 * d);
      EXPECT_NEAR(speed, chain.velocity(s, t).value, 1e-7 * w * p.amplitude);
    }
  }
}

TEST(HangingChain, EndsAreFreeAndFixed) {
  const HangingChain chain({0.4, 9.81, 2, 3, -0.02});
  EXPECT_EQ(chain.shape(0).value, 1);
  expect_zero(chain.shape(0.4), 1, "support");
  EXPECT_EQ(chain.displacement(0, 0).value, -0.02);
  EXPECT_EQ(chain.tension(0).value, 0);
  const double k = chain.omega().value * chain.omega().value / 9.81;  // J0'(z) dz/ds at 0: -w^2/g
  EXPECT_NEAR(chain.slope(0, 0).value, 0.02 * k, 1e-13);
}

TEST(HangingChain, SlopeKeepsItsDigitsNearTheFreeEnd) {  // [DLMF 10.2.2]
  const HangingChain chain({1, 9.81, 1, 2, 1});
  const double at_end = chain.slope(0, 0).value, k = chain.omega().value * chain.omega().value / 9.81;
  for (double s : {1e-18, 1e-9, 1e-4}) {
    EXPECT_NEAR(chain.slope(s, 0).value, at_end * (1 - 0.5 * k * s), 0.1 * k * k * s * s * std::abs(at_end) + 1e-13);
    EXPECT_LE(chain.slope(s, 0).bound, 1e-13 * std::abs(at_end));
  }
  const double z1 = 1 / (chain.zero().value * chain.zero().value);  // where z = 1: series and quotient meet
  EXPECT_NEAR(chain.slope(z1 * (1 - 1e-13), 0).value, chain.slope(z1 * (1 + 1e-13), 0).value, 1e-11);
}

TEST(HangingChain, EnergyIsTheIntegralOfItsDensity) {  // [DLMF 10.22.37]
  for (int mode : {1, 4}) {
    const HangingChainProblem p{1.7, 3, 0.6, mode, 0.03};
    const HangingChain chain(p);
    const double t = 0.2;
    double kinetic = 0, potential = 0;  // by s = L u^2, in which the modes are smooth; midpoints, error of order 1/n^2
    const int n = 4000;
    for (int i = 0; i < n; ++i) {
      const double u = (i + 0.5) / n, s = p.length * u * u, width = 2 * p.length * u / n;
      const double v = chain.velocity(s, t).value, slope = chain.slope(s, t).value;
      kinetic += 0.5 * p.line_density * v * v * width;
      potential += 0.5 * chain.tension(s).value * slope * slope * width;
    }
    EXPECT_NEAR(kinetic, chain.kinetic_energy(t).value, 1e-5 * chain.energy().value);
    EXPECT_NEAR(potential, chain.potential_energy(t).value, 1e-5 * chain.energy().value);
    expect_same(chain.kinetic_energy(t) + chain.potential_energy(t), chain.energy());
  }
}

TEST(HangingChainProblem, WrongProblemsAreRefusedByKey) {
  auto key = [](const HangingChainProblem& problem) { return refused_key([&] { HangingChain chain(problem); }); };
  EXPECT_EQ(key({0, 1, 1, 1, 1}), "length");
  EXPECT_EQ(key({1, -1, 1, 1, 1}), "gravity");
  EXPECT_EQ(key({1, 1, 0, 1, 1}), "line_density");
  EXPECT_EQ(key({1, 1, 1, 0, 1}), "mode");
  EXPECT_EQ(key({1, 1, 1, 1, std::nan("")}), "amplitude");
  EXPECT_EQ(refused_key([] { HangingChain({}).shape(1.1); }), "position");
}

}  // namespace
}  // namespace plumbline::reference::hanging_chain_test
