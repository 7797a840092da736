#include "kernel/simulation.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <limits>

#include "tests/kernel/scenes.hpp"

namespace plumbline::simulation_test {
namespace {

using testing::HasSubstr;

// --- the step -------------------------------------------------------------------------------------------------------

TEST(Simulation, TheStepIsTheCourantNumberTimesTheLimit) {
  Scene scene = scenes::rough_gas(1, "quadratic", "apic");
  Scene same = scene;
  Ledger ledger;
  const auto engine = make_engine(same, ledger, {});
  engine->initialise();
  Simulation run(scene, "musl", {0.25, {}});
  run.step(1);
  EXPECT_EQ(run.last_dt(), 0.25 * engine->step_limit());
  EXPECT_EQ(run.time(), run.last_dt());
}

TEST(Simulation, AFixedStepOverridesTheCourantNumber) {
  Simulation run(scenes::rough_gas(1, "quadratic", "apic"), "musl", {1e-9, 0.002});
  run.step(1);
  EXPECT_EQ(run.last_dt(), 0.002);
}

TEST(Simulation, TheLastStepIsShortened) {
  Simulation run(scenes::rough_gas(1, "quadratic", "apic"), "musl", {0.3, 0.003});
  int seen = 0;
  run.run_until(0.01, [&](const Simulation& now) { EXPECT_EQ(now.steps(), ++seen); });
  EXPECT_EQ(run.steps(), 4);
  EXPECT_EQ(seen, 4);
  EXPECT_NEAR(run.last_dt(), 0.001, 1e-17);
  EXPECT_NEAR(run.time(), 0.01, 1e-17);
  EXPECT_EQ(run.points(), 18);
}

// A thousand tenths of a hundredth: the sum of steps ends within rounding of the end, without a step of nothing.
TEST(Simulation, RoundingIsNoStep) {
  UniaxialMembrane law;
  law.youngs_modulus = law.density = 1;
  Simulation run(scenes::scene_of(scenes::line(4, 1), {scenes::membrane_body(law, 1, {{2.2, 0}}, 1)}, "linear", "flip"),
                 "musl", {0.3, 0.001});
  run.run_until(1);
  EXPECT_EQ(run.steps(), 1000);
}

TEST(Simulation, RefusesUnknownNamesAndImpossibleCombinations) {
  EXPECT_THROW(Simulation(scenes::rough_gas(1, "quadratic", "apic"), "mussel", {}), std::invalid_argument);
  EXPECT_THROW(Simulation(scenes::rough_gas(1, "quintic", "apic"), "musl", {}), std::invalid_argument);
  EXPECT_THROW(Simulation(scenes::rough_gas(1, "quadratic", "tpic"), "musl", {}), std::invalid_argument);
  for (const char* integrator : {"energy", "leapfrog"}) {
    struct Refused {
      const char *shape, *transfer;
      std::vector<const char*> named;  // what lacks a trait
    };
    for (const Refused& c : {Refused{"linear", "apic", {"linear"}},
                             {"quadratic", "flip", {"flip"}},
                             {"linear", "flip", {"linear", "flip"}},
                             {"gimp", "apic", {"gimp"}},
                             {"contiguous-gimp", "pic", {"contiguous-gimp"}},
                             {"cubic", "xpic", {"xpic"}},
                             {"quadratic", "fmpm", {"fmpm"}}}) {
      try {
        Simulation(scenes::rough_gas(1, c.shape, c.transfer), integrator, {});
        ADD_FAILURE() << c.shape << ' ' << c.transfer;
      } catch (const CannotWork& error) {
        EXPECT_THAT(error.what(), HasSubstr(integrator));
        for (const char* name : c.named) EXPECT_THAT(error.what(), HasSubstr(name));
      }
    }
  }
}

// --- the stop -------------------------------------------------------------------------------------------------------

// Gas whose velocity is slope (x - centre), on a line.
Scene stretching(double slope, double gamma, const std::string& transfer = "apic") {
  IdealGas gas;
  gas.gamma = gamma;
  const GridSpec grid = scenes::line(12, 0.1);
  return scenes::scene_of(grid,
                          {scenes::gas_body(gas, 1, scenes::lattice(grid, 2, {4, 0}, {8, 1}), 0.05,
                                            [&](const scenes::Place& x) {
                                              return scenes::GasState{1, 1e-6, {slope * (x[0] - 0.6), 0}};
                                            })},
                          "quadratic", transfer);
}

InadmissibleState stop_of(Simulation&& run, double end) {
  try {
    run.run_until(end);
  } catch (const InadmissibleState& state) {
    EXPECT_THAT(state.what(), HasSubstr(state.reason));
    EXPECT_THAT(state.what(), HasSubstr("point " + std::to_string(state.point)));
    EXPECT_THAT(state.what(), HasSubstr("field " + state.field));
    EXPECT_EQ(state.step, run.steps());
    EXPECT_EQ(state.time, run.time());
    return state;
  }
  ADD_FAILURE() << "no stop";
  return {"", "", -1, "", 0};
}

// The edge of the grid lies 1e-9 of a cell outside, and belongs to it.
TEST(Stop, NotOnTheVeryEdge) {
  Scene scene = stretching(0, 1.4);
  Columns& points = scene.bodies[0].points;
  points(column::position)[0] = 0.0 - 1e-9 * 0.1;
  std::fill_n(points(column::energy), 8, 0.0);  // nothing moves
  Simulation run(std::move(scene), "musl", {0.3, 1e-9});
  EXPECT_NO_THROW(run.step(1));
  EXPECT_EQ(scenes::by_id(run.scene().bodies[0], column::position, 0)[0], 0.0 - 1e-9 * 0.1);
}

// All points drift to the right by 0.02 a step; the last one, at 0.775, passes the end at 1.2 in its 22nd.
TEST(Stop, APointLeftTheGrid) {
  for (const char* integrator : {"usf", "musl", "energy"}) {
    Scene scene = stretching(0, 1.4);
    std::fill_n(scene.bodies[0].points(column::velocity), 8, 2.0);
    const InadmissibleState state = stop_of(Simulation(scene, integrator, {0.3, 0.01}), 1);
    EXPECT_EQ(state.body, "gas");
    EXPECT_EQ(state.point, 7);
    EXPECT_EQ(state.field, "position");
    EXPECT_GT(state.value, 1.2);
    EXPECT_LT(state.value, 1.23);
    EXPECT_EQ(state.step, 22);
    EXPECT_NEAR(state.time, 0.21, 1e-15);
    EXPECT_THAT(state.reason, HasSubstr("left the grid"));
  }
}

TEST(Stop, APointMovedMoreThanOneCell) {
  Scene scene = stretching(0, 1.4);
  std::fill_n(scene.bodies[0].points(column::velocity), 8, 2.0);
  const InadmissibleState state = stop_of(Simulation(scene, "musl", {0.3, 0.06}), 1);
  EXPECT_EQ(state.field, "velocity");
  EXPECT_EQ(state.point, 0);
  EXPECT_NEAR(state.value, 2, 1e-3);
  EXPECT_EQ(state.step, 1);
  EXPECT_EQ(state.time, 0);
  EXPECT_THAT(state.reason, HasSubstr("more than one cell"));
}

// de = -(gamma - 1) e div v dt: with gamma 6 and div v dt = 0.25 it takes 1.25 e away. [York 4.8]
TEST(Stop, NegativeInternalEnergy) {
  const InadmissibleState state = stop_of(Simulation(stretching(5, 6), "usl", {0.3, 0.05}), 1);
  EXPECT_EQ(state.field, "energy");
  EXPECT_LT(state.value, 0);
  EXPECT_EQ(state.step, 1);
}

// rho / (1 + dt div v) with dt div v = -1.5. [York 4.7]
TEST(Stop, NegativeDensity) {
  Scene scene = stretching(-15, 1.4);
  scene.density = DensityMethod::continuity;
  Columns& points = scene.bodies[0].points;
  for (int p = 0; p < 8; ++p) {  // within 0.05 of the centre, so that none moves a cell
    points(column::position)[p] = 0.6 + 0.0125 * (p - 3.5);
    points(column::velocity)[p] = -15 * 0.0125 * (p - 3.5);
  }
  points.add(column::affine);
  std::fill_n(points(column::affine), 8, -15.0);
  const InadmissibleState state = stop_of(Simulation(scene, "usl", {0.3, 0.1}), 1);
  EXPECT_EQ(state.field, "density");
  EXPECT_LT(state.value, 0);
}

TEST(Stop, NonFiniteValues) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  for (double bad : {nan, infinity}) {
    for (const ColumnId* id : {&column::velocity, &column::energy, &column::position, &column::mass}) {
      for (const scenes::Combination& c : scenes::working_combinations()) {
        Scene scene = stretching(0.1, 1.4, c.transfer);
        scene.shape = c.shape;
        scene.bodies[0].points(*id)[5] = bad;
        try {
          Simulation run(scene, c.integrator, {0.3, 0.01});
          for (int k = 0; k < 2; ++k) run.step(1);
          ADD_FAILURE() << c << ": " << id->name() << " = " << bad << " goes on";
        } catch (const InadmissibleState& state) {
          EXPECT_FALSE(state.field.empty());
        }
      }
    }
  }
}

TEST(Stop, NamesThePointAsTheSceneMadeIt) {
  Scene scene = stretching(0, 1.4);
  Columns& points = scene.bodies[0].points;
  std::reverse(points(column::position), points(column::position) + 8);  // sorting turns them round again
  points(column::energy)[6] = -1;
  const InadmissibleState state = stop_of(Simulation(scene, "musl", {0.3, 1e-4}), 1);
  EXPECT_EQ(state.point, 6);
  EXPECT_EQ(state.field, "energy");
  EXPECT_NEAR(state.value, -1, 1e-2);
}

// --- the same again -------------------------------------------------------------------------------------------------

// Gas in a box that swirls, so that points overtake each other and are sorted on the way.
Scene swirling(scenes::Space space, const std::string& shape, const std::string& transfer, bool shuffled = false) {
  const int dim = scenes::dim_of(space);
  Scene scene = scenes::rough_gas(space, shape, transfer, scenes::no_gravity);
  scene.grid.walls = scenes::walls_everywhere(Wall::symmetry);
  scene.grid.cells = {6, 4, 1};  // filled: no free edge whose light nodes linear shapes throw about
  if (dim == 3) {
    scene.grid.cells = {4, 3, 3};
    scene.grid.origin[2] = 0.1;
  }
  Columns& points = scene.bodies[0].points;
  const double k = std::acos(-1.0) / 0.6, l = std::acos(-1.0) / 0.4;
  for (int p = 0; p < points.points(); ++p) {
    const double x = points(column::position)[p], y = dim > 1 ? points(column::position, 1)[p] : 0;
    points(column::velocity)[p] = std::sin(k * x) * std::cos(l * y);
    if (dim > 1) points(column::velocity, 1)[p] = -k / l * std::cos(k * x) * std::sin(l * y);
  }
  if (!shuffled) return scene;
  std::vector<int> order(scene.bodies[0].id);
  scenes::Random random(99);
  for (std::size_t i = order.size() - 1; i > 0; --i)
    std::swap(order[i], order[static_cast<std::size_t>(random(0, i + 1.0))]);
  points.reorder(order);
  return scene;
}

TEST(Repeat, TheSameRunHasTheSameBits) {
  for (const scenes::Combination& c : scenes::working_combinations()) {
    for (scenes::Space space : scenes::spaces) {
      if (!scenes::runs_in(c, space)) continue;
      Simulation one(swirling(space, c.shape, c.transfer), c.integrator, {0.3, {}}),
          other(swirling(space, c.shape, c.transfer), c.integrator, {0.3, {}});
      for (int k = 0; k < 5; ++k) {
        one.step(1);
        other.step(1);
      }
      EXPECT_TRUE(scenes::same_bits(one.scene().bodies[0], other.scene().bodies[0])) << c;
      scenes::expect_same_ledger(one.ledger(), other.ledger());
    }
  }
}

// Saved, carried into another simulation of the same scene and continued: every bit of the points and of the
// ledger.
TEST(Repeat, ARestoredRunContinuesBitwise) {
  for (const scenes::Combination& c : scenes::working_combinations()) {
    for (scenes::Space space : scenes::spaces) {
      if (!scenes::runs_in(c, space)) continue;
      SCOPED_TRACE(testing::Message() << space << ", " << c);
      const Scene scene = swirling(space, c.shape, c.transfer, true);
      Simulation whole(scene, c.integrator, {0.3, {}}), first(scene, c.integrator, {0.3, {}}),
          second(scene, c.integrator, {0.3, {}});
      for (int k = 0; k < 12; ++k) whole.step(1);
      for (int k = 0; k < 7; ++k) first.step(1);
      second.restore(first.save());
      EXPECT_EQ(second.time(), first.time());
      EXPECT_EQ(second.steps(), 7);
      for (int k = 0; k < 5; ++k) second.step(1);
      EXPECT_TRUE(scenes::same_bits(whole.scene().bodies[0], second.scene().bodies[0]));
      EXPECT_EQ(whole.time(), second.time());
      scenes::expect_same_ledger(whole.ledger(), second.ledger());
    }
  }
}

// So does what an integrator keeps beside the points: the steps change in length on the way, and the first steps of a new run
// would be others. A checkpoint stays as it was while the run it came from goes on.
TEST(Repeat, ARestoredRunHasItsIntegratorsMemory) {
  for (const char* name : {"generalized-alpha", "central-difference"}) {
    SCOPED_TRACE(name);
    const Scene scene = scenes::rough_gas(2, "quadratic", "flip");
    const auto steps = [](Simulation& run, int from, int to) {
      for (int k = from; k < to; ++k) run.step(k % 2 == 0 ? 1e-3 : 2e-3);
    };
    const StepControl control{0.9, 2e-3};
    Simulation whole(scene, name, control), first(scene, name, control), second(scene, name, control);
    steps(whole, 0, 9);
    steps(first, 0, 4);
    const Checkpoint checkpoint = first.save();
    steps(first, 4, 6);
    second.restore(checkpoint);
    steps(second, 4, 9);
    EXPECT_TRUE(scenes::same_bits(whole.scene().bodies[0], second.scene().bodies[0]));
    scenes::expect_same_ledger(whole.ledger(), second.ledger());
    Simulation forgetful(first.scene(), name, control);
    steps(forgetful, 6, 9);
    EXPECT_FALSE(scenes::same_bits(whole.scene().bodies[0], forgetful.scene().bodies[0]));
  }
}

TEST(Repeat, ACheckpointOfAnotherSceneIsRefused) {
  Simulation one(scenes::rough_gas(1, "quadratic", "apic"), "musl", {}),
      other(scenes::rough_gas(2, "quadratic", "apic"), "musl", {});
  EXPECT_THROW(one.restore(other.save()), std::invalid_argument);
}

// --- sorting --------------------------------------------------------------------------------------------------------

TEST(Sorting, PointsStandByCellAndKeepTheirNumbers) {
  Simulation run(swirling(scenes::Space::plane, "linear", "apic"), "musl", {0.3, {}});
  const std::vector<int> before = run.scene().bodies[0].id;
  const std::vector<double> mass = scenes::by_id(run.scene().bodies[0], column::mass);
  run.run_until(0.3);
  const Body& body = run.scene().bodies[0];
  EXPECT_NE(body.id, before);  // the swirl mixed them
  EXPECT_EQ(scenes::by_id(body, column::mass), mass);
  std::size_t out_of_order = 0;
  const auto cell = [&](std::size_t p) {
    return 6 * std::floor(body.points(column::position, 1)[p] / 0.1) +
           std::floor(body.points(column::position)[p] / 0.1);
  };
  for (std::size_t p = 1; p < body.id.size(); ++p) out_of_order += cell(p) < cell(p - 1);
  EXPECT_LE(out_of_order, body.id.size() / 16);  // they were sorted before they moved; a step carries few across
  run.refresh_density();                         // sorts once more
  out_of_order = 0;
  for (std::size_t p = 1; p < body.id.size(); ++p) out_of_order += cell(p) < cell(p - 1);
  EXPECT_EQ(out_of_order, 0u);
}

// Listed in another order, the same points with the same numbers do bit for bit the same: within a bin they stand by their
// numbers, however they came there.
TEST(Sorting, TheOrderOfPointsIsCanonical) {
  for (scenes::Space space : scenes::spaces) {
    for (const char* integrator : {"energy", "usf", "musl"}) {
      SCOPED_TRACE(testing::Message() << space << ' ' << integrator);
      const Scene scene = swirling(space, "quadratic", "apic");
      Scene shuffled = scene;
      Body& body = shuffled.bodies[0];
      std::vector<int> order(body.id);
      scenes::Random random(98);
      for (std::size_t i = order.size() - 1; i > 0; --i) {
        std::swap(order[i], order[static_cast<std::size_t>(random(0, i + 1.0))]);
      }
      body.points.reorder(order);
      body.id = order;
      Simulation one(scene, integrator, {0.3, {}}), other(shuffled, integrator, {0.3, {}});
      for (int k = 0; k < 30; ++k) {
        one.step(1);
        other.step(1);
        ASSERT_TRUE(scenes::same_bits(one.scene().bodies[0], other.scene().bodies[0])) << "step " << k;
      }
      if (space != scenes::Space::line) {
        EXPECT_NE(one.scene().bodies[0].id, scene.bodies[0].id);  // they were sorted on the way
      }
    }
  }
}

// The order in which a scene lists its points is no physics: shuffled, the same points do the same to rounding,
// which twenty steps of a compressible gas let grow by less than a hundred.
TEST(Sorting, ShuffledPointsDoTheSame) {
  for (scenes::Space space : scenes::spaces) {
    std::vector<int> order(swirling(space, "quadratic", "apic").bodies[0].id);
    scenes::Random random(99);
    for (std::size_t i = order.size() - 1; i > 0; --i)
      std::swap(order[i], order[static_cast<std::size_t>(random(0, i + 1.0))]);
    Simulation one(swirling(space, "quadratic", "apic"), "energy", {0.3, {}}),
        other(swirling(space, "quadratic", "apic", true), "energy", {0.3, {}});
    for (int k = 0; k < 20; ++k) {
      one.step(1);
      other.step(1);
    }
    for (const ColumnId* id : {&column::position, &column::velocity, &column::energy}) {
      const auto a = scenes::by_id(one.scene().bodies[0], *id), b = scenes::by_id(other.scene().bodies[0], *id);
      for (std::size_t p = 0; p < a.size(); ++p) EXPECT_NEAR(b[p], a[static_cast<std::size_t>(order[p])], 1e-13);
    }
    EXPECT_NEAR(one.ledger().energy.store(), other.ledger().energy.store(), 1e-14);
  }
}

// Chains keep the order of their connectivity.
TEST(Sorting, ChainsAreNeverSorted) {
  UniaxialMembrane law;
  law.youngs_modulus = law.density = 1;
  const GridSpec grid = scenes::plane(6, 6, 0.1);
  std::vector<scenes::Place> places;
  for (int k = 0; k < 12; ++k) places.push_back({0.45 - 0.03 * k, 0.45 - 0.02 * k});
  Simulation run(scenes::scene_of(grid, {scenes::membrane_body(law, 2, places, 0.01)}, "quadratic", "flip"), "musl",
                 {0.3, {}});
  run.step(1);
  const std::vector<int>& id = run.scene().bodies[0].id;
  EXPECT_TRUE(std::is_sorted(id.begin(), id.end()));
}

}  // namespace
}  // namespace plumbline::simulation_test
