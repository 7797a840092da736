// No result depends on the number of threads, and lanes of a pack that are no points reach nobody.
#include "kernel/parallel.hpp"

#include <numeric>

#include "kernel/pack.hpp"
#include "tests/kernel/scenes.hpp"

namespace plumbline::parallel_test {
namespace {

using scenes::Space;

TEST(Parallel, EveryPieceOnce) {
  for (int threads : {1, 2, 3}) {
    for (int count : {0, 1, 2, 7, 10000}) {
      std::vector<int> met(static_cast<std::size_t>(count));
      for_each_piece(count, threads, [&](int k) { ++met[static_cast<std::size_t>(k)]; });
      EXPECT_EQ(std::accumulate(met.begin(), met.end(), 0), count);
      for_each_index(count, threads, [&](int k) { ++met[static_cast<std::size_t>(k)]; });
      for (int m : met) EXPECT_EQ(m, 2);
    }
  }
}

// Thousands of points over dozens of blocks, unevenly spread, that swirl and stream: two gases with one velocity field,
// a third with its own, and where there are chains one of them.
Scene crowd(Space space, const std::string& shape, const std::string& transfer) {
  const int dim = scenes::dim_of(space);
  const std::array<int, 3> cells = dim == 1   ? std::array{900, 1, 1}
                                   : dim == 2 ? std::array{24, 48, 1}
                                              : std::array{6, 7, 16};
  const GridSpec grid = scenes::box(
      space, cells, 0.1,
      scenes::walls(Wall::symmetry, Wall::no_slip, Wall::no_slip, Wall::symmetry, Wall::symmetry, Wall::no_slip));
  const int per_cell = dim == 1 ? 4 : 2, last = dim - 1;
  const auto gas = [&](const IdealGas& law, unsigned long seed, double from, double to) {
    std::array<int, 3> low{0, 0, 0}, high = cells;
    low[static_cast<std::size_t>(last)] = static_cast<int>(from * cells[static_cast<std::size_t>(last)]);
    high[static_cast<std::size_t>(last)] = static_cast<int>(to * cells[static_cast<std::size_t>(last)]);
    auto places = scenes::jittered(scenes::lattice(grid, per_cell, low, high), 0.01, dim, seed);
    scenes::Random random(seed);
    return scenes::gas_body(law, space, places, scenes::lattice_volume(grid, per_cell), [&](const scenes::Place& x) {
      return scenes::GasState{random(0.5, 1.5), random(1, 2), {std::sin(9 * x[1]), random(-1, 1), std::cos(5 * x[0])}};
    });
  };
  std::vector<Body> bodies{gas(scenes::rough_law(), 1, 0, 0.7), gas(scenes::inviscid_law(), 2, 0.5, 1),
                           gas(scenes::inviscid_law(), 3, 0.2, 0.9)};
  bodies[2].field = "own";
  if (space == Space::line || space == Space::plane) {
    UniaxialMembrane law;
    law.youngs_modulus = law.density = 1;
    std::vector<scenes::Place> places;
    for (int k = 0; k < 600; ++k) places.push_back({0.3 + 0.003 * k, 2 + 1.5 * std::sin(0.01 * k), 0});
    bodies.push_back(scenes::membrane_body(law, dim, places, 0.01));
  }
  return scenes::scene_of(grid, std::move(bodies), shape, transfer, {0, -1, 0});
}

class Threads : public testing::TestWithParam<Space> {};
INSTANTIATE_TEST_SUITE_P(Spaces, Threads, testing::ValuesIn(scenes::spaces), testing::PrintToStringParamName());

// Every bit of every column of every body, their order, the ledger and the step.
TEST_P(Threads, AnyNumberGivesTheSameBits) {
  const scenes::Combination combinations[] = {
      {"leapfrog", "cubic", "apic"}, {"energy", "quadratic", "pic"}, {"usavg", "linear", "flip"}};
  for (const scenes::Combination& c : combinations) {
    SCOPED_TRACE(c);
    Scene scene = crowd(GetParam(), c.shape, c.transfer);
    scene.sharpening = scene.heat_exchange = c.integrator == "leapfrog" ? 1 : 0;
    Simulation one(scene, c.integrator, {0.1, {}, 1});
    for (int k = 0; k < 3; ++k) one.step(1);
    one.refresh_density();
    for (int threads : {2, 3}) {
      SCOPED_TRACE(threads);
      Simulation many(scene, c.integrator, {0.1, {}, threads});
      for (int k = 0; k < 3; ++k) many.step(1);
      many.refresh_density();
      EXPECT_EQ(one.time(), many.time());
      scenes::expect_same_ledger(one.ledger(), many.ledger());
      for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
        EXPECT_TRUE(scenes::same_bits(one.scene().bodies[b], many.scene().bodies[b])) << "body " << b;
      }
    }
  }
}

// Two clouds of three points, far apart but one after the other in the columns, so that packs of the first have the
// second's points in their other lanes, and packs of the second what lies behind the columns. Whatever the one is, the other
// does not notice, bit for bit.
TEST_P(Threads, NeighboursInAPackDoNotMeet) {
  const Space space = GetParam();
  const GridSpec grid = scenes::box(space, {12, 12, 12}, 1.0);
  for (const scenes::Combination& c : scenes::working_combinations()) {
    if (c.integrator.starts_with("test_")) continue;
    if (c.integrator == "implicit-midpoint") continue;  // solves for all points at once: each rounds with every other
    if (!scenes::runs_in(c, space)) continue;
    SCOPED_TRACE(c);
    std::vector<scenes::Place> places;
    for (double x : {2.0, 9.0}) {
      for (double s : {0.1, 0.2, 0.35}) places.push_back({x + s, x + 0.3 - s, x + s});
    }
    scenes::Random random(2);
    Scene scene = scenes::scene_of(grid,
                                   {scenes::gas_body(scenes::rough_law(), space, places, 0.02,
                                                     [&](auto&) {
                                                       const double v = random(-0.1, 0.1);
                                                       return scenes::GasState{1, random(1, 2), {v, 0.5 * v, -v}};
                                                     })},
                                   c.shape, c.transfer);
    const auto run = [&](int first_changed) {
      Scene own = scene;
      Columns& points = own.bodies[0].points;
      for (const ColumnId* id :
           {&column::mass, &column::volume, &column::velocity, &column::energy, &column::density}) {
        for (int k = 0; k < points.components(*id); ++k) {
          for (int p = first_changed; p >= 0 && p < first_changed + 3; ++p) points(*id, k)[p] *= 3.7;
          if (first_changed < 0 || k + 1 < points.components(*id)) continue;
          for (int lane = 0; lane < lanes; ++lane) points(*id, k)[points.points() + lane] = 3.7;
        }
      }
      Ledger ledger;
      const IntegratorEntry& entry = *find_integrator(c.integrator);
      const auto integrator = entry.make();
      const auto engine = make_engine(own, ledger, engine_options(entry));
      engine->initialise();
      for (int k = 0; k < 2; ++k) integrator->step(*engine, 0.01);
      return own.bodies[0];
    };
    const Body same = run(-1);
    for (int first_changed : {0, 3}) {
      const Body other = run(first_changed);
      const int first = 3 - first_changed;
      for (const ColumnId* id :
           {&column::position, &column::velocity, &column::energy, &column::volume, &column::stress}) {
        for (int k = 0; k < other.points.components(*id); ++k) {
          for (int p = first; p < first + 3; ++p)
            EXPECT_EQ(other.points(*id, k)[p], same.points(*id, k)[p]) << id->name() << p;
        }
      }
    }
  }
}

}  // namespace
}  // namespace plumbline::parallel_test
