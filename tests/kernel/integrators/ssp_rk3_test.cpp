#include "tests/kernel/dense.hpp"
#include "tests/kernel/integrators/mass_on_spring.hpp"

namespace plumbline::ssp_rk3_test {
namespace {

// Each stage by hand: convex combinations of Euler steps. [SSP-RK3 1-3]
TEST(SspRungeKutta3, EachStageIsAMeanOfEulerSteps) {
  const double dt = 0.3;
  MassOnSpring mass(0.7, -0.4);
  mass.pull = [](double u, double v) { return -u * u * u - 0.2 * v; };
  const auto euler = [&](const Eigen::Vector2d& y) {
    return Eigen::Vector2d(y[0] + dt * y[1], y[1] + dt * mass.pull(y[0], y[1]));
  };
  const Eigen::Vector2d y(0.7, -0.4), one = euler(y), two = 0.75 * y + 0.25 * euler(one),
                                      three = y / 3 + 2 * euler(two) / 3;
  find_integrator("ssp-rk3")->make()->step(mass, dt);
  ASSERT_EQ(mass.states_set.size(), 3U);
  EXPECT_EQ(mass.rates, 3);
  EXPECT_LE((mass.states_set[0] - one).norm(), 1e-15);
  EXPECT_LE((mass.states_set[1] - two).norm(), 1e-15);
  EXPECT_LE((mass.states_set[2] - three).norm(), 1e-15);
}

// |R|^2 = 1 + z^6/36 - z^4/12: one at z = sqrt 3. [SSP-RK3 1-3]
TEST(SspRungeKutta3, OfAnOscillatorIsStableToTheRootOfThree) {
  for (const double z : {0.1, 1.0, 1.7, 2.5}) {
    EXPECT_LE((spring_matrix("ssp-rk3", z) - taylor(z, 3)).cwiseAbs().maxCoeff(), 4e-15);
  }
  EXPECT_LT(dense::spectral_radius(spring_matrix("ssp-rk3", std::sqrt(3.0) * (1 - 1e-9))), 1);
  EXPECT_GT(dense::spectral_radius(spring_matrix("ssp-rk3", std::sqrt(3.0) * (1 + 1e-9))), 1);
}

TEST(SspRungeKutta3, IsOfThirdOrder) { expect_order_on_spring("ssp-rk3", 3); }

}  // namespace
}  // namespace plumbline::ssp_rk3_test
