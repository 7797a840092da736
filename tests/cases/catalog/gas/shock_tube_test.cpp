// The tube's points and reference: both from one struct, and no mass lost wherever grid and diaphragm stand.
#include "cases/catalog/gas/shock_tube.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "cases/harness/run/experiment.hpp"
#include "reference/riemann.hpp"
#include "tests/cases/catalog/run_by_name.hpp"

namespace plumbline::shock_tube_test {
namespace {

// The case `sod` is the tube with its published states; `typed` changes it.
struct Tube {
  explicit Tube(const std::vector<std::string>& typed, const std::string& scheme = "default")
      : settings(find_case("sod").settings(scheme, {}, typed)),
        problem(find_case("sod").problem(settings)),
        scene(problem->scene()) {}

  const Columns& points() const { return scene.bodies.front().points; }
  double sum(const ColumnId& id) const {
    double total = 0;
    for (const double value : points().values(id)) total += value;
    return total;
  }
  double low() const { return scene.grid.origin[0]; }
  double high() const { return low() + scene.grid.h * scene.grid.cells[0]; }
  double at(const ColumnId& id, int p) const { return points()(id)[p]; }

  Settings settings;
  std::unique_ptr<Problem> problem;
  Scene scene;
};

// Rounding of a sum of n <= 1000 terms: n times 1.1e-16 at the very most.
constexpr double rounding = 1e-13;

TEST(ShockTube, PointsOfEqualMass) {
  const Tube tube({});
  EXPECT_EQ(tube.points().points(), 50 * 8 + 50);  // an eighth of the density, an eighth of the points
  for (int p = 0; p < tube.points().points(); ++p)
    EXPECT_NEAR(tube.at(column::mass, p), 0.5 / 400, rounding * 0.5 / 400);
  EXPECT_NEAR(tube.sum(column::mass), 0.5 * 1 + 0.5 * 0.125, rounding);
  EXPECT_NEAR(tube.sum(column::volume), 1, rounding);
}

TEST(ShockTube, PointsOfEqualVolume) {
  const Tube tube({"points=equal-volume", "ppc=3"});
  EXPECT_EQ(tube.points().points(), 300);
  for (int p = 0; p < 300; ++p) {
    EXPECT_NEAR(tube.at(column::volume, p), 1.0 / 300, rounding);
    EXPECT_NEAR(tube.at(column::mass, p), (p < 150 ? 1 : 0.125) / 300, rounding);
  }
  EXPECT_NEAR(tube.sum(column::mass), 0.5625, rounding);
}

// Mass and energy do not depend on how many points there are or where the grid and the diaphragm stand.
TEST(ShockTube, NoMassOrEnergyIsLostInTheLayout) {
  for (const std::vector<std::string>& typed : {std::vector<std::string>{"cells=97"},
                                                {"cells=31", "ppc=5", "diaphragm=0.3137"},
                                                {"points=equal-volume", "ppc=1"},
                                                {"right.density=0.7", "left.density=2.3"},
                                                {"left.density=0.125", "right.density=1"},
                                                {"offset=0.25"},
                                                {"offset=0.875", "cells=50", "diaphragm=0.71"},
                                                {"diaphragm=0.001"}}) {
    const Tube tube(typed);
    const double d = tube.settings.number("diaphragm"), left = d - tube.low(), right = tube.high() - d;
    const double rho_l = tube.settings.number("left.density"), rho_r = tube.settings.number("right.density");
    EXPECT_NEAR(tube.sum(column::mass), rho_l * left + rho_r * right, rounding) << typed.front();
    EXPECT_NEAR(tube.sum(column::volume), left + right, rounding) << typed.front();
    double energy = 0;
    for (int p = 0; p < tube.points().points(); ++p) energy += tube.at(column::mass, p) * tube.at(column::energy, p);
    EXPECT_NEAR(energy, (left * 1 + right * 0.1) / 0.4, 10 * rounding) << typed.front();
  }
}

TEST(ShockTube, PointsStandInTheMiddlesOfTheirVolumesOnTheirOwnSide) {
  for (const std::vector<std::string>& typed :
       {std::vector<std::string>{}, {"offset=0.25", "cells=40"}, {"diaphragm=0.3137"}}) {
    const Tube tube(typed);
    const double d = tube.settings.number("diaphragm");
    double edge = tube.low();
    for (int p = 0; p < tube.points().points(); ++p) {
      const double x = tube.at(column::position, p), volume = tube.at(column::volume, p);
      EXPECT_NEAR(x, edge + volume / 2, rounding) << p;
      EXPECT_EQ(tube.at(column::density, p), x < d ? 1 : 0.125) << p;
      EXPECT_NEAR(tube.at(column::mass, p), volume * tube.at(column::density, p), rounding) << p;
      edge += volume;
    }
    EXPECT_NEAR(edge, tube.high(), rounding);
  }
}

TEST(ShockTube, PointsCarryTheGivenStates) {
  const Tube tube({"left.velocity=0.3", "right.velocity=-0.2", "left.pressure=2", "gamma=1.67"});
  const int last = tube.points().points() - 1;
  EXPECT_EQ(tube.at(column::velocity, 0), 0.3);
  EXPECT_EQ(tube.at(column::velocity, last), -0.2);
  EXPECT_NEAR(tube.at(column::energy, 0), 2 / (0.67 * 1), 1e-14);
  EXPECT_NEAR(tube.at(column::energy, last), 0.1 / (0.67 * 0.125), 1e-14);
}

// The grid is shifted and one cell longer, so that it still covers the tube; walls stand at both ends.
TEST(ShockTube, AnOffsetShiftsTheGrid) {
  const Tube still({}), shifted({"offset=0.25"});
  EXPECT_EQ(still.scene.grid.origin[0], 0);
  EXPECT_EQ(still.scene.grid.cells[0], 100);
  EXPECT_DOUBLE_EQ(shifted.scene.grid.origin[0], -0.0025);
  EXPECT_EQ(shifted.scene.grid.cells[0], 101);
  EXPECT_GE(shifted.high(), 1);
  for (const Tube* tube : {&still, &shifted}) {
    EXPECT_DOUBLE_EQ(tube->scene.grid.h, 0.01);
    EXPECT_EQ(tube->scene.grid.walls[0][0], Wall::symmetry);
    EXPECT_EQ(tube->scene.grid.walls[0][1], Wall::symmetry);
  }
}

TEST(ShockTube, TheSceneTakesItsChoicesFromTheSettings) {
  const Tube tube({"shape=cubic", "density=cell", "viscosity.closing=divergence", "viscosity.linear=0.7",
                   "viscosity.quadratic=1.3"});
  EXPECT_EQ(tube.scene.shape, "cubic");
  EXPECT_EQ(tube.scene.density, DensityMethod::cell);
  // The law is known by what it does: q = rho c_Q (h div v)^2 in a gas without sound, c_L of the sound speed else.
  const Material& law = *tube.scene.bodies[0].material;
  Body body = tube.scene.bodies[0];
  const MaterialContext context{1, 0.01, false};
  body.points(column::strain_rate)[0] = -2;
  body.points(column::energy)[0] = 0;
  law.evaluate_stress(body.points, all_points(body.points), context);
  EXPECT_NEAR(-body.points(column::stress)[0], 1.3 * 0.02 * 0.02, 1e-15);
  body.points(column::energy)[0] = 2.5;
  law.evaluate_stress(body.points, all_points(body.points), context);
  const double c = std::sqrt(1.4 * 0.4 * 2.5);
  EXPECT_NEAR(-body.points(column::stress)[0], 1 + 0.7 * c * 0.02 + 1.3 * 0.02 * 0.02, 1e-14);  // [York 4.11]
}

// --- after a run --------------------------------------------------------------------------------------------------------

RunResult run(const std::vector<std::string>& typed) {
  const Case& sod = find_case("sod");
  const RunResult result = run_experiment(sod, "default", sod.settings("default", {{"cells", 50.0}}, typed));
  EXPECT_TRUE(result.finished);
  return result;
}

double error(const RunResult& result, const std::string& name) { return measure(result, name).error; }

TEST(ShockTube, TheProfileHasEveryFieldBesideItsReference) {
  const RunResult result = run({});
  EXPECT_EQ(result.profile.kind, "space");
  EXPECT_EQ(result.profile.abscissa, "x");
  for (const char* name : {"x", "mass", "volume", "density", "velocity", "pressure", "energy", "density_reference",
                           "velocity_reference", "pressure_reference", "energy_reference"}) {
    ASSERT_NE(result.profile.find(name), nullptr) << name;
    EXPECT_EQ(result.profile.find(name)->values.size(), static_cast<std::size_t>(result.points)) << name;
    EXPECT_FALSE(result.profile.find(name)->unit.empty()) << name;
    EXPECT_FALSE(result.profile.find(name)->label.empty()) << name;
  }
}

// The reference at x is the exact solution of the given states at (x - diaphragm)/t_end, whatever is given.
TEST(ShockTube, TheReferenceMovesWithTheSettings) {
  for (const std::vector<std::string>& typed : {std::vector<std::string>{},
                                                {"gamma=1.67"},
                                                {"t_end=0.1"},
                                                {"diaphragm=0.4"},
                                                {"left.density=2", "right.pressure=0.2"},
                                                {"left.velocity=0.1", "right.velocity=0.1"}}) {
    const RunResult result = run(typed);
    const Settings& s = result.settings;
    const reference::RiemannSolution exact(
        {{s.number("left.density"), s.number("left.velocity"), s.number("left.pressure")},
         {s.number("right.density"), s.number("right.velocity"), s.number("right.pressure")},
         s.number("gamma")});
    for (std::size_t p = 0; p < column_of(result, "x").size(); ++p) {
      const double xi = (column_of(result, "x")[p] - s.number("diaphragm")) / s.number("t_end");
      // The clock's last digit moves xi by a few units in the last place, which only a wave notices.
      const reference::Sample at = exact.sample(xi);
      const double slack = 1e-12;
      EXPECT_NEAR(column_of(result, "density_reference")[p], at.density.value, slack);
      EXPECT_NEAR(column_of(result, "velocity_reference")[p], at.velocity.value, slack);
      EXPECT_NEAR(column_of(result, "pressure_reference")[p], at.pressure.value, slack);
      EXPECT_NEAR(column_of(result, "energy_reference")[p], at.energy.value, slack);
    }
  }
}

// Kernel and reference move together: the error changes by less than a factor of two.
TEST(ShockTube, ChangingStatesTimeOrDiaphragmKeepsTheError) {
  const double as_given = error(run({}), "density.L1");
  for (const char* change : {"gamma=1.67", "gamma=1.2", "t_end=0.1", "t_end=0.18", "diaphragm=0.4", "diaphragm=0.55"}) {
    const double changed = error(run({change}), "density.L1");
    EXPECT_LT(changed, 2 * as_given) << change;
    EXPECT_GT(changed, as_given / 2) << change;
  }
}

// The norms once more, from the columns of the profile.
TEST(ShockTube, MeasuresAreTheNormsOfWhatTheProfileShows) {
  const RunResult result = run({"points=equal-volume", "ppc=3"});
  const auto& volume = column_of(result, "volume");
  double tube = 0;
  for (const double v : volume) tube += v;
  for (const char* field : {"density", "velocity", "pressure", "energy"}) {
    const auto &computed = column_of(result, field), &exact = column_of(result, std::string(field) + "_reference");
    double l1 = 0, l2 = 0, linf = 0;
    for (std::size_t p = 0; p < volume.size(); ++p) {
      const double e = std::abs(computed[p] - exact[p]);
      l1 += volume[p] * e / tube;
      l2 += volume[p] * e * e / tube;
      linf = std::max(linf, e);
    }
    EXPECT_NEAR(error(result, std::string(field) + ".L1"), l1, 1e-13) << field;
    EXPECT_NEAR(error(result, std::string(field) + ".L2"), std::sqrt(l2), 1e-13) << field;
    EXPECT_NEAR(error(result, std::string(field) + ".Linf"), linf, 1e-13) << field;
  }
  EXPECT_NEAR(*measure(result, "coverage").value, tube / 1.0, 1e-13);
  EXPECT_EQ(measure(result, "coverage").reference, 1.0);
}

TEST(ShockTube, CoverageIsOfTheShiftedTubeToo) {
  // A kernel of three cells blurs each wave by less than its width: 1 % at 50 cells is the gate's own bound at 100.
  EXPECT_NEAR(*measure(run({"offset=0.5"}), "coverage").value, 1, 0.01);
}

// Energy and pressure of the profile are one gas: p = (gamma - 1) rho e, in points and in the reference.
// Of York's densities; those of the grid have pressures of their own [Read-off 2].
TEST(ShockTube, ProfileIsAnIdealGas) {
  const RunResult result = run({"gamma=1.67", "density=quadratic"});
  for (const std::string suffix : {"", "_reference"}) {
    for (std::size_t p = 0; p < column_of(result, "x").size(); ++p) {
      EXPECT_NEAR(column_of(result, "pressure" + suffix)[p],
                  0.67 * column_of(result, "density" + suffix)[p] * column_of(result, "energy" + suffix)[p],
                  1e-12);  // [York 4.4]
    }
  }
}

TEST(ShockTube, KeysCarryTheTubesOwnDefaults) {
  const ShockTube tube{{{3, 0.5, 4}, {2, -0.5, 1}, 1.3}, 0, 2, 0.75, 0.2};
  const Settings settings(TubeParameters(tube).keys());
  const ShockTube back = TubeParameters(tube, settings).tube;
  EXPECT_EQ(back.states.left.density, 3);
  EXPECT_EQ(back.states.left.velocity, 0.5);
  EXPECT_EQ(back.states.left.pressure, 4);
  EXPECT_EQ(back.states.right.density, 2);
  EXPECT_EQ(back.states.right.velocity, -0.5);
  EXPECT_EQ(back.states.right.pressure, 1);
  EXPECT_EQ(back.states.gamma, 1.3);
  EXPECT_EQ(back.diaphragm, 0.75);
  EXPECT_EQ(back.end_time, 0.2);
  EXPECT_EQ(back.high, 2);
}

}  // namespace
}  // namespace plumbline::shock_tube_test
