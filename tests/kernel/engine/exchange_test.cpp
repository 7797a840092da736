// Heat that points of a compressed gas exchange through the nodes. [Exchange 1]
#include "tests/kernel/scenes.hpp"

namespace plumbline::exchange_test {
namespace {

using scenes::Space;

class Exchange : public testing::TestWithParam<Space> {};
INSTANTIATE_TEST_SUITE_P(Spaces, Exchange, testing::ValuesIn(scenes::spaces), testing::PrintToStringParamName());

// A gas between walls, of uneven energies, some of it cold, that closes (rate < 0) or opens about the origin.
Scene closing(Space space, const std::string& shape, double rate) {
  Scene scene = scenes::rough_gas_in_space(space, shape, "apic", scenes::no_gravity, scenes::inviscid_law());
  Columns& points = scene.bodies[0].points;
  const int dim = scene.grid.dim;
  points.add(column::affine, dim * dim);
  scenes::Random random(4);
  for (int p = 0; p < points.points(); ++p) {
    points(column::energy)[p] = p % 7 ? random(0.1, 2) : 1e-6;
    for (int d = 0; d < dim; ++d) {
      points(column::velocity, d)[p] = rate * points(column::position, d)[p];
      points(column::affine, d * dim + d)[p] = rate;
    }
  }
  return scene;
}

struct Energies {
  std::vector<double> mass, start, alone, exchanged;
};

// One step without and one with the exchange, which acts after all else has been found.
Energies one_step(Scene scene, const std::string& integrator, double kappa, double dt = 1e-3) {
  Energies e;
  e.mass = scenes::by_id(scene.bodies[0], column::mass);
  e.start = scenes::by_id(scene.bodies[0], column::energy);
  for (const double k : {0.0, kappa}) {
    scene.heat_exchange = k;
    Simulation run(scene, integrator, {0.3, dt});
    run.step(1);
    (k == 0 ? e.alone : e.exchanged) = scenes::by_id(run.scene().bodies[0], column::energy);
    scenes::expect_ledger_closes(run.ledger(), 1e-13);
  }
  return e;
}

// sum_p m_p N_ip alpha_i (E_i - e_p) is zero at every node, so nothing is made or lost; and it is not nothing.
TEST_P(Exchange, ConservesEnergy) {
  for (const char* shape : {"quadratic", "cubic"}) {
    for (const char* integrator : {"energy", "leapfrog"}) {
      for (const double kappa : {1.0, 1e6}) {
        const Energies e = one_step(closing(GetParam(), shape, -2), integrator, kappa);
        double gain = 0, moved = 0;
        for (std::size_t p = 0; p < e.mass.size(); ++p) {
          gain += e.mass[p] * (e.exchanged[p] - e.alone[p]);
          moved += e.mass[p] * std::abs(e.exchanged[p] - e.alone[p]);
        }
        EXPECT_NEAR(gain, 0, 1e-15 * static_cast<double>(e.mass.size()));
        EXPECT_GT(moved, 0);
      }
    }
  }
}

// As much as kappa may be, each point ends between the coldest and the hottest: a mean of what points have, never negative.
TEST_P(Exchange, MixesAndNoMore) {
  for (const double kappa : {10.0, 1e9}) {
    const Energies e = one_step(closing(GetParam(), "cubic", -2), "leapfrog", kappa);
    const auto [coldest, hottest] = std::minmax_element(e.start.begin(), e.start.end());
    double left = 0, spread = 0;
    for (std::size_t p = 0; p < e.mass.size(); ++p) {
      const double mixed = e.start[p] + (e.exchanged[p] - e.alone[p]);
      EXPECT_GE(mixed, *coldest - 1e-15);
      EXPECT_LE(mixed, *hottest + 1e-15);
      left += std::abs(mixed - 1);
      spread += std::abs(e.start[p] - 1);
    }
    EXPECT_LT(left, spread);
  }
}

// A gas that opens everywhere exchanges nothing, bit for bit; nor does one whose points have one energy.
TEST_P(Exchange, IsNoneInExpansionOrOfEvenHeat) {
  for (const char* integrator : {"energy", "leapfrog"}) {
    const Energies opening = one_step(closing(GetParam(), "quadratic", 2), integrator, 1e6);
    EXPECT_EQ(opening.exchanged, opening.alone);
    Scene even = closing(GetParam(), "quadratic", -2);
    std::fill_n(even.bodies[0].points(column::energy), even.bodies[0].points.points(), 1.5);
    const Energies same = one_step(even, integrator, 1e6);
    for (std::size_t p = 0; p < same.mass.size(); ++p) EXPECT_NEAR(same.exchanged[p], same.alone[p], 1e-14);
  }
}

}  // namespace
}  // namespace plumbline::exchange_test
