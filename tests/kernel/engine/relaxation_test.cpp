// Null-space modes of the motions and strains of a chain of points. [Coupling 2] [Coupling 3]
#include <numbers>

#include "tests/kernel/coupled_scenes.hpp"
#include "tests/kernel/solids.hpp"

namespace plumbline::relaxation_test {
namespace {

using scenes::Place;
using scenes::Skin;
using scenes::Space;

// Sums of some hundred terms of order one.
constexpr double rounding = 1e-14;

struct Way {
  const char *integrator, *shape, *transfer;
};
std::ostream& operator<<(std::ostream& out, const Way& w) {
  return out << w.integrator << ' ' << w.shape << ' ' << w.transfer;
}
constexpr Way ways[] = {{"leapfrog", "cubic", "apic"},
                        {"energy", "quadratic", "apic"},
                        {"musl", "quadratic", "flip"},
                        {"usavg", "cubic", "pic"}};

Scene skin_alone(Skin skin, Space space, const Way& way) {
  Scene scene = scenes::gas_and_skin(skin, space, way.shape, way.transfer, false);
  scene.bodies.erase(scene.bodies.begin());
  return scene;
}

// After one step of dt without and with the key.
struct Pair {
  Scene without, with;
  Ledger ledger_without, ledger_with;
};
template <class Set>
Pair one_step(Scene scene, const Way& way, double dt, Set&& set) {
  Simulation off(scene, way.integrator, {0.3, dt});
  set(scene);
  Simulation on(scene, way.integrator, {0.3, dt});
  off.step(1);
  on.step(1);
  return {off.scene(), on.scene(), off.ledger(), on.ledger()};
}

double energy_as_it_stands(const Body& body) {
  Columns points = body.points;
  body.material->describe(points);
  return body.material->stored_energy(points, all_points(points));
}

class Relaxation : public testing::TestWithParam<Space> {};
INSTANTIATE_TEST_SUITE_P(Spaces, Relaxation, testing::ValuesIn(scenes::spaces), testing::PrintToStringParamName());

// Points stand where the same step alone puts them, and there by
//   theta tau (F_p / m_p - sum_i N_ip A_i), A_i = sum_p F_p N_ip / sum_p m_p N_ip
// further on, with the weights of where they were located; nothing else differs. The centre of mass stays, and the
// energy of the segments goes down, as the fastest oscillation allows up to theta = 1: by theta tau |(1 - S)F/m|^2 (1 -
// theta/2) at least. [Coupling 2]
TEST_P(Relaxation, MovesPointsByTheFormula) {
  const int dim = scenes::dim_of(GetParam());
  for (const Way& way : ways) {
    for (const Skin skin : {Skin::segments, Skin::closed_segments}) {
      for (const double theta : {0.3, 1.0}) {
        SCOPED_TRACE(testing::Message() << way << ' ' << skin << ' ' << theta);
        const Scene start = skin_alone(skin, GetParam(), way);
        const double dt = 4e-3;
        const auto [off, on, ledger_off, ledger_on] = one_step(start, way, dt,
                                                               [&](Scene& s) { s.chain_relaxation = theta; });
        const auto located = scenes::places_of(start.bodies[0], dim,
                                               std::string(way.integrator) == "leapfrog" ? dt / 2 : 0);
        const Body &alone = off.bodies[0], &relaxed = on.bodies[0];
        const auto mass = scenes::by_id(alone, column::mass);
        std::vector<double> force;
        const double tau = alone.material->point_forces(alone.points, force);
        double moved = 0, drop = 0;
        for (int d = 0; d < dim; ++d) {
          std::vector<double> own(mass.size());
          for (std::size_t p = 0; p < own.size(); ++p)
            own[p] = force[static_cast<std::size_t>(d) * own.size() + p] / mass[p];
          const auto seen = scenes::seen_by_nodes(way.shape, start.grid, located, mass, own);
          const auto x = scenes::by_id(alone, column::position, d), y = scenes::by_id(relaxed, column::position, d);
          double shift = 0;
          for (std::size_t p = 0; p < own.size(); ++p) {
            const double step = theta * tau * (own[p] - seen[p]);
            EXPECT_NEAR(y[p] - x[p], step, rounding) << d << ' ' << p;
            shift += mass[p] * (y[p] - x[p]);
            moved = std::max(moved, std::abs(step));
            drop += mass[p] * theta * (1 - theta / 2) * tau * (own[p] - seen[p]) * (own[p] - seen[p]);
          }
          EXPECT_NEAR(shift, 0, 1e-16);
          EXPECT_EQ(scenes::by_id(alone, column::velocity, d), scenes::by_id(relaxed, column::velocity, d));
          EXPECT_EQ(ledger_off.momentum[static_cast<std::size_t>(d)].store(),
                    ledger_on.momentum[static_cast<std::size_t>(d)].store());
        }
        EXPECT_GT(moved, 1e-5);
        EXPECT_LE(energy_as_it_stands(relaxed), energy_as_it_stands(alone) - drop * (1 - 1e-9));
        scenes::expect_ledger_closes(ledger_on, 1e-12);
      }
    }
  }
}

// Ten steps at large: the ledger closes, angular momentum too, and what moving points does to that is booked, not
// nothing. The velocities of one step do not know of it. [Coupling 2]
TEST_P(Relaxation, LedgerClosesWithTheTurnOfMovedPoints) {
  for (const Way& way : ways) {
    Scene scene = skin_alone(Skin::segments, GetParam(), way);
    const auto [off, on, ledger_off, ledger_on] = one_step(scene, way, 4e-3, [](Scene& s) { s.chain_relaxation = 1; });
    const Account &alone = ledger_off.angular_momentum[2], &moved = ledger_on.angular_momentum[2];
    if (scene.grid.dim > 1 && !scene.grid.axisymmetric) {
      EXPECT_NEAR(moved.store() - alone.store(), moved.flow(Flow::integration) - alone.flow(Flow::integration),
                  rounding * moved.scale());
      EXPECT_GT(std::abs(moved.store() - alone.store()), 1e4 * rounding * moved.scale());
    }
    scene.chain_relaxation = 0.7;
    Simulation run(scene, way.integrator, {0.3, 4e-3});
    for (int k = 0; k < 10; ++k) run.step(1);
    scenes::expect_ledger_closes(run.ledger(), 1e-12);
  }
}

// A slight zigzag with four points a cell between two mirrors, under the strain eps: splines do not see it, so nodes
// feel nothing but (d/h)^2 of it, and
//   d <- d (1 - theta eps / (1 + eps)),  F = -4 T d / l, T = E A eps, l = L (1 + eps), m / tau = 4 E A / L.
// End points stay on the walls, all others on their lines. [Coupling 2]
TEST(Relaxed, ZigzagDecays) {
  for (const Way& way : ways) {
    if (std::string(way.integrator) == "musl") continue;
    for (const double theta : {0.25, 0.5, 1.0}) {
      const double h = 0.1, s = h / 4, rest = s / 1.5, start = 1e-6 * s;
      const int n = 33;
      std::vector<Place> places;
      for (int k = 0; k < n; ++k) places.push_back({k * s, 0.411 + (k % 2 ? -start : start), 0});
      Body body = scenes::skin_body(Skin::segments, Space::plane, places, 0.02 * s);
      for (int k = 0; k < n; ++k) body.points(column::rest_length)[k] = rest;
      for (const int end : {0, n - 1}) {
        body.points(column::mass)[end] /= 2;
        body.points(column::volume)[end] /= 2;
      }
      Scene scene = scenes::scene_of(scenes::plane(8, 8, h, scenes::walls(Wall::symmetry, Wall::symmetry)),
                                     {std::move(body)}, way.shape, way.transfer);
      scene.chain_relaxation = theta;
      Simulation run(scene, way.integrator, {0.3, 1e-3});
      double d = start;
      for (int step = 0; step < 12; ++step) {
        d *= 1 - theta * 0.5 / 1.5;
        run.step(1);
        const Columns& points = run.scene().bodies[0].points;
        for (int k = 0; k < n; ++k) {
          ASSERT_NEAR(points(column::position)[k], k * s, 1e-14) << way << ' ' << step;
          ASSERT_NEAR(points(column::position, 1)[k], 0.411 + (k % 2 ? -d : d), 1e-14) << way << ' ' << step;
        }
        EXPECT_NEAR(points(column::position)[0], 0, 1e-16);
        EXPECT_NEAR(points(column::position)[n - 1], 0.8, 1e-16);
      }
      EXPECT_LT(d, 0.36 * start);
    }
  }
}

// A straight chain under an even tension stays: nothing is at rest but it.
TEST(Relaxed, AnEvenChainStays) {
  for (const Way& way : ways) {
    std::vector<Place> places;
    for (int k = 0; k < 33; ++k) places.push_back({0.025 * k, 0.411, 0});
    Body body = scenes::skin_body(Skin::segments, Space::plane, places, 0.02 * 0.025);
    for (int k = 0; k < 33; ++k) body.points(column::rest_length)[k] /= 1.3;
    for (const int end : {0, 32}) body.points(column::mass)[end] = body.points(column::volume)[end] = 0.01 * 0.025;
    Scene scene = scenes::scene_of(scenes::plane(8, 8, 0.1, scenes::walls(Wall::symmetry, Wall::symmetry)),
                                   {std::move(body)}, way.shape, way.transfer);
    scene.chain_relaxation = 1;
    Simulation run(scene, way.integrator, {0.3, 1e-3});
    for (int k = 0; k < 10; ++k) run.step(1);
    for (int k = 0; k < 33; ++k) {
      EXPECT_NEAR(run.scene().bodies[0].points(column::position)[k], 0.025 * k, rounding);
      EXPECT_NEAR(run.scene().bodies[0].points(column::position, 1)[k], 0.411, rounding);
    }
  }
}

// The end points of a crooked chain between walls stay on them: along a mirror they may glide, on a no-slip wall not.
TEST(Relaxed, PointsOnWallsStayOnThem) {
  for (const Way& way : ways) {
    for (const Wall kind : {Wall::symmetry, Wall::no_slip}) {
      std::vector<Place> places;
      for (int k = 0; k <= 20; ++k) places.push_back({0.04 * k, 0.3 + 0.1 * std::sin(1.7 * k), 0});
      Body body = scenes::skin_body(Skin::segments, Space::plane, places, 0.02 * 0.04);
      for (int k = 0; k <= 20; ++k) body.points(column::rest_length)[k] *= 0.8;
      const Scene scene = scenes::scene_of(scenes::plane(8, 8, 0.1, scenes::walls(kind, kind)), {std::move(body)},
                                           way.shape, way.transfer);
      const auto [off, on, ledger_off, ledger_on] = one_step(scene, way, 1e-3,
                                                             [](Scene& s) { s.chain_relaxation = 1; });
      for (const int end : {0, 20}) {
        const Columns &alone = off.bodies[0].points, &relaxed = on.bodies[0].points;
        EXPECT_EQ(relaxed(column::position)[end], alone(column::position)[end]) << way;
        EXPECT_EQ(relaxed(column::position, 1)[end] == alone(column::position, 1)[end], kind == Wall::no_slip) << way;
      }
      EXPECT_LT(energy_as_it_stands(on.bodies[0]), energy_as_it_stands(off.bodies[0]));
    }
  }
}

// Boxes under an affine transfer have an inertia that moves with them: that energy would be nobody's.
TEST(Relaxed, BoxesWithAffineVelocitiesRefuse) {
  for (const char* shape : {"gimp", "contiguous-gimp", "linear"}) {
    Scene scene = skin_alone(Skin::segments, Space::plane, {"musl", shape, "apic"});
    EXPECT_NO_THROW(Simulation(scene, "musl", {0.3, 1e-3})) << shape;
    scene.chain_relaxation = 0.5;
    EXPECT_THROW(Simulation(scene, "musl", {0.3, 1e-3}), std::invalid_argument) << shape;
    scene.transfer = "flip";
    EXPECT_NO_THROW(Simulation(scene, "musl", {0.3, 1e-3})) << shape;
  }
}

// Bodies that are no chains of forces do not know of it.
TEST(Relaxed, OthersStayAsTheyAre) {
  const Way way = ways[0];
  for (const scenes::Law law : {scenes::Law::hooke, scenes::Law::neo_hookean}) {
    const Scene gas = scenes::rough_gas_in_space(Space::plane, way.shape, way.transfer, scenes::no_gravity);
    const auto [off, on, ledger_off, ledger_on] = one_step(scenes::rough_solid(law, gas), way, 1e-3, [](Scene& s) {
      s.chain_relaxation = 1;
      s.strain_smoothing = 1;
    });
    EXPECT_TRUE(scenes::same_bits(off.bodies[0], on.bodies[0])) << law;
  }
  const auto [off, on, ledger_off, ledger_on] = one_step(skin_alone(Skin::uniaxial, Space::plane, way), way, 1e-3,
                                                         [](Scene& s) { s.chain_relaxation = 1; });
  EXPECT_TRUE(scenes::same_bits(off.bodies[0], on.bodies[0]));
  const auto [off2, on2, ledger_off2, ledger_on2] = one_step(skin_alone(Skin::segments, Space::plane, way), way, 1e-3,
                                                             [](Scene& s) { s.strain_smoothing = 1; });
  EXPECT_TRUE(scenes::same_bits(off2.bodies[0], on2.bodies[0]));
}

// --- carried strain -------------------------------------------------------------------------------------------------

class Smoothing : public testing::TestWithParam<Space> {};
INSTANTIATE_TEST_SUITE_P(Spaces, Smoothing, testing::Values(Space::line, Space::plane),
                         testing::PrintToStringParamName());

// Each point's strain goes by the share min(1, kappa dt c/h) of the way to what nodes see of all, c the fastest speed
// of waves and points. The mean by mass stays; the energy that this stores or releases is booked. [Coupling 3]
TEST_P(Smoothing, GoesTheShareOfTheWay) {
  const int dim = scenes::dim_of(GetParam());
  for (const Way& way : ways) {
    if (std::string(way.integrator) == "usavg") continue;  // strains twice a step
    for (const Skin skin : {Skin::uniaxial, Skin::plane_stress}) {
      for (const double kappa : {0.05, 1.0, 1e6}) {
        SCOPED_TRACE(testing::Message() << way << ' ' << skin << ' ' << kappa);
        const Scene start = skin_alone(skin, GetParam(), way);
        const double dt = 4e-3;
        const auto [off, on, ledger_off, ledger_on] = one_step(start, way, dt,
                                                               [&](Scene& s) { s.strain_smoothing = kappa; });
        const auto located = scenes::places_of(start.bodies[0], dim,
                                               std::string(way.integrator) == "leapfrog" ? dt / 2 : 0);
        const Body &alone = off.bodies[0], &smooth = on.bodies[0];
        const auto mass = scenes::by_id(alone, column::mass), own = scenes::by_id(alone, column::strain),
                   now = scenes::by_id(smooth, column::strain);
        const auto seen = scenes::seen_by_nodes(way.shape, start.grid, located, mass, own);
        const double c = alone.material->step_bounds(alone.points, all_points(alone.points), dim).fastest;
        const double share = std::min(1.0, kappa * dt * c / start.grid.h);
        double mean = 0, moved = 0;
        for (std::size_t p = 0; p < own.size(); ++p) {
          EXPECT_NEAR(now[p], own[p] + share * (seen[p] - own[p]), rounding) << p;
          mean += mass[p] * (now[p] - own[p]);
          moved = std::max(moved, std::abs(now[p] - own[p]));
        }
        EXPECT_NEAR(mean, 0, 1e-16);
        EXPECT_GT(moved, 1e-5);
        const double stored = smooth.material->stored_energy(smooth.points, all_points(smooth.points)) -
                              alone.material->stored_energy(alone.points, all_points(alone.points));
        EXPECT_NEAR(ledger_on.energy.flow(Flow::constitutive) - ledger_off.energy.flow(Flow::constitutive), stored,
                    1e-13 * ledger_on.energy.scale());
        EXPECT_GT(std::abs(stored), 1e-8 * ledger_on.energy.scale());
        scenes::expect_ledger_closes(ledger_on, 1e-12);
      }
    }
  }
}

// An even strain has nothing that nodes do not see, at a wall neither. Slack, the chain has no reason to move.
TEST_P(Smoothing, LeavesEvenStrainsAlone) {
  for (const bool walled : {false, true}) {
    Scene start = scenes::gas_and_skin(Skin::uniaxial, GetParam(), ways[0].shape, ways[0].transfer, walled, -0.1);
    start.bodies.erase(start.bodies.begin());
    Columns& points = start.bodies[0].points;
    for (int p = 0; p < points.points(); ++p) {
      points(column::strain)[p] = -0.07;
      for (int d = 0; d < start.grid.dim; ++d) points(column::velocity, d)[p] = walled ? 0 : 0.2;
    }
    const auto [off, on, ledger_off, ledger_on] = one_step(start, ways[0], 1e-3,
                                                           [](Scene& s) { s.strain_smoothing = 1e6; });
    for (const double strain : scenes::by_id(on.bodies[0], column::strain)) EXPECT_NEAR(strain, -0.07, rounding);
  }
}

}  // namespace
}  // namespace plumbline::relaxation_test
