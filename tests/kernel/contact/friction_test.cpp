// Coulomb friction where points touch: stick, slip, what it takes and what is booked of it. [Touching 4]
#include <array>
#include <cmath>
#include <map>
#include <stdexcept>

#include "kernel/contact/pair_potential.hpp"
#include "kernel/transfers/transfer.hpp"
#include "tests/kernel/contact/two_clouds.hpp"

namespace plumbline::friction_test {
namespace {

using meetings::block;
using meetings::elastic_body;
using meetings::Meeting;
using meetings::node_of;
using Vec = Eigen::Vector2d;

constexpr double s = 0.05, h = 0.1;  // spacings of points and of nodes

// A block above another, faces along x, of the nodal masses 1 and 3.
Meeting<2> faces(double friction) {
  Meeting<2> meeting(scenes::plane(20, 20, h), {elastic_body("lower", 2, block({0.5, 0.5, 0}, {10, 10, 1}, s), s),
                                                elastic_body("upper", 2, block({0.5, 0.999, 0}, {10, 10, 1}, s), s)});
  meeting.scene.friction = friction;
  std::fill(meeting.fields[1].mass.begin(), meeting.fields[1].mass.end(), 3.0);
  return meeting;
}

// The lower one moves up at 1 and along at `along`; both bodies' midpoint velocities at a node in the middle of the face.
std::array<Vec, 2> middle_of_faces(double friction, double along) {
  Meeting<2> meeting = faces(friction);
  meeting.move(0, Vec(along, 1));
  meeting.meet("touching");
  const auto i = static_cast<std::size_t>(node_of(meeting.grid, 7, 10));
  return {meeting.fields[0].midpoint[i], meeting.fields[1].midpoint[i]};
}

// By hand: M = 1 and 3 have 3/4 between them, J = 3/4, and mu J = 3/8 ends a slip of up to 1/2. [Touching 4]
TEST(Friction, SticksUpToTheLimitAndSlipsBeyond) {
  for (const double along : {0.4, 0.4999, -0.4999}) {
    const auto [lower, upper] = middle_of_faces(0.5, along);
    EXPECT_NEAR((lower - Vec(along / 4, 0.25)).norm(), 0, 1e-15) << along;
    EXPECT_NEAR((upper - lower).norm(), 0, 1e-15) << along;
  }
  for (const double along : {0.5001, 2.0, -7.0}) {
    const auto [lower, upper] = middle_of_faces(0.5, along);
    const double given = std::copysign(0.375, along);
    EXPECT_NEAR((lower - Vec(along - given, 0.25)).norm(), 0, 2e-15) << along;
    EXPECT_NEAR((upper - Vec(given / 3, 0.25)).norm(), 0, 1e-15) << along;
  }
}

// Along a wall's mirror the pair slips, into it nothing is pushed.
TEST(Friction, NodesOnWallsAreNotPushedIntoThem) {
  for (const double friction : {0.3, 10.0}) {
    Meeting<2> meeting(scenes::plane(20, 20, h, scenes::walls(Wall::free, Wall::free, Wall::symmetry, Wall::free)),
                       {elastic_body("a", 2, block({0.5, 0, 0}, {10, 10, 1}, s), s),
                        elastic_body("b", 2, block({0.98, 0, 0}, {10, 12, 1}, s), s)});
    meeting.scene.friction = friction;
    meeting.move(0, Vec(1, 0.5));
    meeting.meet("touching");
    bool on_wall = false;
    for (const auto& c : meeting.changes) {
      if (meeting.grid.position(c.node)[1] > 0.05) continue;
      on_wall = true;
      EXPECT_EQ(c.end[1], c.own_end[1]);
    }
    EXPECT_TRUE(on_wall);
  }
}

template <int dim>
Meeting<dim> uneven(unsigned long seed, double friction) {
  const std::array<int, 3> count{10, 10, dim == 3 ? 8 : 1};
  const double z = dim == 3 ? 0.3 : 0;
  Meeting<dim> meeting(scenes::box(scenes::space_of(dim), {20, 20, 12}, h),
                       {elastic_body("a", dim, scenes::jittered(block({0.5, 0.5, z}, count, s), 0.01, dim, seed), s),
                        elastic_body("b", dim, scenes::jittered(block({0.98, 0.6, z}, count, s), 0.01, dim, 7), s)});
  meeting.scene.friction = friction;
  meeting.randomise(seed);
  return meeting;
}

// What touches is what touches without friction, and pushes as hard; the impulse along the tangent ends the slip, or it is
// mu J against what is left of it, with the push J of the first pass in both. Nothing else changes. [Touching 4]
template <int dim>
void expect_coulomb(double friction, int& stuck, int& slipping) {
  using V = Eigen::Matrix<double, dim, 1>;
  for (unsigned long seed = 1; seed <= 5; ++seed) {
    Meeting<dim> with = uneven<dim>(seed, friction), without = uneven<dim>(seed, 0);
    const auto rough = make_contact<dim>("touching", with.grid, 3),
               smooth = make_contact<dim>("touching", with.grid, 3);
    std::map<int, double> limits;
    for (const bool first : {true, false}) {
      if (!first) {
        with.randomise(seed + 100);
        without.randomise(seed + 100);
      }
      with.meet(*rough, first);
      without.meet(*smooth, first);
      ASSERT_EQ(with.changes.size(), without.changes.size());
      ASSERT_GE(with.changes.size(), 10u);
      for (std::size_t k = 0; k + 1 < with.changes.size(); k += 2) {
        const ContactChange<dim>&a = with.changes[k], &b = with.changes[k + 1], &alone = without.changes[k];
        ASSERT_EQ(a.node, alone.node);
        const V push = -0.5 * alone.mass * (alone.end - alone.own_end);
        if (first) limits[a.node] = friction * push.norm();
        const double limit = limits.at(a.node);
        const V held = -0.5 * a.mass * (a.end - alone.end), slip = 0.5 * (a.start + a.end - b.start - b.end);
        EXPECT_LE(held.norm(), limit + 1e-14);
        EXPECT_NEAR(held.dot(push), 0, 1e-14);
        EXPECT_NEAR(slip.dot(push), 0, 1e-14);
        EXPECT_NEAR((a.mass * (a.end - a.own_end) + b.mass * (b.end - b.own_end)).norm(), 0, 1e-14);
        ++(slip.norm() < 1e-14 ? stuck : slipping);
        if (slip.norm() < 1e-14) continue;
        EXPECT_NEAR(held.norm(), limit, 1e-14);
        EXPECT_NEAR(held.dot(slip), limit * slip.norm(), 1e-14);
      }
    }
  }
}

TEST(Friction, CoulombsLawAtEveryNodeAndPass) {
  int stuck = 0, slipping = 0;
  expect_coulomb<2>(0.6, stuck, slipping);
  expect_coulomb<3>(0.6, stuck, slipping);
  EXPECT_GE(stuck, 50);
  EXPECT_GE(slipping, 50);
}

// Velocities mapped anew rub as far as they approach.
TEST(Friction, RemappedVelocitiesStick) {
  Meeting<2> meeting = faces(100);
  meeting.move(0, Vec(0.4, 1));
  const auto contact = make_contact<2>("touching", meeting.grid, 3);
  meeting.meet(*contact);
  for (auto& field : meeting.fields) field.held(field.remapped) = std::vector<Vec>(field.mass.size(), Vec::Zero());
  const auto i = static_cast<std::size_t>(node_of(meeting.grid, 7, 10));
  meeting.fields[0].remapped[i] = Vec(0.8, 2);
  contact->apply_to_remapped(meeting.fields);
  EXPECT_NEAR((meeting.fields[0].remapped[i] - Vec(0.2, 0.5)).norm(), 0, 1e-15);
  EXPECT_NEAR((meeting.fields[1].remapped[i] - Vec(0.2, 0.5)).norm(), 0, 1e-15);
}

// Three bodies round a corner: momentum is kept, no pair closes, energy is taken; what is rough enough moves as one.
TEST(Friction, ThreeBodiesAtANode) {
  for (const double friction : {0.2, 1e6}) {
    Meeting<2> meeting = meetings::three_round_a_corner(0.98);
    meeting.scene.friction = friction;
    const Vec momentum = meeting.momentum();
    meeting.meet("touching");
    EXPECT_NEAR((meeting.momentum() - momentum).norm(), 0, 1e-12);
    int three = 0;
    for (const int node : meeting.nodes()) {
      std::vector<ContactChange<2>> here;
      for (const auto& c : meeting.changes) {
        if (c.node == node) here.push_back(c);
      }
      double work = 0, scale = 0;
      for (const auto& c : here) {
        const Vec impulse = c.mass * (c.end - c.own_end);
        work += impulse.dot(0.5 * (c.start + c.end));
        scale += impulse.norm();
      }
      EXPECT_LE(work, 1e-13 * scale) << node;
      if (here.size() < 3) continue;
      ++three;
      if (friction < 1) continue;
      const Vec first = here[0].start + here[0].end;
      for (const auto& c : here) EXPECT_NEAR((c.start + c.end - first).norm(), 0, 1e-12) << node;
    }
    EXPECT_GT(three, 0);
  }
}

Scene rubbing(double friction, const std::string& shape, const std::string& transfer,
              const std::string& law = "touching") {
  Scene scene;
  scene.grid = scenes::plane(20, 16, h);
  scene.bodies = {elastic_body("a", 2, block({0.4, 0.5, 0}, {8, 10, 1}, s), s, {1, 1, 0}),
                  elastic_body("b", 2, block({0.81, 0.6, 0}, {8, 10, 1}, s), s)};
  scene.shape = shape;
  scene.transfer = transfer;
  scene.contact = law;
  scene.friction = friction;
  return scene;
}

// Every transfer, one and two passes: what friction takes is booked as the energy of contact, and no momentum goes.
TEST(Friction, LedgerCloses) {
  for (const char* law : {"touching", "pairs"}) {
    for (const Choice& transfer : transfers()) {
      for (const char* integrator : {"musl", "usl", "usf", "midpoint"}) {
        Simulation simulation(rubbing(0.4, "quadratic", transfer.name, law), integrator, {.dt = 1e-3});
        for (int step = 0; step < 60; ++step) simulation.step(1e-3);
        SCOPED_TRACE(testing::Message() << law << ' ' << transfer.name << ' ' << integrator);
        scenes::expect_ledger_closes(simulation.ledger(), 1e-13);
        EXPECT_LE(std::abs(simulation.ledger().momentum[0].flow(Flow::contact)), 1e-13);
        EXPECT_LE(std::abs(simulation.ledger().momentum[1].flow(Flow::contact)), 1e-13);
        EXPECT_LE(std::abs(simulation.ledger().angular_momentum[2].flow(Flow::contact)), 1e-13);
      }
    }
  }
}

// Friction takes energy and carries the second body along; without, contact at nodes takes nothing, and pairs give nothing.
TEST(Friction, CarriesAlong) {
  for (const char* law : {"touching", "pairs"}) {
    const auto run = [law](double friction) {
      Simulation simulation(rubbing(friction, "quadratic", "apic", law), "midpoint", {.dt = 1e-3});
      const double start = simulation.ledger().initial_stores.total(), held = contact_energy(simulation.scene());
      for (int step = 0; step < 60; ++step) simulation.step(1e-3);
      double along = 0;
      for (const double v : scenes::by_id(simulation.scene().bodies[1], column::velocity, 1)) along += v / 80;
      const double left = simulation.ledger().energy.flow(Flow::contact) + contact_energy(simulation.scene()) - held;
      return std::pair(left / start, along);
    };
    const auto [kept, alone] = run(0);
    const auto [taken, along] = run(0.2);
    EXPECT_LE(kept, 1e-15) << law;
    if (std::string(law) == "touching") {
      EXPECT_GE(kept, -1e-15);
    }
    EXPECT_LT(taken, kept - 1e-3) << law;
    EXPECT_GT(along, 3 * std::abs(alone)) << law;
  }
}

// The step and friction alone, without what maps take: steps near the limit and rough bodies, which stick here and slip there.
// With the limit of each pass its own, one of these steps gives energy, 4e-5 of it. [Midpoint 4] [Touching 4]
void expect_no_step_gives_energy(const std::string& law, double courant) {
  for (const double friction : {0.05, 0.3, 1.0, 10.0}) {
    for (unsigned long seed = 1; seed <= 12; ++seed) {
      scenes::Random random(seed);
      const double y = 0.5 + 0.2 * random(-1, 1), along = random(-1, 1);
      Scene scene = rubbing(friction, "quadratic", "apic", law);
      scene.bodies = {
          elastic_body("a", 2, scenes::jittered(block({0.4, 0.5, 0}, {8, 10, 1}, s), 0.005, 2, seed), s, {1, along, 0}),
          elastic_body("b", 2, scenes::jittered(block({0.82, y, 0}, {8, 10, 1}, s), 0.005, 2, seed + 50), s)};
      Simulation simulation(scene, "midpoint", {courant, {}});
      const double held = contact_energy(simulation.scene()), start = simulation.ledger().initial_stores.total() + held;
      double last = held, most = 0;
      simulation.run_until(0.4, [&](const Simulation& now) {
        const Account& energy = now.ledger().energy;
        const double given = energy.flow(Flow::integration) + energy.flow(Flow::constitutive) +
                             energy.flow(Flow::contact) + contact_energy(now.scene());
        most = std::max(most, given - last);
        last = given;
      });
      EXPECT_LE(most, 1e-14 * start) << law << ' ' << friction << ' ' << seed;
      EXPECT_LT(last, held);
    }
  }
}
TEST(Friction, NoStepGivesEnergy) {
  expect_no_step_gives_energy("touching", 0.9);
  expect_no_step_gives_energy("pairs", 0.5);
}

TEST(Friction, NoResultDependsOnThreads) {
  const double fine = 0.02;
  Scene scene = rubbing(0.3, "quadratic", "apic");
  scene.grid = scenes::plane(40, 40, 0.04);
  scene.bodies = {elastic_body("a", 2, block({0.2, 0.2, 0}, {30, 50, 1}, fine), fine, {1, 1, 0}),
                  elastic_body("b", 2, block({0.81, 0.25, 0}, {30, 50, 1}, fine), fine)};
  meetings::expect_threads_do_not_matter(scene);
}

TEST(Friction, WrongCoefficientsAndLawsWithoutItAreRefused) {
  const auto refusal = [](double friction, const std::string& law) -> std::string {
    try {
      Simulation(rubbing(friction, "quadratic", "apic", law), "midpoint", {.dt = 1e-3});
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(refusal(0.5, "touching"), "");
  EXPECT_EQ(refusal(0, "york-9.7"), "");
  EXPECT_EQ(refusal(-0.5, "touching"), "friction = -0.500000: a finite coefficient >= 0 is wanted");
  EXPECT_NE(refusal(NAN, "touching").find("a finite coefficient >= 0"), std::string::npos);
  EXPECT_NE(refusal(INFINITY, "none").find("a finite coefficient >= 0"), std::string::npos);
  EXPECT_EQ(refusal(0.5, "york-9.7"), "friction = 0.500000: the contact law york-9.7 has no friction, it must be 0");
}

}  // namespace
}  // namespace plumbline::friction_test
