// Rotating disk: equilibrium, Hooke's law, published stresses, energies by quadrature.
#include "reference/rotating_disk.hpp"

#include "tests/reference/flow_checks.hpp"

namespace plumbline::reference::rotating_disk_test {
namespace {

const RotatingDiskProblem disks[] = {{}, {2, 300, 0.2, 7, -0.3}, {0.7, 5e4, 0.4, 3, 4, PlaneState::strain}};

TEST(RotatingDiskPublished, StressAtTheCentre) {  // [Timoshenko 32]: (3 + nu)/8 and (3 - 2 nu)/(8 (1 - nu))
  EXPECT_NEAR(RotatingDisk({}).centre_stress().value, 0.4125, 1e-15);
  RotatingDiskProblem thick;
  thick.plane = PlaneState::strain;
  EXPECT_NEAR(RotatingDisk(thick).centre_stress().value, 2.4 / 5.6, 1e-15);
  EXPECT_NEAR(RotatingDisk({}).hoop_stress(1).value, (1 - 0.3) / 4, 1e-15);  // (1 - nu)/4 rho omega^2 R^2 at the rim
  EXPECT_NEAR(RotatingDisk({}).displacement(1).value, (1 - 0.3) / 4 / 1e4, 1e-19);
}

// [Timoshenko 32]: d(r sigma_r)/dr - sigma_theta + rho omega^2 r^2 = 0, and Hooke's law of u
TEST(RotatingDiskIdentity, EquilibriumAndHookesLaw) {
  for (const RotatingDiskProblem& p : disks) {
    const RotatingDisk disk(p);
    const double size = p.density * std::pow(p.angular_velocity * p.radius, 2), h = 1e-4 * p.radius;
    EXPECT_NEAR(disk.radial_stress(p.radius).value, 0, 1e-15 * size);  // a free rim
    for (double share : {0.1, 0.5, 0.9}) {
      const double r = share * p.radius;
      auto moment = [&](double at) { return at * disk.radial_stress(at).value; };
      const double slope = (moment(r + h) - moment(r - h)) / (2 * h), hoop = disk.hoop_stress(r).value;
      const double load = p.density * p.angular_velocity * p.angular_velocity * r * r;
      EXPECT_NEAR(slope - hoop + load, 0, 1e-7 * size);  // third derivative h^2/6
      const double strain_r = (disk.displacement(r + h).value - disk.displacement(r - h).value) / (2 * h);
      const double strain_t = disk.displacement(r).value / r;
      const double radial = disk.radial_stress(r).value, axial = disk.axial_stress(r).value;
      EXPECT_NEAR(p.youngs_modulus * strain_r, radial - p.poisson * (hoop + axial), 1e-7 * size);
      EXPECT_NEAR(p.youngs_modulus * strain_t, hoop - p.poisson * (radial + axial), 1e-12 * size);
      if (p.plane == PlaneState::strain) {
        EXPECT_NEAR(axial, p.poisson * (radial + hoop), 1e-14 * size);
      } else {
        EXPECT_EQ(axial, 0);
      }
    }
  }
}

TEST(RotatingDiskIdentity, EnergiesAndMomentumByQuadrature) {
  for (const RotatingDiskProblem& p : disks) {
    const RotatingDisk disk(p);
    const double strain = over_body(2, 0, p.radius, [&](double r) {
      const double radial = disk.radial_stress(r).value, hoop = disk.hoop_stress(r).value;
      const double axial = disk.axial_stress(r).value;
      const double squares = radial * radial + hoop * hoop + axial * axial;
      return (squares - 2 * p.poisson * (radial * hoop + hoop * axial + axial * radial)) / (2 * p.youngs_modulus);
    });
    EXPECT_NEAR(disk.strain_energy().value, strain, 1e-11 * strain);
    const double spin = over_body(2, 0, p.radius, [&](double r) {
      return p.density * (r + disk.displacement(r).value) * disk.velocity(r).value;
    });
    EXPECT_NEAR(disk.angular_momentum().value, spin, 1e-11 * std::abs(spin));
    EXPECT_NEAR(disk.kinetic_energy().value, 0.5 * spin * p.angular_velocity, 1e-11 * std::abs(spin));
  }
}

TEST(RotatingDiskBound, IsOfTheOrderOfTheStrain) {
  RotatingDiskProblem p;
  const RotatingDisk slow(p);
  p.angular_velocity = 10;
  const RotatingDisk fast(p);
  EXPECT_NEAR(fast.largest_strain() / slow.largest_strain(), 100, 1e-10);
  const double relative = slow.centre_stress().bound / slow.centre_stress().value;
  EXPECT_NEAR(relative, 4 * slow.largest_strain(), 1e-12);
  EXPECT_NEAR(fast.centre_stress().bound / fast.centre_stress().value / relative, 100, 1e-6);
}

TEST(RotatingDiskProblem, WrongProblemsAreRefusedByKey) {
  auto key = [](const RotatingDiskProblem& p) { return refused_key([&] { RotatingDisk disk(p); }); };
  EXPECT_EQ(key({0}), "radius");
  EXPECT_EQ(key({1, 0}), "youngs_modulus");
  EXPECT_EQ(key({1, 1e4, 0.5}), "poisson");
  EXPECT_EQ(key({1, 1e4, 0.3, 0}), "density");
  EXPECT_EQ(key({1, 1e4, 0.3, 1, 100}), "angular_velocity");
  EXPECT_EQ(refused_key([] { RotatingDisk({}).hoop_stress(1.1); }), "radius");
}

}  // namespace
}  // namespace plumbline::reference::rotating_disk_test
