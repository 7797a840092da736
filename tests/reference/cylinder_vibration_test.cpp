// The breathing cylinder: the equations of motion, the free surface, the energy, and roots of limits.
#include "reference/cylinder_vibration.hpp"

#include "tests/reference/checks.hpp"

namespace plumbline::reference::cylinder_vibration_test {
namespace {

const CylinderVibrationProblem some{0.7, 30, 0.2, 2, 0.01, 1};

// rho u_tt = sigma_r' + (sigma_r - sigma_theta)/r by central differences, h^2 k^2 of the largest stress over r.
TEST(CylinderVibration, ObeysTheEquationOfMotion) {  // [Graff 8.2]
  const double h = 1e-4;
  for (int mode : {1, 2, 3}) {
    CylinderVibrationProblem problem = some;
    problem.mode = mode;
    const CylinderVibration cylinder(problem);
    const double time = 0.13 * cylinder.period().value, omega = cylinder.omega().value;
    const double scale = problem.density * omega * problem.velocity;
    for (double r : {0.1, 0.35, 0.6}) {
      const auto radial = [&](double at) { return cylinder.radial_stress(at, time).value; };
      const double force = (radial(r + h) - radial(r - h)) / (2 * h) +
                           (radial(r) - cylinder.hoop_stress(r, time).value) / r;
      EXPECT_NEAR(force, -problem.density * omega * omega * cylinder.displacement(r, time).value, 1e-5 * scale);
    }
    EXPECT_NEAR(cylinder.radial_stress(problem.radius, time).value, 0, 1e-12 * scale * problem.radius);
    EXPECT_NEAR(cylinder.radial_stress(0, time).value, cylinder.hoop_stress(0, time).value,
                1e-12 * scale * problem.radius);
  }
}

// Kinetic energy at t = 0 by Simpson's rule: h^4 k^4 of it.
TEST(CylinderVibration, EnergyIsThatOfTheStart) {  // [Graff 8.2]
  const CylinderVibration cylinder(some);
  const int pieces = 400;
  double sum = 0;
  for (int k = 0; k <= pieces; ++k) {
    const double r = some.radius * k / pieces, v = cylinder.velocity(r, 0).value;
    sum += (k == 0 || k == pieces ? 1 : k % 2 == 1 ? 4 : 2) * r * v * v;
  }
  const double kinetic = M_PI * some.density * sum * some.radius / pieces / 3;
  EXPECT_NEAR(cylinder.energy().value, kinetic, 1e-9 * kinetic);
  EXPECT_LE(cylinder.energy().bound, 1e-12 * kinetic);
}

// Where nu = 0, x J_0 = J_1; where nu is near 1/2 the surface hardly strains, and x is the zero of J_0.
TEST(CylinderVibration, RootsOfLimits) {                                                   // [Graff 8.2]
  EXPECT_NEAR(CylinderVibration({1, 1, 0, 1, 1, 1}).wavenumber().value, 1.8411838, 1e-7);  // J_1' = 0, DLMF table 10.21
  EXPECT_NEAR(CylinderVibration({1, 1, 0.5 - 1e-9, 1, 1, 1}).wavenumber().value, 2.4048256, 1e-7);
}

TEST(CylinderVibration, WrongProblemsAreRefusedByKey) {
  const auto key = [](double CylinderVibrationProblem::*member, double value) {
    CylinderVibrationProblem problem;
    problem.*member = value;
    return refused_key([=] { CylinderVibration{problem}; });
  };
  EXPECT_EQ(key(&CylinderVibrationProblem::radius, 0), "radius");
  EXPECT_EQ(key(&CylinderVibrationProblem::youngs_modulus, -1), "youngs_modulus");
  EXPECT_EQ(key(&CylinderVibrationProblem::poisson, 0.5), "poisson");
  EXPECT_EQ(key(&CylinderVibrationProblem::density, 0), "density");
  EXPECT_EQ(key(&CylinderVibrationProblem::velocity, std::nan("")), "velocity");
  EXPECT_EQ(refused_key([] { CylinderVibration({1, 1, 0.3, 1, 1, 0}); }), "mode");
  EXPECT_EQ(refused_key([] { CylinderVibration(CylinderVibrationProblem()).velocity(1.01, 0); }), "radius");
}

}  // namespace
}  // namespace plumbline::reference::cylinder_vibration_test
