// Planes that move through the grid and drive the nodes behind them.
#include "kernel/pistons.hpp"

#include "kernel/rotations.hpp"
#include "tests/kernel/scenes.hpp"

namespace plumbline::pistons_test {
namespace {

using scenes::Space;

// Nodes behind the plane, or less than half a cell before it, take its normal velocity; impulse, torque and work are those of
// the masses moved. Ghosts of walls are left to their mirrors.
template <int dim>
void expect_driven(int side, double time, double rise) {
  using Vec = Eigen::Matrix<double, dim, 1>;
  const int along = dim - 1;
  GridSpec spec = scenes::box(scenes::space_of(dim), {5, 6, 7}, 0.5);
  if (dim > 1) spec.walls[0][0] = Wall::symmetry;
  const Grid<dim> grid(spec);
  VelocityField<dim> field(grid);
  for (auto& row : field.touched) row = {0, grid.row_length()};
  scenes::Random random(8);
  std::vector<Vec> before(field.mass.size());
  for (std::size_t i = 0; i < before.size(); ++i) {
    field.mass[i] = random(0.1, 1);
    for (int d = 0; d < dim; ++d) before[i][d] = random(-1, 1);
  }
  Scene scene;
  scene.pistons = {{along, side, 1.1, 0.4, rise}};
  Pistons<dim> pistons(scene);
  pistons.set_time(time / 2);
  pistons.advance(time / 2);
  std::vector<Vec> after = before, midpoint = before;
  WallAction<dim> action;
  const double dt = 0.3, work = pistons.drive(grid, field, after, action, dt);
  pistons.drive_midpoint(grid, field, midpoint, dt);
  // Half of the ramp's triangle, then the rest at full speed.
  const auto place = [&](double t) { return 1.1 + 0.4 * (t < rise ? 0.5 * t * t / rise : t - 0.5 * rise); };
  const auto speed = [&](double t) { return t < rise ? 0.4 * t / rise : 0.4; };
  const double plane = place(time), now = speed(time), then = speed(time + dt);
  Vec impulse = Vec::Zero();
  Spin<dim> turn = Spin<dim>::Zero();
  int driven = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const Vec x = grid.position(static_cast<int>(i));
    const bool ghost = dim > 1 && x[0] < -0.25;
    const bool behind = side == 0 ? x[along] < plane + 0.25 : x[along] > plane - 0.25;
    Vec expected = before[i];
    if (behind && !ghost) expected[along] = then;
    EXPECT_LE((after[i] - expected).norm(), 1e-15);
    if (behind && !ghost) expected[along] = (now + then) / 2;
    EXPECT_LE((midpoint[i] - expected).norm(), 1e-15);
    const Vec change = field.mass[i] * (after[i] - before[i]);
    impulse += change;
    turn += cross<dim>(x, change);
    driven += behind && !ghost;
  }
  EXPECT_GT(driven, 0);
  EXPECT_LE((action.linear - impulse).norm(), 1e-13);
  for (int k = 0; k < rotation_count<dim>; ++k) EXPECT_NEAR(action.angular[k], turn[k], 1e-12);
  EXPECT_NEAR(work, (now + then) / 2 * impulse[along], 1e-13);
}
TEST(Pistons, DriveTheNodesBehindThem) {
  for (int side : {0, 1}) {
    for (double time : {0.0, 0.7, 2.0}) {
      for (double rise : {0.0, 0.8, 5.0}) {
        expect_driven<1>(side, time, rise);
        expect_driven<2>(side, time, rise);
        expect_driven<3>(side, time, rise);
      }
    }
  }
}

// A gas and a piston in it, in every geometry, with mirrors beside: momenta and energy close with the piston's part booked.
TEST(Pistons, TheirWorkIsBooked) {
  for (Space space : scenes::spaces) {
    for (const scenes::Combination& c : {scenes::Combination{"leapfrog", "cubic", "apic"},
                                         {"energy", "quadratic", "pic"},
                                         {"musl", "linear", "apic"}}) {
      for (const double rise : {0.0, 0.05}) {
        SCOPED_TRACE(testing::Message() << space << ", " << c << ", rise " << rise);
        Scene scene = scenes::rough_gas(space, c.shape, c.transfer);
        const int along = space == Space::axisymmetric ? 1 : 0;
        for (auto& sides : scene.grid.walls) sides = {Wall::symmetry, Wall::symmetry};
        scene.grid.walls[static_cast<std::size_t>(along)] = {Wall::free, Wall::free};
        scene.grid.cells[static_cast<std::size_t>(along)] += 3;
        scene.pistons = {{along, 0, 0.12, 0.5, rise}};
        scene.sharpening = c.shape == "linear" ? 0 : 1;
        Simulation run(scene, c.integrator, {0.2, {}});
        for (int k = 0; k < 5; ++k) {
          run.step(1);
          scenes::expect_ledger_closes(run.ledger(), 1e-12);
        }
        const Account& energy = run.ledger().energy;
        EXPECT_GT(std::abs(energy.flow(Flow::walls)), 1e-4 * energy.scale());
      }
    }
  }
}

// Gas between two pistons that move with it is a gas at rest seen from elsewhere: velocities, and what each piston does against
// the pressure balances over the first step.
TEST(Pistons, AMovingBoxIsAtRest) {
  const GridSpec grid = scenes::line(30, 0.1);
  const auto places = scenes::lattice(grid, 2, {5, 0, 0}, {15, 1, 1});
  Scene scene = scenes::scene_of(grid,
                                 {scenes::gas_body({}, 1, places, 0.05,
                                                   [](auto&) {
                                                     return scenes::GasState{1, 2.5, {0.4, 0, 0}};
                                                   })},
                                 "quadratic", "apic");
  scene.pistons = {{0, 0, 0.5, 0.4}, {0, 1, 1.5, 0.4}};
  Simulation run(scene, "leapfrog", {0.3, 0.01});
  const double mass = run.ledger().mass.initial();
  for (int k = 0; k < 20; ++k) run.step(1);
  const double speed = run.ledger().momentum[0].store() / mass;
  EXPECT_NEAR(speed, 0.4, 1e-2);
  EXPECT_NEAR(run.ledger().energy.flow(Flow::walls), 0.4 * run.ledger().momentum[0].flow(Flow::walls), 1e-13);
  scenes::expect_ledger_closes(run.ledger(), 1e-12);
}

}  // namespace
}  // namespace plumbline::pistons_test
