// Bodies that meet, step by step: ledger, energy, and what contact must not touch.
#include <algorithm>
#include <cmath>

#include "kernel/contact/pair_potential.hpp"
#include "kernel/transfers/transfer.hpp"
#include "tests/kernel/contact/two_clouds.hpp"

namespace plumbline::collision_test {
namespace {

using meetings::block;
using meetings::elastic_body;
using scenes::Combination;
using scenes::Place;

// Two blocks a little more than a point apart, off centre, that meet; h = 0.1, two points a cell.
Scene blocks(int dim, const std::string& shape, const std::string& transfer, const std::string& contact,
             double apart = 0.02, double speed = 1) {
  const double s = 0.05;
  const std::array<int, 3> count{8, dim > 1 ? 10 : 1, dim > 2 ? 6 : 1};
  const double y = dim > 1 ? 0.5 : 0, z = dim > 2 ? 0.4 : 0;
  Scene scene;
  scene.grid = scenes::box(scenes::space_of(dim), {20, 16, 12}, 0.1);
  scene.bodies = {elastic_body("a", dim, block({0.4, y, z}, count, s), s, {speed, 0.1, 0}),
                  elastic_body("b", dim, block({0.8 + apart, y + (dim > 1 ? 0.1 : 0), z}, count, s), s)};
  scene.shape = shape;
  scene.transfer = transfer;
  scene.contact = contact;
  return scene;
}

// Every transfer under the steps with one, two and no further maps, each contact: all of it is booked. Linear shapes
// have light nodes that fly fast, whose squares round more coarsely; XPIC and FMPM, which take differences of them, go
// without, and so do blends, of which a point flies off by the midpoint step with York's contacts.
TEST(Collision, LedgerClosesWithContact) {
  for (const char* contact : {"york-9.7", "york-9.9", "touching", "pairs"}) {
    for (const Choice& transfer : transfers()) {
      if (scenes::of_a_test(transfer.name)) continue;
      for (const char* integrator : {"musl", "usl", "usf", "midpoint"}) {
        for (const char* shape : {"linear", "quadratic", "contiguous-gimp"}) {
          const std::string light = "linear";
          const bool without = transfer.name == "xpic" || transfer.name == "fmpm" || transfer.name == "blend";
          if (shape == light && without) continue;
          const Combination combination{integrator, shape, transfer.name};
          SCOPED_TRACE(testing::Message() << contact << ' ' << combination);
          Simulation simulation(blocks(2, shape, transfer.name, contact), integrator, {.dt = 1e-3});
          for (int step = 0; step < 60; ++step) simulation.step(1e-3);
          scenes::expect_ledger_closes(simulation.ledger(), shape == light ? 1e-12 : 1e-13);
          double fastest = 0;
          for (double v : scenes::by_id(simulation.scene().bodies[1], column::velocity)) fastest = std::max(fastest, v);
          // Under usf points strain before contact is found: what FLIP carries in common never presses.
          const bool presses = transfer.name != "flip" || std::string(integrator) != "usf";
          EXPECT_GT(fastest, presses ? 1e-2 : -1) << "they met";
          EXPECT_LE(std::abs(simulation.ledger().momentum[0].flow(Flow::contact)), 1e-13);
          EXPECT_LE(std::abs(simulation.ledger().angular_momentum[2].flow(Flow::contact)), 1e-13);
        }
      }
    }
  }
}

// Touching points count at all nodes that their shape might reach, six in a row of domains, also at those which their body has
// left: the masses there are of earlier steps.
TEST(Collision, NodesThatABodyHasLeftTakeNothing) {
  for (const double friction : {0.0, 0.3}) {
    Scene scene = blocks(2, "cpdi", "apic", "touching", -0.01, 0.5);
    scene.friction = friction;
    for (Body& body : scene.bodies) std::fill_n(body.points(column::velocity, 1), body.points.points(), 2.0);
    Simulation simulation(scene, "midpoint", {.dt = 1e-3});
    for (int step = 0; step < 100; ++step) simulation.step(1e-3);
    scenes::expect_ledger_closes(simulation.ledger(), 1e-13);
  }
}

// A wall takes its part of a contact beside it, also where it mirrors kernels.
TEST(Collision, LedgerClosesBesideWalls) {
  for (Wall wall : {Wall::symmetry, Wall::no_slip}) {
    for (const char* contact : {"york-9.7", "touching", "pairs"}) {
      for (const char* transfer : {"apic", "flip"}) {
        Scene scene = blocks(2, "quadratic", transfer, contact);
        scene.grid.origin[1] = 0.5;
        scene.grid.walls[1] = {wall, Wall::free};
        Simulation simulation(scene, "midpoint", {.dt = 1e-3});
        for (int step = 0; step < 60; ++step) simulation.step(1e-3);
        SCOPED_TRACE(testing::Message() << contact << ' ' << transfer << ' ' << static_cast<int>(wall));
        scenes::expect_ledger_closes(simulation.ledger(), 1e-12);
      }
    }
  }
}

void expect_pairs_close_the_ledger(const char* shape, const char* transfer, const char* integrator) {
  const Combination combination{integrator, shape, transfer};
  SCOPED_TRACE(testing::Message() << combination);
  Simulation simulation(blocks(2, shape, transfer, "pairs"), integrator, {.dt = 1e-3});
  for (int step = 0; step < 100; ++step) simulation.step(1e-3);
  scenes::expect_ledger_closes(simulation.ledger(), 1e-13);
  EXPECT_GT(scenes::by_id(simulation.scene().bodies[1], column::velocity)[0], 1e-2) << "they met";
}

// Steps that predict stresses with the velocities of their start, and move points by their own.
TEST(Collision, LedgerOfPairsClosesByStepsThatDrift) {
  for (const char* integrator : {"leapfrog", "energy"}) expect_pairs_close_the_ledger("quadratic", "apic", integrator);
}

// Nodes where bodies were at the start meet nobody; points do.
TEST(Collision, LedgerOfPairsClosesWithWeightsOfTheStart) {
  for (const char* transfer : {"apic", "flip"})
    expect_pairs_close_the_ledger("lagrangian-quadratic", transfer, "midpoint");
}

TEST(Collision, BodiesThatNeverMeetAreLeftBitForBit) {
  for (const char* transfer : {"apic", "flip"}) {
    const auto run = [&](const char* contact) {
      Simulation simulation(blocks(2, "quadratic", transfer, contact, 0.4, 0.5), "midpoint", {.dt = 2e-3});
      for (int step = 0; step < 50; ++step) simulation.step(2e-3);
      return simulation.save();
    };
    const Checkpoint alone = run("none");
    for (const char* contact : {"york-9.7", "york-9.8", "york-9.9", "touching", "pairs"}) {
      const Checkpoint with = run(contact);
      for (std::size_t b = 0; b < 2; ++b) {
        for (const ColumnId* id : {&column::position, &column::velocity, &column::stress}) {
          const auto left = alone.points[b].values(*id), right = with.points[b].values(*id);
          EXPECT_TRUE(std::equal(left.begin(), left.end(), right.begin(), right.end())) << contact << ' ' << id->name();
        }
      }
    }
  }
}

TEST(Collision, NoResultDependsOnThreads) {
  const double s = 0.02;
  for (const char* contact : {"touching", "pairs"}) {
    Scene scene = blocks(2, "quadratic", "apic", contact);
    scene.grid.h = 0.04;
    scene.grid.cells = {40, 40, 1};
    scene.bodies = {elastic_body("a", 2, block({0.2, 0.2, 0}, {30, 50, 1}, s), s, {1, 0, 0}),
                    elastic_body("b", 2, block({0.81, 0.25, 0}, {30, 50, 1}, s), s)};
    meetings::expect_threads_do_not_matter(scene);
  }
}

// No step of linear elasticity raises the energy, contact included; the bodies part. The step is below the bound of the
// quadratic shapes, C <= 2/sqrt(6 (1 + nu)). [Midpoint 4] [Touching 3] [Pairs 3]
TEST(Collision, MidpointNeverRaisesTheEnergy) {
  for (const char* contact : {"touching", "pairs"}) {
    for (int dim : {1, 2, 3}) {
      for (const char* transfer : {"apic", "pic"}) {
        Simulation simulation(blocks(dim, "quadratic", transfer, contact), "midpoint", {0.5, {}});
        const double start = simulation.ledger().initial_stores.total() + contact_energy(simulation.scene());
        double last = start, rise = 0;
        const double end = dim == 3 ? 0.12 : 0.2;
        simulation.run_until(end, [&](const Simulation& now) {
          const double energy = now.ledger().stores.total() + contact_energy(now.scene());
          rise = std::max(rise, energy - last);
          last = energy;
        });
        EXPECT_LE(rise, 1e-13 * start) << contact << ' ' << dim << ' ' << transfer;
        EXPECT_LT(last, start);
        const auto& bodies = simulation.scene().bodies;
        if (dim == 3) continue;
        EXPECT_GT(scenes::by_id(bodies[1], column::position)[0] - scenes::by_id(bodies[0], column::position)[7], 0.06);
      }
    }
  }
}

// Two rods of one length: the face presses with rho c v/2 for 2L/c, and then all motion has gone over.
// gap: between the ends before they meet, m; late: how much later the press begins, s.
void expect_velocities_go_over(const std::string& contact, double gap, double late) {
  const double h = 0.01, s = h / 2, c = 10, v = 0.1;  // E = 100, rho = 1
  Scene scene;
  scene.grid = scenes::line(200, h);
  scene.bodies = {elastic_body("a", 1, block({0.5, 0, 0}, {80, 1, 1}, s), s, {v, 0, 0}),
                  elastic_body("b", 1, block({0.9 + gap + 1e-4, 0, 0}, {80, 1, 1}, s), s)};
  scene.contact = contact;
  Simulation simulation(scene, "midpoint", {0.5, {}});
  const auto momentum = [&](std::size_t b) {
    double sum = 0;
    for (double u : scenes::by_id(simulation.scene().bodies[b], column::velocity)) sum += s * u;
    return sum;
  };
  const double meet = 1e-4 / v;
  simulation.run_until(meet + 0.4 / c);
  EXPECT_NEAR(momentum(1), 0.5 * c * v * 0.4 / c, 0.5 * c * v * (late + 2 * 0.5 * h / c));  // and within two steps
  simulation.run_until(meet + 3 * 0.8 / c);
  EXPECT_NEAR(momentum(0) + momentum(1), 0.4 * v, 1e-14);
  EXPECT_GT(momentum(1) - momentum(0), 0.9 * 0.4 * v);
  EXPECT_LE(momentum(1) - momentum(0), 0.4 * v);
}

// Pairs meet earlier by 1.5 spacings s, and give way by d until they press as rods of the impedance rho c do, K d^3/s^2 = rho c v/2
// with K = M/(4 s), which takes the time d/v: of dd/dt = v (1 - (d'/d)^3) on the way there, the integral of 1 - (d'/d)^3.
TEST(Collision, RodsExchangeTheirVelocities) {
  const double s = 0.005, c = 10, v = 0.1;
  expect_velocities_go_over("touching", 0, 0);
  expect_velocities_go_over("pairs", 1.5 * s, s * std::cbrt(2 * v / c) / v);
}

}  // namespace
}  // namespace plumbline::collision_test
