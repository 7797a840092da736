// Materials whose points pull at each other: each looks at places and velocities of one instant.
#include <cmath>

#include "kernel/materials/segment_membrane.hpp"
#include "tests/kernel/scenes.hpp"

namespace plumbline::point_forces_test {
namespace {

// Its forces are those of the end of the step, as velocities of the start have it.
class Ahead final : public TimeIntegrator {
  void step(Stages& mpm, double dt) override {
    mpm.locate_points();
    mpm.map_mass_and_momentum();
    mpm.predict_stress(dt, NodalVelocity::start);
    mpm.map_forces();
    mpm.advance_momentum(dt);
    mpm.move_points(dt);
    mpm.strain_points(dt, NodalVelocity::midpoint);
  }
};
PLUMBLINE_INTEGRATOR(Ahead, "test_ahead", "for tests", "-");

// A string of more points than a chunk holds, numbered from its left or its right end.
Scene waving_string(bool from_the_right, const std::string& transfer) {
  constexpr int points = 600;
  constexpr double length = 6, spacing = length / (points - 1);
  auto law = std::make_shared<SegmentMembrane>();
  law->youngs_modulus = 100;
  law->density = law->section = 1;
  law->one_way = false;
  Body body = make_body("string", law, points, 2);
  for (int k = 0; k < points; ++k) {
    const int p = from_the_right ? points - 1 - k : k;
    const double x = 0.5 + k * spacing;
    body.points(column::position, 0)[p] = x;
    body.points(column::position, 1)[p] = 1 + 0.1 * std::sin(2 * x);
    body.points(column::velocity, 0)[p] = 0.5 * std::cos(3 * x);
    body.points(column::velocity, 1)[p] = 0.5 * std::sin(5 * x);
    body.points(column::mass)[p] = body.points(column::volume)[p] = spacing;
    body.points(column::rest_length)[p] = 0.98 * spacing;
  }
  return scenes::scene_of(scenes::plane(28, 8, 0.25), {body}, "quadratic", transfer);
}

// Stresses ahead of the step want the velocities of neighbours, also of those in the next chunk. Sums in another order: 1e-12.
TEST(PointForces, DoNotDependOnWhereAChunkEnds) {
  for (const auto& [integrator, transfer] : {std::pair{"test_ahead", "flip"}, std::pair{"midpoint", "apic"}}) {
    Simulation right(waving_string(true, transfer), integrator, {.dt = 2e-3}),
        left(waving_string(false, transfer), integrator, {.dt = 2e-3});
    for (int k = 0; k < 20; ++k) {
      right.step(1);
      left.step(1);
    }
    for (const ColumnId* id : {&column::position, &column::velocity}) {
      for (int d = 0; d < 2; ++d) {
        auto own = scenes::by_id(right.scene().bodies[0], *id, d),
             other = scenes::by_id(left.scene().bodies[0], *id, d);
        std::reverse(own.begin(), own.end());
        for (std::size_t p = 0; p < own.size(); ++p) ASSERT_NEAR(own[p], other[p], 1e-12) << integrator << ' ' << p;
      }
    }
    EXPECT_LE(left.ledger().energy.relative_drift(false), 1e-12);
  }
}

}  // namespace
}  // namespace plumbline::point_forces_test
