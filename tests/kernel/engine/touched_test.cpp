// Only nodes that points reach are cleared and solved; what stands in the others must not matter.
#include "tests/kernel/scenes.hpp"

namespace plumbline::touched_test {
namespace {

using scenes::Space;

class Touched : public testing::TestWithParam<Space> {};
INSTANTIATE_TEST_SUITE_P(Spaces, Touched, testing::ValuesIn(scenes::spaces), testing::PrintToStringParamName());

// Two clouds one behind the other fly through the grid, the second over the nodes that the first has left. At every fifth step a
// fresh engine, whose nodes have never seen a point, takes over from the points alone: the same bits.
TEST_P(Touched, NothingStaysWhereACloudWas) {
  const Space space = GetParam();
  const int dim = scenes::dim_of(space), along = dim - 1;
  std::array<int, 3> cells{5, 5, 5}, low{1, 1, 1}, high{4, 4, 4};
  cells[static_cast<std::size_t>(along)] = 22;
  const GridSpec grid = scenes::box(space, cells, 0.1);
  std::vector<scenes::Place> places;
  for (int first : {1, 6}) {
    low[static_cast<std::size_t>(along)] = first;
    high[static_cast<std::size_t>(along)] = first + 2;
    const auto cloud = scenes::jittered(scenes::lattice(grid, 2, low, high), 0.01, dim,
                                        static_cast<unsigned long>(first));
    places.insert(places.end(), cloud.begin(), cloud.end());
  }
  for (const scenes::Combination& c : {scenes::Combination{"leapfrog", "cubic", "apic"},
                                       {"energy", "quadratic", "pic"},
                                       {"usavg", "linear", "flip"}}) {
    SCOPED_TRACE(c);
    scenes::Random random(3);
    Scene scene = scenes::scene_of(
        grid,
        {scenes::gas_body(scenes::rough_law(), space, places, scenes::lattice_volume(grid, 2),
                          [&](auto&) {
                            scenes::GasState state{random(0.5, 1), 1e-3 * random(1, 2)};
                            state.velocity[static_cast<std::size_t>(along)] = random(1, 1.05);
                            return state;
                          })},
        c.shape, c.transfer);
    scene.sharpening = c.shape == "linear" ? 0 : 1;
    scene.heat_exchange = 1;
    Simulation run(scene, c.integrator, {0.3, 0.03});
    for (int k = 0; k < 30; ++k) {
      const bool look = k % 5 == 4;
      Simulation fresh(scene, c.integrator, {0.3, 0.03});
      if (look) fresh.restore(run.save());
      run.step(1);
      if (!look) continue;
      fresh.step(1);
      ASSERT_TRUE(scenes::same_bits(run.scene().bodies[0], fresh.scene().bodies[0])) << "step " << k;
      scenes::expect_same_ledger(run.ledger(), fresh.ledger());
    }
    const auto x = scenes::by_id(run.scene().bodies[0], column::position, along);
    EXPECT_GT(*std::min_element(x.begin(), x.end()), 0.8);  // the first cloud began at 0.6
  }
}

}  // namespace
}  // namespace plumbline::touched_test
