// The shock ahead of a piston: the Riemann problem of its mirror image, the conditions at the shock, limits.
#include "reference/piston_shock.hpp"

#include "tests/reference/flow_checks.hpp"

namespace plumbline::reference::piston_shock_test {
namespace {

// J. D. Anderson, Modern Compressible Flow, 3rd ed., table A.2, gamma = 1.4, M = 2: p2/p1 = 4.5, rho2/rho1 = 2.667,
// exact 9/2 and 8/3; the speed behind it is 2 c/(gamma + 1) (M - 1/M) = 1.25 c.
TEST(PistonShockPublished, NormalShockTableAtMachTwo) {
  const double c = std::sqrt(1.4 * 3 / 0.5);
  const PistonShock piston({1.25 * c, 0.5, 3, 1.4});
  EXPECT_NEAR(piston.mach_number().value, 2, 1e-14);  // some ten roundings, those of the argument among them
  EXPECT_NEAR(piston.behind().pressure.value / 3, 4.5, 1e-13);
  EXPECT_NEAR(piston.behind().density.value / 0.5, 8.0 / 3, 1e-13);
}

TEST(PistonShockPublished, UnitPiston) {  // u = 2 c/(gamma + 1) (M - 1/M) solved for M, to the digits printed
  const PistonShock piston({1, 1, 1, 1.4});
  EXPECT_NEAR(piston.shock_speed().value, 1.92665, 5e-6);
  EXPECT_NEAR(piston.behind().pressure.value, 2.92665, 5e-6);
  EXPECT_NEAR(piston.behind().density.value, 2.07916, 5e-6);
}

// A gas that flows at a wall is the mirror image of two equal streams: the Riemann problem [Toro 4.5], in the frame of
// the piston.
TEST(PistonShockIdentity, IsHalfOfARiemannProblem) {
  for (double gamma : {1.05, 1.4, 5.0 / 3, 3.0}) {
    for (double u : {1e-6, 0.3, 2.0, 50.0}) {
      const PistonShock piston({u, 0.6, 1.9, gamma});
      const RiemannSolution collision({{0.6, u, 1.9}, {0.6, -u, 1.9}, gamma});
      expect_same(piston.behind().pressure, collision.star().pressure);
      expect_same(piston.behind().density, collision.star().density_right);
      expect_same(piston.shock_speed(), collision.right_wave().head + u);
      EXPECT_LE(piston.behind().pressure.bound, sharp * piston.behind().pressure.value);
    }
  }
}

TEST(PistonShockIdentity, RankineHugoniot) {
  for (double gamma : {1.05, 1.4, 5.0 / 3, 3.0}) {
    for (double u : {1e-3, 0.3, 50.0}) {
      const PistonShock piston({u, 0.6, 1.9, gamma});
      expect_rankine_hugoniot(piston.ahead(), piston.behind(), piston.shock_speed());
      EXPECT_TRUE(certainly_below(1.0, piston.mach_number()));
    }
  }
}

TEST(PistonShockIdentity, WorkOfThePistonIsTheEnergyOfTheGas) {
  const double u = 0.8, time = 0.7;
  const PistonShock piston({u, 1.2, 0.9, 1.67});
  const Bounded length = (piston.shock_speed() - u) * time;
  const Bounded gained = piston.behind().density * length * (piston.behind().energy + 0.5 * u * u) -
                         Bounded(1.2) * piston.shock_speed() * time * piston.ahead().energy;
  expect_zero(gained - piston.behind().pressure * u * time, gained.value, "work");
}

TEST(PistonShockIdentity, ColdGasIsTheStrongShockAndASlowPistonMakesSound) {
  const PistonShock cold({2, 3, 0, 1.4});
  expect_zero(cold.shock_speed() - 2.4, 1, "(gamma + 1)/2 u", 1e-14);
  EXPECT_NEAR(cold.behind().density.value, 18, 1e-13);
  EXPECT_EQ(cold.mach_number().bound, rounding::infinity);
  const double u = 1e-7, c = std::sqrt(1.4);
  const PistonShock slow({u, 1, 1, 1.4});
  EXPECT_NEAR(slow.shock_speed().value, c + 0.6 * u, 1e-13);           // c + (gamma + 1)/4 u, then order u^2
  EXPECT_NEAR((slow.behind().pressure.value - 1) / (c * u), 1, 1e-6);  // rho c u
}

TEST(PistonShockSample, ThreeRegions) {
  const PistonShock piston({1, 1, 1, 1.4});
  const double t = 0.5, shock = piston.shock_speed().value * t;
  EXPECT_EQ(piston.sample(0.51, t).density.value, piston.behind().density.value);
  EXPECT_EQ(piston.sample(0.51, t).velocity.value, 1);
  EXPECT_EQ(piston.sample(0.1, t).density.value, piston.behind().density.value);
  EXPECT_EQ(piston.sample(shock + 1e-12, t).density.value, 1);
  EXPECT_EQ(piston.sample(shock, t).density.value, 1);
  EXPECT_GE(piston.sample(shock, t).density.bound, 1.07);
  EXPECT_EQ(piston.sample(0.1, 0).velocity.value, 0);
}

TEST(PistonShockProblem, WrongProblemsAreRefusedByKey) {
  auto key = [](const PistonShockProblem& problem) { return refused_key([&] { PistonShock piston(problem); }); };
  EXPECT_EQ(key({0, 1, 1, 1.4}), "piston_velocity");
  EXPECT_EQ(key({1, 0, 1, 1.4}), "density");
  EXPECT_EQ(key({1, 1, -1, 1.4}), "pressure");
  EXPECT_EQ(key({1, 1, 1, 1}), "gamma");
  EXPECT_EQ(refused_key([] { PistonShock({}).sample(1, -1); }), "time");
}

}  // namespace
}  // namespace plumbline::reference::piston_shock_test
