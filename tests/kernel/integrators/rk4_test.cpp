#include "tests/kernel/dense.hpp"
#include "tests/kernel/integrators/mass_on_spring.hpp"

namespace plumbline::rk4_test {
namespace {

// By hand on an equation that is not linear: of a linear one every method of four stages and order four is the same. [RK4 1]
TEST(RungeKutta4, StepsAsByHand) {
  const double dt = 0.3;
  MassOnSpring mass(0.7, -0.4);
  mass.pull = [](double u, double v) { return -u * u * u - 0.2 * v * v; };
  const auto f = [&](const Eigen::Vector2d& y) { return Eigen::Vector2d(y[1], mass.pull(y[0], y[1])); };
  const Eigen::Vector2d y(0.7, -0.4), k1 = f(y), k2 = f(y + dt / 2 * k1), k3 = f(y + dt / 2 * k2), k4 = f(y + dt * k3);
  find_integrator("rk4")->make()->step(mass, dt);
  EXPECT_EQ(mass.rates, 4);
  EXPECT_NEAR(mass.u, y[0] + dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4)[0], 1e-15);
  EXPECT_NEAR(mass.v, y[1] + dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4)[1], 1e-15);
}

// |R|^2 = 1 - z^6/72 + z^8/576: one at z = sqrt 8. [RK4 1]
TEST(RungeKutta4, OfAnOscillatorIsStableToTheRootOfEight) {
  for (const double z : {0.1, 1.0, 2.5, 3.0}) {
    EXPECT_LE((spring_matrix("rk4", z) - taylor(z, 4)).cwiseAbs().maxCoeff(), 1e-14);
  }
  EXPECT_LT(dense::spectral_radius(spring_matrix("rk4", std::sqrt(8.0) * (1 - 1e-9))), 1);
  EXPECT_GT(dense::spectral_radius(spring_matrix("rk4", std::sqrt(8.0) * (1 + 1e-9))), 1);
}

TEST(RungeKutta4, IsOfFourthOrder) { expect_order_on_spring("rk4", 4); }

}  // namespace
}  // namespace plumbline::rk4_test
