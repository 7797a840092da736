// The sheet that wrinkles: its three states, stresses as slopes of the energy, and its tones.
#include "reference/tension_field.hpp"

#include "tests/reference/checks.hpp"

namespace plumbline::reference::tension_field_test {
namespace {

TensionFieldProblem sheet(double stretch, double shear) { return {7, 0.3, 0.02, 2, stretch, shear, 0.8}; }

TEST(TensionField, WrinkledIsPulledOneWay) {  // [Surface 12, 13]
  const TensionField wrinkled(sheet(1, 0.1));
  const double e1 = 0.105;
  expect_near(wrinkled.energy(), 7 * e1 * e1 / 2, 1e-11);
  expect_near(wrinkled.stress_along(), 7 * e1, 1e-11);
  EXPECT_EQ(wrinkled.stress_across().value, 0);
  EXPECT_EQ(wrinkled.stress_across().bound, 0);
  expect_near(wrinkled.resultant_along(), 0.02 * 7 * e1 * 1.1 / 0.9, 1e-11);
  const double string = std::sqrt(7 * e1 / 2) * M_PI / 1.6;  // whatever it does across
  expect_near(wrinkled.omega(1, 1), string, 1e-10);
  expect_near(wrinkled.omega(2, 5), 2 * string, 1e-10);
}

TEST(TensionField, TautIsPlaneStress) {  // [Surface 12, 13]
  const TensionField taut(sheet(1.1, 0.02));
  const double e1 = (1.122 * 1.122 - 1) / 2, e2 = (1.078 * 1.078 - 1) / 2;
  const double s1 = 7 / 0.91 * (e1 + 0.3 * e2), s2 = 7 / 0.91 * (e2 + 0.3 * e1);
  expect_near(taut.energy(), (s1 * e1 + s2 * e2) / 2, 1e-11);
  expect_near(taut.stress_along(), s1, 1e-11);
  expect_near(taut.stress_across(), s2, 1e-11);
  expect_near(taut.resultant_across(), 0.02 * s2 * 1.078 / 1.122, 1e-11);
  const double k = M_PI / 1.6;
  expect_near(taut.omega(2, 3), std::sqrt((4 * s1 + 9 * s2) / 2) * k, 1e-10);
}

TEST(TensionField, SlackBearsNothing) {  // [Surface 12]
  const TensionField slack(sheet(0.9, 0.05));
  for (const Bounded& none : {slack.energy(), slack.stress_along(), slack.stress_across(), slack.omega(1, 1)}) {
    EXPECT_EQ(none.value, 0);
    EXPECT_LE(none.bound, 1e-150);  // the root of the least number
  }
}

// dW/ds = S1 l1 dl1/ds + S2 l2 dl2/ds at the same stretch, by central differences: h^2 of third derivatives, at the border of two
// states h of second ones, all below 1e2.
TEST(TensionField, StressesAreSlopesOfTheEnergy) {  // [Surface 12]
  const double h = 1e-6;
  for (const double stretch : {0.97, 1.0, 1.05}) {
    for (double shear = 0.005; shear < 0.3; shear += 0.005) {
      const TensionField at(sheet(stretch, shear));
      const double slope = (TensionField(sheet(stretch, shear + h)).energy().value -
                            TensionField(sheet(stretch, shear - h)).energy().value) /
                           (2 * h);
      const double square = stretch * stretch;
      EXPECT_NEAR(slope, square * ((1 + shear) * at.stress_along().value - (1 - shear) * at.stress_across().value),
                  1e-4);
    }
  }
}

TEST(TensionField, WrongProblemsAreRefusedByKey) {
  const auto key = [](double TensionFieldProblem::*member, double value) {
    TensionFieldProblem problem;
    problem.*member = value;
    return refused_key([=] { TensionField{problem}; });
  };
  EXPECT_EQ(key(&TensionFieldProblem::youngs_modulus, 0), "youngs_modulus");
  EXPECT_EQ(key(&TensionFieldProblem::poisson_ratio, 0.51), "poisson_ratio");
  EXPECT_EQ(key(&TensionFieldProblem::thickness, 0), "thickness");
  EXPECT_EQ(key(&TensionFieldProblem::density, -1), "density");
  EXPECT_EQ(key(&TensionFieldProblem::stretch, 0), "stretch");
  EXPECT_EQ(key(&TensionFieldProblem::shear, 1), "shear");
  EXPECT_EQ(key(&TensionFieldProblem::half_side, std::nan("")), "half_side");
  EXPECT_EQ(refused_key([] { TensionField().omega(0, 1); }), "along");
  EXPECT_EQ(refused_key([] { TensionField().omega(1, 1001); }), "across");
}

}  // namespace
}  // namespace plumbline::reference::tension_field_test
