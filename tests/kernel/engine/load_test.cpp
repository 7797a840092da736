// Body::load: body forces that a scene gives its points, each of them its own, at the time of the stresses.
#include <Eigen/Core>

#include "tests/kernel/solids.hpp"

namespace plumbline::load_test {
namespace {

using scenes::Space;

constexpr const char* steps_of_the_kernel[] = {"usf", "usl", "musl", "usavg", "midpoint", "energy", "leapfrog"};

Scene solid(Space space, const std::string& transfer, scenes::Place gravity, bool walled = false) {
  const Scene gas = walled ? scenes::rough_gas(space, "quadratic", transfer, gravity)
                           : scenes::rough_gas_in_space(space, "quadratic", transfer, gravity);
  return scenes::rough_solid(scenes::Law::hooke, gas);
}

// Asked once a force pass: at the start of the step, and where the stress is that of its middle, there. [Midpoint 2]
// [Leapfrog 2]
TEST(Load, IsAskedAtTheTimeOfTheStress) {
  const double dt = 0.01;
  for (const std::string integrator : steps_of_the_kernel) {
    std::vector<double> asked;
    Scene scene = solid(Space::plane, "apic", scenes::no_gravity);
    scene.bodies[0].load = [&](double time, Columns& points, std::span<const int> id) {
      asked.push_back(time);
      EXPECT_EQ(static_cast<int>(id.size()), points.points());
      for (int d = 0; d < 2; ++d) std::fill_n(points(column::body_force, d), points.points(), 0.0);
    };
    Simulation run(std::move(scene), integrator, {0.3, dt});
    EXPECT_TRUE(asked.empty());
    for (int k = 0; k < 3; ++k) run.step(1);
    std::vector<double> expected;
    for (int k = 0; k < 3; ++k) {
      if (integrator != "leapfrog") expected.push_back(k * dt);
      if (integrator == "leapfrog" || integrator == "midpoint") expected.push_back((k + 0.5) * dt);
    }
    ASSERT_EQ(asked.size(), expected.size()) << integrator;
    for (std::size_t k = 0; k < asked.size(); ++k) EXPECT_NEAR(asked[k], expected[k], 1e-16) << integrator;
  }
}

// The same at every point it is gravity: all fields and flows, but for the rounding of sums in another order. Three steps of
// numbers of order one: 1e-13. [York 3.18]
TEST(Load, TheSameEverywhereIsGravity) {
  for (Space space : scenes::spaces) {
    for (const char* transfer : {"pic", "flip", "apic", "xpic", "fmpm"}) {
      for (const std::string integrator : steps_of_the_kernel) {
        for (const bool walled : {false, true}) {
          if (!lacks(*find_integrator(integrator), "quadratic", transfer).empty()) continue;
          SCOPED_TRACE(testing::Message()
                       << space << ", " << transfer << ", " << integrator << (walled ? ", walls" : ""));
          const scenes::Place pull{3, -9, space == Space::solid ? 5.0 : 0.0};
          const int dim = scenes::dim_of(space);
          Scene pulled = solid(space, transfer, pull, walled),
                loaded = solid(space, transfer, scenes::no_gravity, walled);
          loaded.bodies[0].load = [&](double, Columns& points, std::span<const int>) {
            for (int d = 0; d < dim; ++d) std::fill_n(points(column::body_force, d), points.points(), pull[d]);
          };
          Simulation one(pulled, integrator, {0.3, 0.005}), other(loaded, integrator, {0.3, 0.005});
          for (int k = 0; k < 3; ++k) {
            one.step(1);
            other.step(1);
          }
          for (const ColumnId* id : {&column::position, &column::velocity, &column::strain}) {
            for (int d = 0; d < one.scene().bodies[0].points.components(*id); ++d) {
              const auto a = scenes::by_id(one.scene().bodies[0], *id, d),
                         b = scenes::by_id(other.scene().bodies[0], *id, d);
              for (std::size_t p = 0; p < a.size(); ++p) ASSERT_NEAR(a[p], b[p], 1e-13) << id->name();
            }
          }
          for (Flow flow : {Flow::body_force, Flow::walls}) {
            EXPECT_NEAR(one.ledger().energy.flow(flow), other.ledger().energy.flow(flow), 1e-13);
            for (std::size_t d = 0; d < 3; ++d) {
              EXPECT_NEAR(one.ledger().momentum[d].flow(flow), other.ledger().momentum[d].flow(flow), 1e-13);
              EXPECT_NEAR(one.ledger().angular_momentum[d].flow(flow), other.ledger().angular_momentum[d].flow(flow),
                          1e-13);
            }
          }
        }
      }
    }
  }
}

// A load that differs from point to point and in time, known by the points' numbers however they are sorted: its impulse is
// dt sum_p m_p b_p, and every account closes. [York 3.18]
TEST(Load, ItsImpulseAndWorkAreBooked) {
  const double dt = 0.01;
  for (Space space : scenes::spaces) {
    for (const char* transfer : {"flip", "apic", "xpic"}) {
      for (const std::string integrator : {"usl", "musl", "midpoint"}) {
        for (const bool walled : {false, true}) {
          SCOPED_TRACE(testing::Message() << space << ", " << transfer << ", " << integrator);
          const int dim = scenes::dim_of(space);
          Scene scene = solid(space, transfer, {1, 0}, walled);
          const auto force = [](double time, int id, int d) { return std::sin(3.0 * id + d) * std::cos(40 * time); };
          scene.bodies[0].load = [&](double time, Columns& points, std::span<const int> id) {
            for (int d = 0; d < dim; ++d) {
              for (int p = 0; p < points.points(); ++p) {
                points(column::body_force, d)[p] = force(time, id[static_cast<std::size_t>(p)], d);
              }
            }
          };
          const auto mass = scenes::by_id(scene.bodies[0], column::mass);
          Simulation run(scene, integrator, {0.3, dt});
          double impulse[3] = {0, 0, 0}, scale = 0;
          for (int k = 0; k < 5; ++k) {
            const double time = run.time() + (integrator == "midpoint" ? dt / 2 : 0);
            run.step(1);
            for (int d = 0; d < dim; ++d) {
              for (std::size_t p = 0; p < mass.size(); ++p) {
                impulse[d] += dt * mass[p] * (force(time, static_cast<int>(p), d) + (d == 0 ? 1 : 0));
                scale += dt * mass[p];
              }
            }
          }
          for (int d = 0; d < dim; ++d) {
            EXPECT_NEAR(run.ledger().momentum[static_cast<std::size_t>(d)].flow(Flow::body_force), impulse[d],
                        1e-14 * scale);
          }
          EXPECT_NE(run.ledger().energy.flow(Flow::body_force), 0);
          scenes::expect_ledger_closes(run.ledger(), 1e-13);
        }
      }
    }
  }
}

// Bodies without a load carry no column for it.
TEST(Load, CostsNothingWhereThereIsNone) {
  Scene scene = solid(Space::plane, "apic", {0, -1});
  Simulation run(scene, "midpoint", {});
  run.step(1);
  EXPECT_FALSE(run.scene().bodies[0].points.has(column::body_force));
}

}  // namespace
}  // namespace plumbline::load_test
