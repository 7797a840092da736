// Limits and orders of the oscillator's integrators: their own amplification matrices, and the literature's values.
#include "reference/oscillator_limits.hpp"

#include <complex>

#include "tests/reference/checks.hpp"

namespace plumbline::reference::oscillator_limits_test {
namespace {

using Method = OscillatorMethod;
constexpr Method all[] = {Method::forward_euler,     Method::explicit_midpoint, Method::symplectic_euler,
                          Method::leapfrog,          Method::ssp_rk3,           Method::rk4,
                          Method::newmark_trapezoid, Method::newmark_linear,    Method::generalized_alpha};

double radius(Method method, double step, double rho_b = 1) {
  return spectral_radius(oscillator_amplification(method, step, rho_b)).value;
}

TEST(OscillatorLimits, TheLiterature) {  // [Oscillator 1]
  EXPECT_EQ(oscillator_limit(Method::forward_euler).value, 0);
  EXPECT_EQ(oscillator_limit(Method::explicit_midpoint).value, 0);
  EXPECT_EQ(oscillator_limit(Method::symplectic_euler).value, 2);
  EXPECT_EQ(oscillator_limit(Method::leapfrog).value, 2);
  expect_near(oscillator_limit(Method::ssp_rk3), 1.7320508076, 5e-11);
  expect_near(oscillator_limit(Method::rk4), 2.8284271247, 5e-11);
  EXPECT_TRUE(std::isinf(oscillator_limit(Method::newmark_trapezoid).value));
  expect_near(oscillator_limit(Method::newmark_linear), 3.4641016151, 5e-11);
}

TEST(OscillatorLimits, TheMatricesGrowBeyondAndNotBelow) {  // [Oscillator 1] [Oscillator 3]
  for (Method method : all) {
    for (double rho_b : {0.0, 0.3665, 0.5, 0.8}) {
      const double limit = oscillator_limit(method, rho_b).value;
      if (limit > 0) {
        const double highest = std::isfinite(limit) ? (1 - 1e-6) * limit : 100;
        for (int i = 1; i <= 400;
             ++i) {  // 1e-4: a triple root known to the third root of a rounding, at the bifurcation
          EXPECT_LE(radius(method, highest * i / 400, rho_b), 1 + 1e-4) << static_cast<int>(method);
        }
        EXPECT_LE(radius(method, highest, rho_b), 1 + 1e-10) << static_cast<int>(method) << " " << rho_b;
      }
      if (!std::isfinite(limit)) continue;
      const double beyond = std::max((1 + 1e-6) * limit, 0.02);  // (0.02)^4/8 = 2e-8
      EXPECT_GT(radius(method, beyond, rho_b), 1 + 1e-8) << static_cast<int>(method);
    }
  }
}

TEST(OscillatorLimits, GrowthOfEulerAndOfTheMidpoint) {  // |1 + i z| and |1 + i z - z^2/2|
  for (double step : {0.01, 0.3, 1.2}) {
    EXPECT_NEAR(radius(Method::forward_euler, step), std::sqrt(1 + step * step), 1e-14);
    EXPECT_NEAR(radius(Method::explicit_midpoint, step), std::sqrt(1 + std::pow(step, 4) / 4), 1e-14);
  }
}

// Error of the state after w t = 1 in n steps, started from the place and the velocity 0.6 and 0.8.
double error_of(Method method, int steps) {
  const double rho_b = 0.6, step = 1.0 / steps;
  const SquareMatrix matrix = oscillator_amplification(method, step, rho_b);
  const bool three = method == Method::generalized_alpha;
  std::vector<double> state{0.6, three ? 0.8 * step : 0.8};
  if (three) state.push_back(-step * step * 0.6);
  for (int n = 0; n < steps; ++n) {
    std::vector<double> next(state.size());
    for (int i = 0; i < matrix.size; ++i) {
      for (int j = 0; j < matrix.size; ++j) {
        next[static_cast<std::size_t>(i)] += matrix(i, j) * state[static_cast<std::size_t>(j)];
      }
    }
    state = next;
  }
  const double u = 0.6 * std::cos(1.0) + 0.8 * std::sin(1.0), v = 0.8 * std::cos(1.0) - 0.6 * std::sin(1.0);
  return std::hypot(state[0] - u, (three ? state[1] / step : state[1]) - v);
}

TEST(OscillatorLimits, OrdersAreThoseOfTheMatrices) {
  for (Method method : all) {
    const double order = std::log2(error_of(method, 64) / error_of(method, 128));
    EXPECT_NEAR(order, oscillator_order(method), 0.05) << static_cast<int>(method);  // of theory, at w dt = 1/64
  }
}

TEST(GeneralizedAlpha, ThreeRootsMeetAtTheBifurcation) {  // [Oscillator 2]
  for (double rho_b : {0.0, 0.2, 0.3665, 0.5, 0.8, 0.9, 1.0}) {
    const double at = generalized_alpha_bifurcation_limit(rho_b).value;
    for (const auto& root : eigenvalues(oscillator_amplification(Method::generalized_alpha, at, rho_b))) {
      EXPECT_NEAR(root.real(), -rho_b, 1e-4);  // a triple root: the third root of a rounding is 6e-6
      EXPECT_NEAR(root.imag(), 0, 1e-4);
    }
  }
}

TEST(GeneralizedAlpha, ARootOfMinusOneAtTheLimit) {  // [Oscillator 3]
  for (double rho_b : {0.0, 0.2, 0.3665, 0.5, 0.8, 0.9}) {
    const double at = generalized_alpha_stability_limit(rho_b).value;
    const SquareMatrix m = oscillator_amplification(Method::generalized_alpha, at, rho_b);
    const double a = m(0, 0) + 1, b = m(0, 1), c = m(0, 2), d = m(1, 0), e = m(1, 1) + 1, f = m(1, 2), g = m(2, 0),
                 h = m(2, 1), i = m(2, 2) + 1;
    EXPECT_NEAR(a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g), 0, 1e-13) << rho_b;  // det(A + 1)
    EXPECT_GT(at, generalized_alpha_bifurcation_limit(rho_b).value);
  }
  EXPECT_NEAR(generalized_alpha_stability_limit(1).value, 2, 1e-15);
  EXPECT_NEAR(generalized_alpha_bifurcation_limit(1).value, 2, 1e-15);
}

// A form that is also met, 12 (1 + r)^3 (2 - r)/(10 + 15 r - r^2 + r^3 - r^4): 2, 1.994, 1.978, 1.873, 1.803 for
// r = 1, 0.9, 0.8, 0.5, 0.3665. It agrees at the ends; between, the roots of the method's own matrix say it is high.
TEST(GeneralizedAlpha, TheOtherFormIsHighBetweenTheEnds) {
  auto other = [](double r) {
    return std::sqrt(12 * std::pow(1 + r, 3) * (2 - r) / (10 + 15 * r - r * r + r * r * r - r * r * r * r));
  };
  EXPECT_NEAR(other(0.5), 1.873, 5e-4);
  EXPECT_NEAR(other(0.3665), 1.803, 5e-4);
  EXPECT_NEAR(generalized_alpha_stability_limit(0).value, other(0), 1e-14);
  EXPECT_NEAR(generalized_alpha_stability_limit(1).value, other(1), 1e-14);
  for (double r : {0.2, 0.3665, 0.5, 0.8, 0.9}) {
    const double limit = generalized_alpha_stability_limit(r).value;
    EXPECT_GT(radius(Method::generalized_alpha, other(r), r), 1 + 1e-3) << r;
    EXPECT_LT(other(r) / limit - 1, 4e-3);
    EXPECT_GT(other(r), limit);
  }
  expect_near(generalized_alpha_stability_limit(0.5), std::sqrt(27 / 7.75), 1e-11);
}

TEST(OscillatorLimits, WrongArgumentsAreRefusedByKey) {
  EXPECT_EQ(refused_key([] { generalized_alpha_stability_limit(1.1); }), "rho_b");
  EXPECT_EQ(refused_key([] { generalized_alpha_bifurcation_limit(-0.1); }), "rho_b");
  EXPECT_EQ(refused_key([] { oscillator_amplification(Method::generalized_alpha, 1, 2); }), "rho_b");
  EXPECT_EQ(refused_key([] { oscillator_amplification(Method::rk4, -1); }), "omega_dt");
}

}  // namespace
}  // namespace plumbline::reference::oscillator_limits_test
