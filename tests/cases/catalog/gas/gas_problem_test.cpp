// The problem behind the gas cases: grid, margins, pistons, frames, and what is measured where.
#include "cases/catalog/gas/gas_problem.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "cases/catalog/gas/shock_tube.hpp"
#include "cases/harness/files/errors.hpp"

namespace plumbline::gas_problem_test {
namespace {

Settings settings(const std::vector<std::string>& typed = {}) {
  return find_case("sod").settings("default", {{"cells", 20.0}}, typed);
}

const ShockTube sod{{{1, 0, 1}, {0.125, 0, 0.1}, 1.4}, 0, 1, 0.5, 0.143};  // [York 4.1]

std::pair<std::vector<Measure>, Profile> run(const GasFlow& flow, const Settings& with) {
  GasProblem problem(flow, with);
  StepControl control;
  control.cfl = 0.3;
  Simulation simulation(problem.scene(), "energy", control);
  simulation.run_until(problem.end_time());
  simulation.refresh_density();
  return {problem.measures(simulation), problem.profile(simulation)};
}

double error(const std::vector<Measure>& measures, const std::string& name) {
  for (const Measure& m : measures) {
    if (m.name == name) return m.error;
  }
  return std::nan("");
}

// Extruded points: each line of the plane and of the solid is the run on a line, where nothing corrects sums over points.
TEST(GasProblem, APlaneAndASolidTubeAreTheTube) {
  const Settings with = settings({"quadrature=0"});
  const auto [line, line_profile] = run(tube_flow(sod), with);
  for (int dim : {2, 3}) {
    GasFlow flow = tube_flow(sod);
    flow.dim = dim;
    flow.high[1] = flow.high[2] = 0.1;
    const auto [measures, profile] = run(flow, with);
    for (const char* name : {"density.L1", "velocity.L1", "pressure.L1", "energy.L1"})
      EXPECT_NEAR(error(measures, name), error(line, name), 1e-10) << name << dim;
    const auto &x = profile.find("x")->values, &on_line = line_profile.find("x")->values;
    for (std::size_t p = 0; p < x.size(); ++p) EXPECT_NEAR(x[p], on_line[p % on_line.size()], 1e-10);
  }
}

TEST(GasProblem, MarginsAreWholeCellsOfGasThatIsNotJudged) {
  ShockTube tube = sod;
  tube.states.left.velocity = 0.75;
  const GasFlow flow = tube_flow(tube);
  // |u| + c over the time, and a tenth of the tube.
  EXPECT_NEAR(flow.margin[0], (0.75 + std::sqrt(1.4)) * 0.143 + 0.1, 1e-14);
  EXPECT_EQ(flow.margin[1], 0);
  const GasProblem problem(flow, settings());
  const GridSpec grid = problem.scene().grid;
  EXPECT_NEAR(grid.origin[0], -0.4, 1e-14);  // 0.376 in cells of 0.05
  EXPECT_EQ(grid.cells[0], 28);
  // The part beyond the tube is undisturbed gas; judged or not it has no error, but it thins the mean.
  const auto [measures, profile] = run(flow, settings());
  double judged = 0, all = 0, off = 0;
  for (std::size_t p = 0; p < profile.find("x")->values.size(); ++p) {
    const double volume = profile.find("volume")->values[p];
    all += volume;
    if (profile.find("x")->values[p] < 0 || profile.find("x")->values[p] > 1) continue;
    judged += volume;
    off += volume * std::abs(profile.find("density")->values[p] - profile.find("density_reference")->values[p]);
  }
  EXPECT_NEAR(error(measures, "density.L1"), off / judged, 1e-14);
  EXPECT_GT(all, judged + 0.3);
  EXPECT_NEAR(error(measures, "coverage"), 0, 0.01);
}

// The wave that a wall sends into a stream stays within what is said to be disturbed, towards it and away from it.
TEST(GasProblem, WallsDoNotReachFurtherThanSaid) {
  for (const double u : {-3.0, -0.5, 0.5, 2.0}) {
    const reference::GasState stream{1, u, 1};
    const double c = std::sqrt(1.4), reach = disturbed_by_wall(stream, 1.4, 1);
    // Gas that runs into the wall is met by a shock as of a piston at |u|, seen from the wall; gas that leaves it by a
    // rarefaction whose head runs at u + c.
    const double k = 2.4 / 4 * std::abs(u);
    const double front = u < 0 ? k + std::sqrt(k * k + c * c) - std::abs(u) : u + c;
    EXPECT_GE(reach, front - 1e-14) << u;
  }
  EXPECT_EQ(disturbed_by_wall({1, 0, 1}, 1.4, 1), 0);
}

TEST(GasProblem, PistonsMoveWithTheFrameAndTheGridHoldsTheJourney) {
  GasFlow flow = tube_flow(sod);
  flow.frame_velocity = 10;
  flow.pistons = {0.0, 0.5};
  flow.space = {0.1, 0.2};
  const Scene scene = GasProblem(flow, settings()).scene();
  ASSERT_EQ(scene.pistons.size(), 2u);
  EXPECT_EQ(scene.pistons[0].velocity, 10);
  EXPECT_EQ(scene.pistons[1].velocity, 10.5);
  EXPECT_EQ(scene.pistons[0].side, 0);
  EXPECT_EQ(scene.pistons[1].side, 1);
  EXPECT_NEAR(scene.pistons[0].position, 0, 1e-14);
  EXPECT_NEAR(scene.pistons[1].position, 1, 1e-14);
  EXPECT_NEAR(scene.grid.origin[0], -0.1, 1e-14);
  EXPECT_GE(scene.grid.origin[0] + scene.grid.h * scene.grid.cells[0], 1 + 1.43 + 0.2);
  EXPECT_EQ(scene.bodies[0].points(column::velocity)[0], 10);
}

// Seen from a frame that moves, the reference and the measures are those at rest.
TEST(GasProblem, AMovingFrameIsJudgedInItsOwn) {
  GasFlow flow = tube_flow(sod);
  flow.initial = [](double) { return reference::GasState{1, 0.25, 1}; };
  flow.exact = [](double, double) { return reference::Sample{1, 0.25, 1, 2.5}; };
  flow.jumps = {};
  flow.frame_velocity = 10;
  flow.margin = {0.3, 0.3};
  flow.pistons = {0.25, 0.25};
  flow.space = {0.05, 0.05};
  flow.end_time = 0.02;
  const auto [measures, profile] = run(flow, settings());
  for (const char* name : {"density.L1", "velocity.L1", "pressure.L1"}) EXPECT_LT(error(measures, name), 1e-3) << name;
  const auto& x = profile.find("x")->values;
  EXPECT_NEAR(*std::min_element(x.begin(), x.end()), -0.3 + 0.25 * 0.02, 0.05);
}

// The error of a velocity is the length of a vector, not its component along the flow.
TEST(GasProblem, VelocityIsAVector) {
  GasFlow flow = tube_flow(sod);
  flow.dim = 2;
  flow.high[1] = 0.1;
  flow.jumps = {};
  flow.initial = [](double) { return reference::GasState{1, 0.5, 1}; };
  flow.exact = [](double, double) { return reference::Sample{1, 0.5, 1, 2.5}; };
  GasProblem problem(flow, settings());
  StepControl control;
  Simulation simulation(problem.scene(), "energy", control);
  EXPECT_NEAR(error(problem.measures(simulation), "velocity.L1"), 0, 1e-14);
  flow.direction = [](const Position&) { return Position{0, 1, 0}; };
  GasProblem turned(flow, settings());
  EXPECT_NEAR(error(turned.measures(simulation), "velocity.L1"), std::sqrt(2) * 0.5, 1e-14);
  EXPECT_NEAR(turned.profile(simulation).find("velocity")->values[0], 0, 1e-14);
}

TEST(GasProblem, AKnownErrorOfTheReferenceReplacesTheSumOfItsBounds) {
  GasFlow flow = tube_flow(sod);
  flow.end_time = 0.01;
  flow.exact_error = [] { return reference::GasFields{0.1, 0.2, 0.3, 0.4}; };
  for (const Measure& m : run(flow, settings()).first) {
    if (m.name == "density.L1") {
      EXPECT_EQ(m.reference_bound, 0.1);
    }
    if (m.name == "velocity.L1") {
      EXPECT_EQ(m.reference_bound, 0.2);
    }
    if (m.name == "pressure.L1") {
      EXPECT_EQ(m.reference_bound, 0.3);
    }
    if (m.name == "energy.L1") {
      EXPECT_EQ(m.reference_bound, 0.4);
    }
    if (m.name == "density.L2") {
      EXPECT_LT(m.reference_bound, 1e-10);
    }
  }
}

}  // namespace
}  // namespace plumbline::gas_problem_test
