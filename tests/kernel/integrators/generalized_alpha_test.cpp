#include <stdexcept>

#include "tests/kernel/dense.hpp"
#include "tests/kernel/integrators/mass_on_spring.hpp"

namespace plumbline::generalized_alpha_test {
namespace {

std::unique_ptr<TimeIntegrator> with(double rho_b) {
  auto integrator = find_integrator("generalized-alpha")->make();
  set_parameters(*integrator, {{"rho_b", rho_b}});
  return integrator;
}

// The step on (d, v, a) of u'' = -u by hand. [Generalized-Alpha 1-4]
Eigen::Matrix3d by_hand(double r, double dt) {
  const double alpha_m = (2 * r - 1) / (1 + r), gamma = 1.5 - alpha_m,
               beta = (5 - 3 * r) / ((1 + r) * (1 + r) * (2 - r));
  Eigen::Matrix3d m;
  m.row(2) << -1 / (1 - alpha_m), 0, -alpha_m / (1 - alpha_m);  // of the forces of the start
  m.row(0) = Eigen::RowVector3d(1, dt, dt * dt * (0.5 - beta)) + dt * dt * beta * m.row(2);
  m.row(1) = Eigen::RowVector3d(0, 1, dt * (1 - gamma)) + dt * gamma * m.row(2);
  return m;
}

Eigen::Matrix3d stepped(double r, double dt) {
  Eigen::Matrix3d m;
  const auto integrator = with(r);
  MassOnSpring mass(1, 0);
  integrator->step(mass, dt);
  EXPECT_EQ(integrator->memory().size(), 1U);
  for (int k = 0; k < 3; ++k) {
    mass.u = k == 0;
    mass.v = k == 1;
    integrator->memory().at(0)->values = {0, k == 2 ? 1.0 : 0.0};
    integrator->step(mass, dt);
    EXPECT_EQ(integrator->memory().at(0)->values.at(0), 0);  // accelerations alone
    m.col(k) << mass.u, mass.v, integrator->memory().at(0)->values.at(1);
  }
  return m;
}

// [Generalized-Alpha 1-4]
TEST(GeneralizedAlpha, StepsAsByHand) {
  for (const double r : {0.0, 0.3, 0.8, 1.0}) {
    for (const double dt : {0.1, 1.0, 1.9}) {
      EXPECT_LE((stepped(r, dt) - by_hand(r, dt)).cwiseAbs().maxCoeff(), 1e-14) << r << " " << dt;
    }
  }
}

// Three roots meet at -rho_b: each is off by the third root of the matrix's rounding, 1e-5. [Generalized-Alpha 1]
TEST(GeneralizedAlpha, LeavesRhoOfTheFastestOscillation) {
  for (const double r : {0.0, 0.3, 0.8}) {
    EXPECT_NEAR(dense::spectral_radius(stepped(r, (1 + r) * std::sqrt(2 - r))), r, 1e-4) << r;
  }
}

// The root that parts reaches -1 where the (often misquoted) polynomial says. [Generalized-Alpha 1-4]
TEST(GeneralizedAlpha, LimitOfStability) {
  for (const double r : {0.0, 0.5, 0.8, 0.9, 1.0}) {
    const double limit = std::sqrt(12 * (1 + r) * (2 - r) / (10 - 5 * r + r * r));
    EXPECT_LE(dense::spectral_radius(stepped(r, limit * (1 - 1e-6))), 1 + 1e-9) << r;
    EXPECT_GT(dense::spectral_radius(stepped(r, limit * (1 + 1e-6))), 1 + 1e-7) << r;
  }
}

TEST(GeneralizedAlpha, IsOfSecondOrder) {
  for (const double r : {0.0, 0.5, 1.0}) {
    const auto error = [&](int steps) { return error_on_spring(*with(r), steps); };
    EXPECT_NEAR(std::log2(error(64) / error(128)), 2, 0.05) << r;
  }
}

TEST(GeneralizedAlpha, RhoIsWithinOne) {
  EXPECT_THROW(with(-0.01), std::invalid_argument);
  EXPECT_THROW(with(1.01), std::invalid_argument);
  EXPECT_TRUE(with(0.5)->memory().at(0)->values.empty());
}

}  // namespace
}  // namespace plumbline::generalized_alpha_test
