// Initial data of the numerical solvers: means over shells are exact where the quadrature can be.
#include "reference/gas_problem.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "reference/parameter.hpp"

namespace plumbline::reference::gas_problem_test {
namespace {

constexpr double rounding_errors = 1e-14;  // a dozen operations on numbers of order one

TEST(GasProblem, ShellVolumesWithoutCancellation) {
  EXPECT_DOUBLE_EQ(shell_volume(0.25, 0.75, 1), 0.5);
  EXPECT_DOUBLE_EQ(shell_volume(0.25, 0.75, 2), 0.25);         // (r^2 - s^2)/2
  EXPECT_DOUBLE_EQ(shell_volume(0.25, 0.75, 3), 0.40625 / 3);  // (r^3 - s^3)/3
  const double thin = 0x1p-40;                                 // 1 + thin is exact
  EXPECT_DOUBLE_EQ(shell_volume(1, 1 + thin, 3), thin * (1 + thin + thin * thin / 3));
}

// Density r^2 at unit velocity in a sphere: r^4 under the integral, which three Gauss points take exactly.
TEST(GasProblem, MeansConserveMassMomentumAndEnergyOfAPolynomial) {
  GasProblem problem{0, 1, GasBoundary::outflow, GasBoundary::outflow, 1.4, 1, 3, {}, {}, false};
  problem.initial = [](double r) { return GasState{r * r, 1, 0.4 * r}; };
  const GasState mean = mean_state(problem, 0.5, 1);
  const double volume = (1 - 0.125) / 3, mass = (1 - std::pow(0.5, 5)) / 5, internal = (1 - std::pow(0.5, 4)) / 4;
  EXPECT_NEAR(mean.density, mass / volume, rounding_errors);
  EXPECT_NEAR(mean.velocity, 1, rounding_errors);
  EXPECT_NEAR(mean.pressure, 0.4 * internal / volume, rounding_errors);
}

// Two halves at velocities +1 and -1: no momentum, and all kinetic energy is heat in the mean.
TEST(GasProblem, AJumpInsideACellIsIntegratedPieceByPiece) {
  const GasProblem tube = riemann_tube({{1, 1, 0.5}, {1, -1, 0.5}, 1.4}, 0.3, 1);
  const GasState mean = mean_state(tube, 0.2, 0.4);
  EXPECT_NEAR(mean.velocity, 0, rounding_errors);
  EXPECT_NEAR(mean.pressure, 0.5 + 0.4 * 0.5, rounding_errors);
}

TEST(GasProblem, StatementsOfTheLiterature) {
  const GasProblem shu = shu_osher_problem(), blast = woodward_colella_problem(), york = gas_expansion_problem();
  // The left state is what a shock of Mach 3 makes of density 1 and pressure 1: Rankine-Hugoniot, six digits printed.
  const double density = 2.4 * 9 / (2 + 0.4 * 9), pressure = 1 + 2.8 / 2.4 * 8;
  EXPECT_NEAR(shu.initial(-4.5).density, density, 5e-7);
  EXPECT_NEAR(shu.initial(-4.5).velocity, 3 * std::sqrt(1.4) * (1 - 1 / density), 5e-7);
  EXPECT_NEAR(shu.initial(-4.5).pressure, pressure, 5e-6);
  EXPECT_DOUBLE_EQ(shu.initial(-3).density, 1 + 0.2 * std::sin(-15.0));
  EXPECT_EQ(blast.initial(0.05).pressure, 1000);
  EXPECT_EQ(blast.initial(0.5).pressure, 0.01);
  EXPECT_EQ(blast.initial(0.95).pressure, 100);
  EXPECT_DOUBLE_EQ(york.initial(0.1).pressure / (0.4 * york.initial(0.1).density), 250);
}

TEST(GasProblem, RefusesWhatIsNoProblem) {
  GasProblem problem = shu_osher_problem();
  EXPECT_NO_THROW(check_problem(problem));
  problem.gamma = 1;
  EXPECT_THROW(check_problem(problem), ParameterError);
  problem = shu_osher_problem();
  problem.end_time = 0;
  EXPECT_THROW(check_problem(problem), ParameterError);
  problem = shu_osher_problem();
  problem.dimension = 2;  // radii below zero
  EXPECT_THROW(check_problem(problem), ParameterError);
  problem = shu_osher_problem();
  problem.high = problem.low;
  EXPECT_THROW(check_problem(problem), ParameterError);
}

}  // namespace
}  // namespace plumbline::reference::gas_problem_test
