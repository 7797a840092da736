// Breathing of a thin sphere around a gas.
#include "reference/gas_sphere.hpp"

#include "tests/reference/checks.hpp"

namespace plumbline::reference::gas_sphere_test {
namespace {

GasSphereProblem with(double stretch, double gas_density, bool neo_hookean = false) {
  GasSphereProblem p;
  p.sheet.stretch = stretch;
  p.sheet.neo_hookean = neo_hookean;
  p.gas_density = gas_density;
  return p;
}

TEST(GasSphere, LightGasIsASpring) {  // [Surface 17] for slow motion
  const GasSphere light(with(1.2, 1e-9));
  const double w = light.quasi_static_omega().value;
  EXPECT_NEAR(light.omega().value, w, 1e-6 * w);
  EXPECT_GT(light.omega().value, 1.05 * light.dry_omega().value);
}

TEST(GasSphere,
     HeavySheetHoldsTheGas) {  // whose modes are those within a rigid wall: tan z = z
  GasSphereProblem heavy = with(1.2, 0.03);
  heavy.sheet.density = 1e7;
  const GasSphere sphere(heavy);
  expect_near(sphere.wavenumber(2), 4.49340946, 1e-5);
  expect_near(sphere.wavenumber(3), 7.72525184, 1e-5);
}

TEST(GasSphere, LightSheetLetsGo) {  // neither mass nor, against the gas, stiffness: p = 0 there, z = n pi
  GasSphereProblem light = with(1.2, 1e6);
  light.sheet.density = 1e-9;
  // what stiffness it has is k_s R/(gamma p), of order one: it moves z by that over z
  const GasSphere sphere(light);
  const double kappa = (sphere.sheet_stiffness() * sphere.radius() / (Bounded(1.4) * sphere.pressure())).value;
  const double z = sphere.wavenumber(40).value, free = 40 * 3.141592653589793;
  EXPECT_NEAR(z, free + kappa / free, 2 * std::pow(kappa / free, 2));
}

TEST(GasSphere, EveryRootBalancesSheetAndGas) {
  for (const bool neo_hookean : {false, true}) {
    for (const double density : {1e-3, 0.03, 1.0}) {
      const GasSphereProblem p = with(1.3, density, neo_hookean);
      const GasSphere sphere(p);
      const Bounded mass = Bounded(p.sheet.density) * p.sheet.thickness / (1.3 * 1.3);
      double before = 0;
      for (int n : {1, 2, 3, 10, 60}) {
        const Bounded w = sphere.omega(n);
        EXPECT_GT(lowest(w), before);
        before = highest(w);
        const Bounded balance = mass * w * w - sphere.sheet_stiffness() + sphere.pressure_shape(1.3, n);
        expect_zero(balance, (mass * w * w).value + std::abs(sphere.sheet_stiffness().value), "balance", 1e-8);
      }
    }
  }
}

TEST(GasSphere, StiffnessIsTheSlopeOfTheLoad) {  // of the sheet under a load that stays, p l^2 at rest's area
  const PressurisedSphere sheet({.stretch = 1.2});
  const GasSphere sphere(with(1.2, 0.03));
  const double p = sphere.pressure().value, h = 1e-5;
  // rho t R0 l'' = p l^2 - 2 t l S/R0 [Surface 6], with 2 t S = p(l) l R0: over l^2, per area as it is
  auto push = [&](double l) { return (p - sheet.pressure(l).value) * l * l / (1.2 * 1.2); };
  EXPECT_NEAR((push(1.2 + h) - push(1.2 - h)) / (2 * h), -sphere.sheet_stiffness().value, 1e-8);
}

// dp = -gamma p div xi and rho_g xi_tt = -dp_r, by differences.
TEST(GasSphere, ModeIsAWave) {
  const GasSphereProblem p = with(1.2, 0.05);
  const GasSphere sphere(p);
  const double h = 1e-3, r = 0.7;
  for (const int n : {1, 2}) {
    auto xi = [&](double at) { return sphere.shape(at, n).value; };
    auto pressure = [&](double at) { return sphere.pressure_shape(at, n).value; };
    const double divergence = (xi(r + h) * (r + h) * (r + h) - xi(r - h) * (r - h) * (r - h)) / (2 * h * r * r);
    EXPECT_NEAR(pressure(r), -1.4 * sphere.pressure().value * divergence, 1e-4 * std::abs(pressure(0)));
    const double w = sphere.omega(n).value, slope = (pressure(r + h) - pressure(r - h)) / (2 * h);
    EXPECT_NEAR(slope, 0.05 * w * w * xi(r), 1e-4 * 0.05 * w * w);
  }
  EXPECT_NEAR(sphere.shape(1.2).value, 1, 1e-12);
  EXPECT_EQ(sphere.shape(0).value, 0);
  EXPECT_NEAR(sphere.shape(1e-4).value * 2, sphere.shape(2e-4).value, 1e-10);  // j1(z) ~ z/3 [DLMF 10.53.1]
}

TEST(GasSphere, Laplace) {
  const GasSphere sphere(with(1.2, 0.03));
  expect_zero(sphere.resultant() - Bounded(0.5) * sphere.pressure() * sphere.radius(), sphere.resultant().value,
              "N = p R/2");
  EXPECT_NEAR(sphere.velocity(0).value, 1, 1e-15);
}

TEST(GasSphere, BadProblems) {
  EXPECT_EQ(refused_key([] { GasSphere sphere(with(1, 0.03)); }), "stretch");
  EXPECT_EQ(refused_key([] { GasSphere sphere(with(1.2, 0)); }), "gas_density");
  EXPECT_EQ(refused_key([] { GasSphere().omega(0); }), "mode");
  EXPECT_EQ(refused_key([] { GasSphere().shape(2); }), "radius");
  EXPECT_EQ(refused_key([] { GasSphere().velocity(-1); }), "time");
}

}  // namespace
}  // namespace plumbline::reference::gas_sphere_test
