// A simulation that is put into the state of another goes on as that one does, whatever its integrator keeps.
#include "cases/harness/run/simulation_state.hpp"

#include <gmock/gmock.h>

#include <limits>

#include "cases/harness/description/case.hpp"
#include "cases/harness/integrators/small_scenes.hpp"
#include "kernel/points/column_registry.hpp"

namespace plumbline::simulation_state_test {
namespace {

using testing::HasSubstr;

Archive::Table state_of(Simulation& simulation, const std::string& integrator) {
  Archive archive;
  archive_simulation(archive, simulation, integrator);
  return archive.take();
}

void set_state(Simulation& simulation, const std::string& integrator, const Archive::Table& state) {
  Archive archive(state);
  archive_simulation(archive, simulation, integrator);
  archive.require_all_read();
}

// Steps change in size on the way: what an integrator keeps of the last one counts.
void steps(Simulation& run, int from, int to) {
  for (int k = from; k < to; ++k) run.step(k % 2 == 0 ? 0.05 : 0.03);
}

class EachIntegrator : public testing::TestWithParam<std::string> {};

TEST_P(EachIntegrator, GoesOnToTheSameBits) {
  const std::string& integrator = GetParam();
  const Scene scene = workable(with_some_maps(small_scene("plate"), integrator), integrator);
  const StepControl control{.dt = 0.05};
  Simulation whole(scene, integrator, control), other(scene, integrator, control);
  steps(whole, 0, 5);
  const Archive::Table half_way = state_of(whole, integrator);
  steps(whole, 5, 10);
  steps(other, 0, 3);  // whatever it has done before
  set_state(other, integrator, half_way);
  EXPECT_EQ(other.steps(), 5);
  steps(other, 5, 10);
  EXPECT_TRUE(state_of(whole, integrator) == state_of(other, integrator));
}

std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const IntegratorEntry& entry : integrators()) {
    if (entry.name.rfind("test_", 0) != 0) all.push_back(entry.name);
  }
  return all;
}

INSTANTIATE_TEST_SUITE_P(All, EachIntegrator, testing::ValuesIn(names()), [](const auto& about) {
  std::string name = about.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

// --- states that are none of this scene ------------------------------------------------------------------------------

class Refused : public testing::Test {
 protected:
  Refused() : good(state_of(run, "musl")) {}

  void expect_refused(const Archive::Table& state, const std::string& what) {
    Simulation again(scene, "musl", {});
    try {
      set_state(again, "musl", state);
      ADD_FAILURE() << "taken in spite of: " << what;
    } catch (const ArchiveError& error) {
      EXPECT_THAT(error.what(), HasSubstr(what));
    }
  }
  Archive::Table with(const std::string& name, std::size_t k, double value) const {
    Archive::Table state = good;
    state.at(name).at(k) = value;
    return state;
  }

  Scene scene = workable(with_some_maps(small_scene("plate"), "musl"), "musl");
  Simulation run{scene, "musl", {}};
  Archive::Table good;
};

TEST_F(Refused, ColumnsOfAnotherLength) {
  Archive::Table state = good;
  state.at("bodies/0/velocity").pop_back();
  expect_refused(state, "velocity");
  state = good;
  state.at("ledger").pop_back();
  expect_refused(state, "ledger");
}

// A state in which a column that the scene has is missing: each one is missed by name.
TEST(SimulationState, AColumnThatIsNotThereIsMissed) {
  const std::vector<ColumnId> known = registered_columns();
  for (const char* name : {"plate", "gas-rings", "string"}) {
    Simulation run(workable(with_some_maps(small_scene(name), "musl"), "musl"), "musl", {.dt = 0.05});
    steps(run, 0, 2);
    const Archive::Table good = state_of(run, "musl");
    for (std::size_t k = 0; k < known.size(); ++k) {
      Archive::Table state = good;
      if (state.at("bodies/0/components")[k] == 0) continue;
      state.at("bodies/0/components")[k] = 0;
      state.erase("bodies/0/" + known[k].name());
      try {
        set_state(run, "musl", state);
        ADD_FAILURE() << name << ": taken without " << known[k].name();
      } catch (const ArchiveError& error) {
        EXPECT_THAT(error.what(), HasSubstr(known[k].name()));
      }
    }
  }
}

// Whatever columns points have, the state that was read is the one that was written, to the bit.
TEST(SimulationState, HoldsEveryColumn) {
  const Scene scene = workable(with_some_maps(small_scene("plate"), "musl"), "musl");
  Simulation from(scene, "musl", {}), to(scene, "musl", {});
  Checkpoint state = from.save();
  Columns& points = state.points[0];
  double value = 0;
  for (const ColumnId& id : registered_columns()) {
    if (!points.has(id)) points.add(id, 1);
    if (id.name() == "position") continue;
    for (double& number : points.values(id)) number = value += 0.125;
  }
  from.restore(state);
  set_state(to, "musl", state_of(from, "musl"));
  Columns read = to.save().points[0];
  for (const ColumnId& id : registered_columns()) {
    ASSERT_EQ(read.components(id), points.components(id)) << id.name();
    const auto x = points.values(id), y = read.values(id);
    EXPECT_TRUE(std::equal(x.begin(), x.end(), y.begin(), y.end())) << id.name();
  }
}

TEST_F(Refused, PointsThatAreNoneOfTheScene) {
  const double twice = good.at("bodies/0/id")[1];
  expect_refused(with("bodies/0/id", 0, twice), "out of range or there twice");
  expect_refused(with("bodies/0/id", 0, 1e6), "out of range or there twice");
  expect_refused(with("bodies/0/id", 0, -1), "out of range or there twice");
  Archive::Table state = good;
  state.at("bodies/0/split_from").push_back(0);
  expect_refused(state, "another scene");
  state.at("bodies/0/split_from").back() = 1e6;
  expect_refused(state, "split from number 1000000");
}

TEST_F(Refused, PointsOutsideTheGrid) {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), -1e300, 1e300}) {
    expect_refused(with("bodies/0/position", 3, bad), "point 3 stands outside the grid");
  }
}

TEST_F(Refused, AnotherIntegratorsMemory) {
  Simulation forgetful(scene, "musl", {}), keeping(scene, "central-difference", {});
  EXPECT_THROW(set_state(forgetful, "musl", state_of(keeping, "central-difference")), ArchiveError);
  EXPECT_THROW(set_state(keeping, "central-difference", state_of(forgetful, "musl")), ArchiveError);
}

}  // namespace
}  // namespace plumbline::simulation_state_test
