// A mass on a string with slack: closed form against York's problem, energy, and its limits.
#include "reference/slack_string.hpp"

#include "reference/circle.hpp"
#include "reference/spring.hpp"
#include "tests/reference/checks.hpp"

namespace plumbline::reference::slack_string_test {
namespace {

const SlackStringProblem soft{3e4, 0.02, 0.8, 2.1, 9.81, 0.13};
const SlackStringProblem stiff{2e9, 0.3, 1.7, 0.4, 3.7, 0.5};

TEST(SlackString, YorksProblem) {
  const SlackString york{SlackStringProblem{}};
  // Half of the last digit of an earlier computation by hand of the same sizes; Fig. 29 shows 0.013, 0.023, 0.0375.
  expect_near(york.taut_time(), 0.012649, 5e-7);
  expect_near(york.release_time(), 0.024127, 5e-7);
  expect_near(york.apex_time(), 0.036776, 5e-7);
  expect_near(york.max_displacement(), 0.03280, 5e-6);
}

TEST(SlackString, EnergyIsThatOfTheStart) {
  for (const SlackStringProblem& p : {SlackStringProblem{}, soft, stiff}) {
    const SlackString string(p);
    for (double share : {0.0, 0.1, 0.34, 0.4, 0.5, 0.66, 0.9, 1.0, 2.3, 7.45}) {
      const double t = share * string.apex_time().value;
      const Bounded fall = Bounded(p.mass) * p.gravity * string.displacement(t);
      const double scale = p.mass * p.gravity * string.max_displacement().value;
      expect_zero(string.kinetic_energy(t) + string.string_energy(t) - fall, scale, "energy", 1e-10);
    }
  }
}

TEST(SlackString, ObeysNewton) {
  for (const SlackStringProblem& p : {SlackStringProblem{}, soft}) {
    const SlackString string(p);
    const double h = 1e-4 / string.omega().value, top = string.max_tension().value + p.mass * p.gravity;
    for (double share : {0.1, 0.4, 0.5, 0.6, 0.85, 1.2, 1.5}) {
      const double t = share * string.apex_time().value;
      const double rate = (string.velocity(t + h).value - string.velocity(t - h).value) / (2 * h);
      const double slope = (string.displacement(t + h).value - string.displacement(t - h).value) / (2 * h);
      // truncation (omega h)^2/6 = 2e-9, rounding 1e-15/(omega h)
      EXPECT_NEAR(p.mass * rate, p.mass * p.gravity - string.tension(t).value, 1e-8 * top) << share;
      EXPECT_NEAR(slope, string.velocity(t).value, 1e-8 * string.omega().value * string.max_displacement().value);
    }
  }
}

TEST(SlackString, IsContinuousWhereTheStringChanges) {
  for (const SlackStringProblem& p : {SlackStringProblem{}, soft, stiff}) {
    const SlackString string(p);
    for (Bounded edge : {string.taut_time(), string.release_time()}) {
      expect_same({string.displacement(edge.value).value, string.displacement(edge.value).bound}, Bounded(p.slack));
      const Bounded pull = string.tension(edge.value), rate = string.stiffness() * string.taut_speed();
      EXPECT_LE(pull.value, pull.bound + 2 * rate.value * edge.bound);
      EXPECT_LE(pull.bound, 1e-10 * string.max_tension().value);
      EXPECT_NEAR(std::abs(string.velocity(edge.value).value), string.taut_speed().value,
                  1e-12 * string.taut_speed().value);
    }
    EXPECT_LE(string.displacement(string.apex_time().value).value, 1e-14 * p.slack);
    EXPECT_GT(string.velocity(0.999 * string.taut_time().value).value, 0);
    EXPECT_LT(string.velocity(1.001 * string.release_time().value).value, 0);
  }
}

TEST(SlackString, LowestPointIsHalfWay) {
  for (const SlackStringProblem& p : {SlackStringProblem{}, soft, stiff}) {
    const SlackString string(p);
    const double half = 0.5 * string.apex_time().value;
    EXPECT_NEAR(string.displacement(half).value, string.max_displacement().value,
                1e-12 * string.max_displacement().value);
    EXPECT_NEAR(string.tension(half).value, string.max_tension().value, 1e-9 * string.max_tension().value);
  }
}

TEST(SlackString, WithoutSlackItIsTheSpring) {  // [York 5.11]
  const SlackString string({1e6, 0.1, 0.3, 3.33, 250, 0});
  const MasslessSpring spring({1e6, 0.1, 0.3, 3.33, 0, 250});
  expect_same(string.apex_time(), spring.period());
  EXPECT_EQ(string.taut_time().value, 0);
  for (double t : {0.0, 0.001, 0.007, 0.0198, 0.043}) {
    EXPECT_NEAR(string.displacement(t).value, spring.displacement(t).value, 1e-16);
    EXPECT_NEAR(string.velocity(t).value, spring.velocity(t).value, 1e-13);
  }
}

TEST(SlackString, AHardStringTurnsTheMassInHalfAPeriod) {
  SlackStringProblem hard = stiff;
  hard.youngs_modulus = 1e18;
  const SlackString string(hard);
  const Bounded taut = string.release_time() - string.taut_time();
  // atan(v w/g) = pi/2 - g/(v w) and less
  const double fraction = hard.gravity / (string.taut_speed() * string.omega()).value;
  EXPECT_NEAR(taut.value * string.omega().value, pi.value, 3 * fraction + 1e8 * taut.bound);
}

TEST(SlackString, RepeatsAfterManyCyclesWithinItsBounds) {
  const SlackString string(soft);
  const double period = string.apex_time().value;
  for (double share : {0.05, 0.3, 0.5, 0.77}) {
    const Bounded first = string.displacement(share * period), late = string.displacement((1000 + share) * period);
    EXPECT_LE(std::abs(first.value - late.value), first.bound + late.bound + 1e-12 * string.max_displacement().value);
    EXPECT_LE(late.bound, 1e-10 * string.max_displacement().value);
  }
}

TEST(SlackStringProblem, WrongProblemsAreRefusedByKey) {
  auto key = [](const SlackStringProblem& problem) { return refused_key([&] { SlackString string(problem); }); };
  EXPECT_EQ(key({0, 1, 1, 1, 1, 1}), "youngs_modulus");
  EXPECT_EQ(key({1, 0, 1, 1, 1, 1}), "area");
  EXPECT_EQ(key({1, 1, 0, 1, 1, 1}), "length");
  EXPECT_EQ(key({1, 1, 1, 0, 1, 1}), "mass");
  EXPECT_EQ(key({1, 1, 1, 1, 0, 1}), "gravity");
  EXPECT_EQ(key({1, 1, 1, 1, 1, -1}), "slack");
  EXPECT_EQ(refused_key([] { SlackString({}).displacement(-1); }), "time");
}

}  // namespace
}  // namespace plumbline::reference::slack_string_test
