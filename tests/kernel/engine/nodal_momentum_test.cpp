// The momentum equation on the nodes, built without points' stages.
#include "kernel/engine/nodal_momentum.hpp"

#include "tests/kernel/engine/parts.hpp"

namespace plumbline::nodal_momentum_test {
namespace {

using Vec = Eigen::Vector2d;
using Record = StepRecord<2, 1>;

// A field whose touched nodes have masses and momenta of their own, all unlike.
void fill(Located& on) {
  on.field().for_touched(on.space.grid, [&](std::size_t i) {
    const auto k = static_cast<double>(i);
    on.field().mass[i] = 1 + 0.1 * k;
    on.field().momentum[i] = Vec(k, 2 - k);
    on.field().force[i] = Vec(-k, 3 + k);
  });
}

// v_i = P_i / M_i, then v~_i = v_i + dt (f_i + M_i b) / M_i, and the mean of both. [York 3.18-3.20]
TEST(NodalMomentum, AdvancesEveryNodeByItsForce) {
  Located on(points_at({{0.9, 1.1}}, Wall::free));
  on.scene.gravity = {0, -9, 0};
  fill(on);
  NodalMomentum<Plane> momentum(on.space, on.scene, on.at.field_of_body);
  Record step;
  EXPECT_DOUBLE_EQ(momentum.start(on.field(), step), on.sum([&](std::size_t i) { return on.field().mass[i]; }));
  const double dt = 0.25;
  const auto before = on.field().force;
  const AdvanceRecord<2> record = momentum.advance(on.at.fields, {}, dt, true);
  Vec pulled = Vec::Zero();
  double work = 0;
  on.field().for_touched(on.space.grid, [&](std::size_t i) {
    const VelocityField<2>& field = on.field();
    const Vec start = field.momentum[i] / field.mass[i], weight = field.mass[i] * Vec(0, -9);
    const Vec end = start + dt * (before[i] + weight) / field.mass[i];
    EXPECT_LE((field.start[i] - start).norm(), 1e-14);
    EXPECT_LE((field.end[i] - end).norm(), 1e-14 * end.norm());
    EXPECT_LE((field.midpoint[i] - 0.5 * (start + end)).norm(), 1e-14 * end.norm());
    pulled += dt * weight;
    work += dt * weight.dot(0.5 * (start + end));
  });
  EXPECT_NEAR((record.body.linear - pulled).norm(), 0, 1e-13 * pulled.norm());
  EXPECT_NEAR(record.body.work, work, 1e-13 * std::abs(work));
  EXPECT_EQ(record.wall.linear.norm(), 0);
  EXPECT_EQ(record.dt, dt);
}

// Forces of stresses of another instant, and of hoops, are exchanged with nobody: they are recorded over the step.
TEST(NodalMomentum, RecordsWhatForcesGiveBesideTheNodes) {
  Located on(points_at({{0.9, 1.1}}, Wall::free));
  fill(on);
  NodalMomentum<Plane> momentum(on.space, on.scene, on.at.field_of_body);
  Record step;
  momentum.start(on.field(), step);
  MappedForces<2> forces;
  forces.hoop = 3;
  forces.turn[0] = 5;
  const AdvanceRecord<2> record = momentum.advance(on.at.fields, forces, 0.5, true);
  EXPECT_EQ(record.wall.linear[0], 1.5);
  EXPECT_EQ(record.turn[0], 2.5);
}

// A node on a wall loses its momentum across it, which the wall takes. [EC-APIC walls]
TEST(NodalMomentum, WallsTakeWhatTheirNodesMayNotHave) {
  Located on(points_at({{0.1, 1.1}}, Wall::symmetry, "pic"));
  VelocityField<2>& field = on.field();
  field.for_touched(on.space.grid, [&](std::size_t i) {
    const bool inside = on.space.grid.position(static_cast<int>(i))[0] >= 0;
    field.mass[i] = inside ? 2 : 0;
    field.momentum[i] = inside ? Vec(3, 4) : Vec(0, 0);
  });
  NodalMomentum<Plane> momentum(on.space, on.scene, on.at.field_of_body);
  Record step;
  int on_wall = 0;
  momentum.start(field, step);
  field.for_touched(on.space.grid, [&](std::size_t i) {
    const double x = on.space.grid.position(static_cast<int>(i))[0];
    if (x < 0) return;
    EXPECT_DOUBLE_EQ(field.start[i][0], x == 0 ? 0 : 1.5);
    EXPECT_DOUBLE_EQ(field.start[i][1], 2);
    on_wall += x == 0;
  });
  EXPECT_GT(on_wall, 0);
  EXPECT_DOUBLE_EQ(step.map_wall.linear[0], -3 * on_wall);
  EXPECT_EQ(step.map_wall.linear[1], 0);
}

}  // namespace
}  // namespace plumbline::nodal_momentum_test
