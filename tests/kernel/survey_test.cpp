// What is read off all points: the step limit, and the first that is inadmissible.
#include "kernel/survey.hpp"

#include <cmath>
#include <limits>

#include "kernel/inadmissible.hpp"
#include "tests/kernel/scenes.hpp"

namespace plumbline::survey_test {
namespace {

// h / fastest, or h^2 / (2 dim diffusivity) where that is less; none where nothing moves.
TEST(Survey, StepLimitIsTheLeastOfThree) {
  Survey survey;
  EXPECT_EQ(completed(survey, 7, 0.5, 2).step_limit, HUGE_VAL);
  EXPECT_EQ(completed(survey, 7, 0.5, 2).totals.grid_mass, 7);
  survey.bounds.fastest = 4;
  EXPECT_EQ(completed(survey, 7, 0.5, 2).step_limit, 0.125);
  survey.bounds.diffusivity = 1;
  EXPECT_EQ(completed(survey, 7, 0.5, 2).step_limit, 0.0625);
  EXPECT_EQ(completed(survey, 7, 0.5, 1).step_limit, 0.125);
}

TEST(Survey, OfTwoPartsIsInadmissibleIfOneIs) {
  Survey good, bad;
  bad.admissible = false;
  EXPECT_TRUE((good + good).admissible);
  EXPECT_FALSE((good + bad).admissible || (bad + good).admissible);
}

// Which point, which field, which value.
TEST(Survey, NamesTheFirstInadmissiblePoint) {
  const auto found = [](const ColumnId& id, double value) {
    Scene scene = scenes::rough_gas(2, "quadratic", "apic");
    scene.bodies[0].points(id)[5] = value;
    try {
      stop_at_inadmissible(scene);
    } catch (const InadmissibleState& state) {
      EXPECT_EQ(state.point, scene.bodies[0].id[5]);
      return state.field + ": " + state.reason;
    }
    return std::string("none");
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(found(column::mass, 1), "none");
  EXPECT_EQ(found(column::velocity, nan), "velocity: the velocity must be finite");
  EXPECT_EQ(found(column::position, nan), "position: the position must be finite");
  EXPECT_EQ(found(column::position, 1e3), "position: a point left the grid");
  EXPECT_EQ(found(column::position, -1e-6), "position: a point left the grid");
  EXPECT_EQ(found(column::energy, -1).substr(0, 6), "energy");
}

}  // namespace
}  // namespace plumbline::survey_test
