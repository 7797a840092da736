// Two disks: what is exact about them.
#include "reference/two_disks.hpp"

#include "tests/reference/flow_checks.hpp"

namespace plumbline::reference::two_disks_test {
namespace {

TEST(TwoDisksPublished, SulskysDisks) {  // touch at ((0.6 sqrt 2 - 0.4)/(0.2 sqrt 2)) = 3 - sqrt 2, in the middle
  const TwoDisks disks;
  EXPECT_NEAR(disks.contact_time().value, 3 - std::sqrt(2.0), 1e-14);
  EXPECT_LE(std::abs(disks.contact_time().value - (3 - std::sqrt(2.0))), disks.contact_time().bound + 1e-15);
  EXPECT_NEAR(disks.contact_x().value, 0.5, 1e-16);
  EXPECT_NEAR(disks.contact_y().value, 0.5, 1e-16);
  EXPECT_NEAR(disks.energy().value, 0.8 * M_PI, 1e-13);  // rho pi R^2 v^2 = 1000 pi 0.04 0.02 = 2.513
  EXPECT_NEAR(disks.mass().value, 40 * M_PI, 1e-12);
  EXPECT_NEAR(disks.wave_speed().value, std::sqrt(0.7 / (1.3 * 0.4)), 1e-14);
}

TEST(TwoDisksIdentity, FlightAndEnergies) {
  const TwoDisksProblem p{-1, 0.3, 2, -0.7, 0.9, 50, 0.1, 3, 0.7};
  const TwoDisks disks(p);
  expect_zero(disks.gap() - Bounded(2) * p.speed * disks.contact_time(), 1, "gap closes");
  expect_zero(disks.energy() - disks.mass() * p.speed * p.speed, 10, "two halves of m v^2");
  expect_zero(disks.momentum_of_one() * p.speed - disks.energy(), 10, "momentum");
  EXPECT_GT(disks.crossing_time().value, 0);
  EXPECT_LE(disks.largest_strain_energy().value, disks.energy().value);
}

TEST(TwoDisksProblem, WrongProblemsAreRefusedByKey) {
  const auto key = refused_change<TwoDisks, TwoDisksProblem>;
  EXPECT_EQ(key([](auto& p) { p.radius = 0.43; }), "radius");
  EXPECT_EQ(key([](auto& p) { p.speed = 0; }), "speed");
  EXPECT_EQ(key([](auto& p) { p.density = -1; }), "density");
  EXPECT_EQ(key([](auto& p) { p.poisson = 0.5; }), "poisson");
  EXPECT_EQ(key([](auto& p) { p.youngs_modulus = 0; }), "youngs_modulus");
  EXPECT_EQ(key([](auto& p) { p.left_y = NAN; }), "left_y");
}

}  // namespace
}  // namespace plumbline::reference::two_disks_test
