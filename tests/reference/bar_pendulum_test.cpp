// Finite elements of a pendulum: one without mass is the elastic pendulum, many with the string's mass swing as it does.
#include "reference/bar_pendulum.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/reference/checks.hpp"

namespace plumbline::reference::bar_pendulum_test {
namespace {

const std::vector<double> frames{0.25, 0.5, 0.75, 1.0, 1.25};

void expect_as_elastic(const ElasticPendulumProblem& problem, int elements, double within) {
  const auto exact = ElasticPendulum(problem).at(frames);
  const std::vector<BarNodes> nodes = bar_pendulum(problem, elements, frames);
  for (std::size_t k = 0; k < frames.size(); ++k) {
    const auto& bob = nodes[k].back();
    EXPECT_NEAR(std::hypot(bob[0] - exact[k].x.value, bob[1] - exact[k].y.value), 0, within) << frames[k];
  }
}

TEST(BarPendulum, OneLightElementIsTheElasticPendulum) {
  ElasticPendulumProblem light = pendulum_at(0.5, 0.6);  // not York's
  light.density = 1e-4;
  expect_as_elastic(light, 1, 1e-5);
}

// The string has 2.2e-3 of the bob's mass: it changes the swing by no more than that share of its length.
TEST(BarPendulum, ManyElementsSwingAsTheElasticPendulum) {
  for (const int elements : {10, 39}) expect_as_elastic({}, elements, 2.2e-3 * 0.7346);
}

TEST(BarPendulum, FallsFreelyWhileSlack) {
  ElasticPendulumProblem slack;
  slack.strain = -0.05;
  const double time = 0.02;  // it falls 4 mm of 39
  const BarNodes nodes = bar_pendulum(slack, 4, {time}).front();
  EXPECT_NEAR(nodes.back()[1] - slack.bob_y, -0.5 * slack.gravity * time * time, 1e-4);
  slack.one_way = false;
  EXPECT_GT(std::abs(bar_pendulum(slack, 4, {time}).front().back()[1] - slack.bob_y + 0.004), 1e-3);
}

TEST(BarPendulum, RefusesWhatMakesNoBars) {
  ElasticPendulumProblem weightless;
  weightless.density = 0;
  EXPECT_EQ(refused_key([&] { bar_pendulum(weightless, 4, {1}); }), "density");
  EXPECT_EQ(refused_key([] { bar_pendulum({}, 0, {1}); }), "elements");
  EXPECT_EQ(refused_key([] { bar_pendulum({}, 4, {1, 0.5}); }), "times");
}

}  // namespace
}  // namespace plumbline::reference::bar_pendulum_test
