// What a run will cost: told without the steps by which a problem computes its start, and with their cost.
#include "cases/harness/run/estimate.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <stdexcept>

#include "cases/harness/description/case.hpp"
#include "tests/cases/harness/toy_case.hpp"

namespace plumbline::estimate_test {
namespace {

constexpr double end = 1e-2, prepared_for = 3e-2, rate = 1e7;  // s, s, particle-steps per second

// Its start takes three times as many steps as its run.
class Prepared final : public Problem {
 public:
  explicit Prepared(const Settings& settings) : toy_(Toy{}, settings) {}
  Scene scene() const override { throw std::logic_error("prepared for an estimate"); }
  Scene unprepared() const override { return toy_.scene(); }
  double preparation() const override { return prepared_for; }
  double end_time() const override { return end; }
  std::vector<Measure> measures(const Simulation&) const override { return {}; }
  Profile profile(const Simulation&) const override { return {}; }

 private:
  ToyProblem toy_;
};

TEST(Estimate, CountsThePreparationWithoutMakingIt) {
  Case entry = toy_case(Toy{});
  entry.problem = [](const Settings& settings) { return std::make_unique<Prepared>(settings); };
  const RunEstimate estimate = estimate_run(entry, entry.settings("default", {{"cells", 8.0}}));
  EXPECT_EQ(estimate.points, 3);
  EXPECT_EQ(estimate.steps, 10);
  EXPECT_NEAR(estimate.seconds, 3 * (10 + 30) / rate, 1e-12);
}

// The only preparation of the catalog that takes steps, and all others, which take none.
TEST(Estimate, TheSceneBeforeItsPreparationIsAsLarge) {
  for (const Case* entry : cases()) {
    if (!entry->trials.empty()) continue;
    const auto problem = entry->problem(entry->settings("default", {{"cells", entry->levels.front()}}));
    if (problem->preparation() == 0) continue;
    SCOPED_TRACE(entry->name);
    const Scene before = problem->unprepared(), after = problem->scene();
    EXPECT_EQ(before.grid.cells, after.grid.cells);
    EXPECT_EQ(before.grid.h, after.grid.h);
    ASSERT_EQ(before.bodies.size(), after.bodies.size());
    for (std::size_t b = 0; b < after.bodies.size(); ++b) {
      EXPECT_EQ(before.bodies[b].name, after.bodies[b].name);
      EXPECT_EQ(before.bodies[b].points.points(), after.bodies[b].points.points());
    }
  }
}

}  // namespace
}  // namespace plumbline::estimate_test
