// A ring around a gas under pressure, let go.
#include "reference/released_ring.hpp"

#include "tests/reference/checks.hpp"

namespace plumbline::reference::released_ring_test {
namespace {

TEST(ReleasedRing, Equilibrium) {  // [York 5.12]
  const ReleasedRing ring({});
  const double hoop = 1e6 / 0.91 * 0.1 * ring.strain();
  EXPECT_NEAR(hoop, ring.equilibrium_pressure() * ring.equilibrium_radius(), 1e-9 * hoop);
  const double r = ring.equilibrium_radius();
  EXPECT_NEAR(ring.equilibrium_gas_density() * r * r, 0.025, 1e-15);
  EXPECT_NEAR(ring.equilibrium_line_mass() * r, 0.05, 1e-15);
  EXPECT_NEAR(ring.equilibrium_pressure(), 1000 * std::pow(ring.equilibrium_radius(), -2.8), 1e-9);
}

TEST(ReleasedRing, StartsAtTheStart) {
  const ReleasedRing ring({});
  EXPECT_LT(ring.left_out(), 1e-5);
  EXPECT_LE(std::abs(ring.radius_change(0).value), ring.radius_change(0).bound);
  EXPECT_LT(ring.radius_change(0).bound, 1e-5 * ring.strain());  // shares fall as n^-4: n^-3 are left out
}

// Before sound has gone anywhere: m R'' = p0 - rho c R', so R = p0 t^2/(2 m) (1 - rho c t/(3 m)), m = rho_m t. The linear
// modes have the force of the strained state: off by the strain, thrice for the three places that it enters in.
TEST(ReleasedRing, FirstMotionIsThatOfThePressureOnTheMembrane) {
  const ReleasedRing ring({});
  const double m = 0.05, t = 5e-5, impedance = std::sqrt(1.4 * 1000 * 0.025);
  const double expected = 1000 * t * t / (2 * m) * (1 - impedance * t / (3 * m));
  EXPECT_NEAR(ring.radius_change(t).value, expected, 3 * ring.strain() * expected);
}

TEST(ReleasedRing, LightGasLeavesOneMode) {
  ReleasedRingProblem light;
  light.gas_density = 1e-6;
  const ReleasedRing ring(light);
  EXPECT_NEAR(ring.share(1).value, 1, 1e-4);
  const double half = 3.141592653589793 / ring.omega(1).value;
  EXPECT_NEAR(ring.radius_change(half).value, 2 * ring.strain(), 1e-3 * ring.strain());
}

TEST(ReleasedRing, RejectsWhatIsNotARing) {
  ReleasedRingProblem bad;
  bad.membrane_density = 0;
  EXPECT_THROW(ReleasedRing{bad}, ParameterError);
}

}  // namespace
}  // namespace plumbline::reference::released_ring_test
