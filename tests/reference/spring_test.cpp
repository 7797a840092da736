// The massless spring [York 5.10, 5.11].
#include "reference/spring.hpp"

#include <limits>

#include "tests/reference/checks.hpp"

namespace plumbline::reference::spring_test {
namespace {

TEST(MasslessSpring, YorksProblem) {  // [York 5.11], k = A E/L = 1e6/3, m = 3.33, g = 250
  const MasslessSpring spring{SpringProblem{}};
  const double omega = std::sqrt(1e6 / 3 / 3.33), pi = std::acos(-1.0);
  EXPECT_NEAR(spring.stiffness().value, 1e6 / 3, 1e-15 * 1e6);
  EXPECT_NEAR(spring.omega().value, omega, 1e-15 * omega);
  EXPECT_NEAR(spring.period().value, 2 * pi / omega, 2e-17);
  EXPECT_NEAR(spring.max_displacement().value, 0.004995, 2e-18);  // 2 m g/k, exact in decimals
}

TEST(MasslessSpring, KineticAndSpringEnergyAreTheWorkOfGravity) {  // [York 5.10]: its first integral
  const SpringProblem problem{2e5, 0.02, 1.7, 0.9, 0, 9.81};
  const MasslessSpring spring(problem);
  const double scale = problem.mass * problem.gravity * spring.max_displacement().value;
  for (double share : {0.0, 0.1, 0.25, 0.5, 0.77, 1.0, 3.3}) {
    const double t = share * spring.period().value;
    const Bounded work = Bounded(problem.mass) * problem.gravity * spring.displacement(t);
    expect_zero(spring.kinetic_energy(t) + spring.spring_energy(t) - work, scale, "work");
  }
}

TEST(MasslessSpring, ObeysTheEquationOfMotion) {  // [York 5.10] by central differences
  const SpringProblem problem{3e4, 0.05, 0.8, 2.1, 0, -4};
  const MasslessSpring spring(problem);
  const double h = 1e-4 * spring.period().value, k = spring.stiffness().value;
  for (double t : {0.0, 0.03, 0.2, 1.0}) {
    const double before = spring.displacement(t - h).value, now = spring.displacement(t).value;
    const double after = spring.displacement(t + h).value;
    const double force = problem.mass * problem.gravity - k * now;
    // truncation (omega h)^2/12 = 3e-8 and rounding 1e-16/(omega h)^2 = 3e-10 of the largest force
    EXPECT_NEAR(problem.mass * (after - 2 * now + before) / (h * h), force, 1e-7 * problem.mass * 4);
    EXPECT_NEAR(spring.velocity(t).value, (after - before) / (2 * h), 1e-6 * 4 / spring.omega().value);
  }
}

TEST(MasslessSpring, StartsFromRestAndReachesTwiceTheStaticDisplacement) {
  const MasslessSpring spring{SpringProblem{}};
  EXPECT_EQ(spring.displacement(0).value, 0);
  EXPECT_EQ(spring.velocity(0).value, 0);
  const double half = spring.period().value / 2;
  EXPECT_NEAR(spring.displacement(half).value, 2 * spring.static_displacement().value, 1e-17);
  EXPECT_NEAR(spring.displacement(half / 2).value, spring.static_displacement().value, 1e-17);
  EXPECT_NEAR(spring.displacement(1e-8).value, 0.5 * 250 * 1e-16, 1e-25);  // free fall, without cancellation
}

TEST(SpringProblem, WrongProblemsAreRefusedByKey) {
  const auto key = refused_change<MasslessSpring, SpringProblem>;
  EXPECT_EQ(key([](SpringProblem& p) { p.youngs_modulus = 0; }), "youngs_modulus");
  EXPECT_EQ(key([](SpringProblem& p) { p.area = -1; }), "area");
  EXPECT_EQ(key([](SpringProblem& p) { p.length = std::numeric_limits<double>::infinity(); }), "length");
  EXPECT_EQ(key([](SpringProblem& p) { p.mass = 0; }), "mass");
  EXPECT_EQ(key([](SpringProblem& p) { p.density = -1e-9; }), "density");
  EXPECT_EQ(key([](SpringProblem& p) { p.gravity = std::nan(""); }), "gravity");
  EXPECT_EQ(key([](SpringProblem& p) {
              p.density = 0;
              p.gravity = -1;
            }),
            "accepted");
}

}  // namespace
}  // namespace plumbline::reference::spring_test
