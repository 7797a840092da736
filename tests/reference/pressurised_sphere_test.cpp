// The sphere under pressure: Laplace's balance, the balloon's limit point, breathing as a shell and by elliptic
// functions.
#include "reference/pressurised_sphere.hpp"

#include "reference/circle.hpp"
#include "reference/elliptic.hpp"
#include "reference/exponential.hpp"
#include "tests/reference/checks.hpp"

namespace plumbline::reference::pressurised_sphere_test {
namespace {

const PressurisedSphereProblem problems[] = {{},
                                             {7, 0.2, 0.03, 3, 0.4, 1, false},
                                             {1, 0.5, 0.01, 1, 2, 0.8, false},
                                             {1, 0.3, 0.01, 1, 1, 1.7, false},
                                             {2, 0.3, 0.02, 0.1, 3, 1.2, true},
                                             {1, 0.3, 0.01, 1, 1, 1, true},
                                             {1, 0.3, 0.01, 1, 1, 0.9, true}};

TEST(EqualStretches, ValuesByHand) {  // [Surface 5]
  const EqualStretches stiff{2, 0.25, false}, rubber{3, 0.25, true};
  expect_zero(stiff.stress(2.0) - 4.0, 1, "S");
  expect_zero(stiff.energy(2.0) - 6.0, 1, "W");
  expect_zero(rubber.stress(2.0) - (1 - 1.0 / 64), 1, "S");
  expect_zero(rubber.energy(2.0) - 0.5 * (8 + 1.0 / 16 - 3), 1, "W");
  for (double l : {1 + 1e-9, 1 - 1e-9}) {  // rubber begins as a sheet of nu = 1/2
    EXPECT_NEAR(EqualStretches({3, 0.5, false}).stress(l).value / rubber.stress(l).value, 1, 1e-8);
    EXPECT_LE(rubber.stress(l).bound, 1e-14 * std::abs(rubber.stress(l).value));
    EXPECT_NEAR(rubber.energy(l).value / (6 * (l - 1) * (l - 1)), 1, 1e-8);
  }
}

// dW = 2 l S dl and dS by central differences: their error is h^2/6 of a third derivative, at most 1000 here.
TEST(EqualStretches, StressIsTheSlopeOfTheEnergy) {  // [Surface 5]
  const double h = 1e-4;
  for (const EqualStretches& law : {EqualStretches{2, 0.2, false}, EqualStretches{3, 0.2, true}}) {
    for (double l : {0.8, 1.0, 1.3, 2.2}) {
      const double work = (law.energy(l + h).value - law.energy(l - h).value) / (2 * h);
      EXPECT_NEAR(work, 2 * l * law.stress(l).value, 1000 * h * h / 6);
      const double slope = (law.stress(l + h).value - law.stress(l - h).value) / (2 * h);
      EXPECT_NEAR(slope, law.slope(l).value, 1e4 * h * h / 6);
    }
  }
}

TEST(PressurisedSphere, ForcesBalanceOnHalfASphere) {  // [Surface 6]
  for (const PressurisedSphereProblem& p : problems) {
    const PressurisedSphere sphere(p);
    const Bounded R = Bounded(p.stretch) * p.radius;
    const Bounded push = sphere.pressure() * pi * R * R, pull = sphere.resultant() * Bounded(2) * pi * R;
    expect_zero(push - pull, 1, "half a sphere");
    expect_zero(sphere.resultant() - sphere.stress(p.stretch) * p.thickness, 1, "N = t S");
  }
}

// I. Mueller, P. Strehlow, Rubber and Rubber Balloons (2004): the neo-Hookean balloon's pressure is the largest at
// 7^(1/6) = 1.383.
TEST(PressurisedSphere, BalloonHasALimitPoint) {  // [Surface 6, 7]
  const double limit = std::pow(7, 1.0 / 6);
  EXPECT_NEAR(limit, 1.383, 5e-4);
  const PressurisedSphereProblem p{3, 0.3, 0.01, 2, 0.7, 1.2, true};
  const PressurisedSphere balloon(p);
  const double top = 2 * 0.01 / 0.7 * 6 / 7 / limit;
  EXPECT_NEAR(balloon.pressure(limit).value, top, 1e-14);
  for (double l : {1.2, limit * 0.999, limit * 1.001, 2.0}) EXPECT_LT(balloon.pressure(l).value, top);
  auto omega = [p](double l) {
    PressurisedSphereProblem at = p;
    at.stretch = l;
    return PressurisedSphere(at).omega().value;
  };
  EXPECT_EQ(omega(limit * 1.001), 0);
  EXPECT_GT(omega(limit * 0.999), 0);
  EXPECT_LT(omega(limit * 0.999), 0.1 * omega(1.2));
}

// W. E. Baker, J. Acoust. Soc. Am. 33 (1961) 1749.
TEST(PressurisedSphere, UnstretchedBreathesAsAShell) {  // [Surface 7]
  for (double nu : {-0.4, 0.0, 0.3, 0.5}) {
    const PressurisedSphere shell({210e9, nu, 1e-3, 7800, 0.3, 1, false});
    const Bounded square = Bounded(2) * 210e9 / ((Bounded(1) - nu) * 7800 * 0.3 * 0.3);
    expect_zero(shell.omega() - sqrt(square), shell.omega().value, "omega");
  }
  // of rubber it is the same at nu = 1/2
  expect_same(PressurisedSphere({6, 0.5, 0.1, 2, 3, 1, false}).omega(),
              PressurisedSphere({6, 0, 0.1, 2, 3, 1, true}).omega());
}

// rho t R0 l'' = l^2 (p - p(l)): w^2 = l^2 p'/(rho t R0), p' by central differences of pressures.
TEST(PressurisedSphere, BreathesByTheRiseOfThePressure) {  // [Surface 7]
  const double h = 1e-4;
  for (const PressurisedSphereProblem& p : problems) {
    const PressurisedSphere sphere(p);
    const double rise = (sphere.pressure(p.stretch + h).value - sphere.pressure(p.stretch - h).value) / (2 * h);
    const double square = p.stretch * p.stretch * rise / (p.density * p.thickness * p.radius);
    const double omega = sphere.omega().value;
    EXPECT_NEAR(square / (omega * omega), 1, 1e3 * h * h);
  }
}

// Without pressure l'' = k (l - l^3), k = E/((1 - nu) rho R0^2): l = a dn(a sqrt(k/2) t, m), m = 2 - 2/a^2
// [DLMF 22.13.15], with the period 2 K/(a sqrt(k/2)), and it turns at sqrt(2 - a^2).
TEST(PressurisedSphere, FiniteBreathingByEllipticFunctions) {  // [Surface 8]
  const PressurisedSphere sphere({3, 0.25, 0.02, 0.5, 1.5, 1, false});
  const Bounded k = Bounded(3) / (Bounded(0.75) * 0.5 * 1.5 * 1.5);
  for (double amplitude : {1e-9, 1e-3, 0.1, 0.3, 0.4}) {
    const Bounded a = Bounded(1) + amplitude, m = Bounded(2) * amplitude * (a + 1.0) / (a * a);
    const Bounded kept = sqrt(Bounded(2) - a * a);
    const Bounded period = Bounded(2) * elliptic_K(sqrt(m), kept / a) / (a * sqrt(k / 2.0));
    expect_zero(sphere.period(amplitude) - period, period.value, "period");
    expect_zero(sphere.turning_stretch(amplitude) - kept, 1, "turning");
  }
}

TEST(PressurisedSphere, ReleasedFromTheOtherSideItSwingsTheSame) {  // [Surface 8]
  for (const PressurisedSphereProblem& p : problems) {
    const PressurisedSphere sphere(p);
    for (double amplitude : {1e-6, 0.02, 0.1, -0.1}) {
      const Bounded turning = sphere.turning_stretch(amplitude), period = sphere.period(amplitude);
      EXPECT_LT((turning.value - p.stretch) * amplitude, 0);
      const double back = turning.value - p.stretch;
      EXPECT_NEAR(sphere.turning_stretch(back).value, p.stretch + amplitude, 1e-12);
      EXPECT_NEAR(sphere.period(back).value, period.value, 1e-12 * period.value);
      EXPECT_LE(period.bound, 1e-12 * period.value);
    }
    expect_zero(sphere.period(0) * sphere.omega() - Bounded(2) * pi, 1, "small");
    EXPECT_NEAR(sphere.period(1e-7).value, sphere.period(0).value, 1e-12 * sphere.period(0).value);
    EXPECT_EQ(sphere.turning_stretch(0).value, p.stretch);
  }
}

// The balloon at 1.2 bursts if it is released where pressure outweighs it: S/l = S0/l0 again.
TEST(PressurisedSphere, NoSwingWithoutTwoTurningPoints) {
  auto period = [](PressurisedSphereProblem p, double amplitude) {
    return refused_key([=] { PressurisedSphere(p).period(amplitude); });
  };
  PressurisedSphereProblem p{1, 0.3, 0.01, 1, 1, 1.2, true};
  EXPECT_EQ(period(p, 0.3), "accepted");
  EXPECT_EQ(period(p, 0.6), "amplitude");
  EXPECT_EQ(period(p, -0.5), "amplitude");  // would burst on its way back
  EXPECT_EQ(period(p, -1.2), "amplitude");
  for (double unstable : {1.4, 1.5, 1.6, 1.7, 1.8, 1.9, 2.0}) {
    p.stretch = unstable;
    for (double amplitude : {0.0, 0.01, -0.01}) EXPECT_EQ(period(p, amplitude), "amplitude");
  }
  p.stretch = 1;
  p.neo_hookean = false;
  EXPECT_EQ(period(p, 0.4), "accepted");
  EXPECT_EQ(period(p, 0.42), "amplitude");  // from sqrt(2) on it shrinks to nothing
  EXPECT_EQ(period(p, std::nan("")), "amplitude");
}

TEST(PressurisedSphereProblem, WrongProblemsAreRefusedByKey) {
  auto key = [](double PressurisedSphereProblem::*member, double value) {
    return refused_value<PressurisedSphere, PressurisedSphereProblem>(member, value);
  };
  for (double wrong : {0.0, -1.0, std::nan(""), rounding::infinity}) {
    EXPECT_EQ(key(&PressurisedSphereProblem::youngs_modulus, wrong), "youngs_modulus");
    EXPECT_EQ(key(&PressurisedSphereProblem::thickness, wrong), "thickness");
    EXPECT_EQ(key(&PressurisedSphereProblem::density, wrong), "density");
    EXPECT_EQ(key(&PressurisedSphereProblem::radius, wrong), "radius");
    EXPECT_EQ(key(&PressurisedSphereProblem::stretch, wrong), "stretch");
    EXPECT_EQ(refused_key([=] { PressurisedSphere().pressure(wrong); }), "stretch");
    EXPECT_EQ(refused_key([=] { PressurisedSphere().stress(wrong); }), "stretch");
  }
  EXPECT_EQ(key(&PressurisedSphereProblem::poisson_ratio, -1), "poisson_ratio");
  EXPECT_EQ(key(&PressurisedSphereProblem::poisson_ratio, 0.51), "poisson_ratio");
  EXPECT_EQ(key(&PressurisedSphereProblem::poisson_ratio, 0.5), "accepted");
}

}  // namespace
}  // namespace plumbline::reference::pressurised_sphere_test
