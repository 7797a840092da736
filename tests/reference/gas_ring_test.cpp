// Breathing of an elastic ring around a gas.
#include "reference/gas_ring.hpp"

#include "reference/bessel.hpp"
#include "tests/reference/checks.hpp"

namespace plumbline::reference::gas_ring_test {
namespace {

GasRingProblem with(RingLaw law, double youngs_modulus = 2e3) {
  GasRingProblem p;
  p.law = law;
  p.youngs_modulus = youngs_modulus;
  return p;
}

// Values of a separate solution to all digits given. The last digit was cut, not rounded, in one of them.
TEST(GasRing, SoftRing) {
  const GasRing ring(with(RingLaw::bare));
  expect_near(ring.omega(1), 25.685, 1e-3);
  expect_near(ring.omega(2), 46.766, 1e-3);
  expect_near(ring.omega(3), 69.064, 1e-3);
  expect_near(ring.dry_omega(), 47.357, 5e-4);
}

TEST(GasRing, YorksStiffRing) {  // the gas sounds as within a rigid wall: 3.8317 c/R and so on, from below
  const GasRing ring(with(RingLaw::bare, 1e6));
  expect_near(ring.omega(1), 32.349, 5e-4);
  expect_near(ring.omega(2), 59.23, 5e-3);
  expect_near(ring.omega(3), 85.89, 5e-3);
  expect_near(ring.dry_omega(), 1058.93, 5e-3);
  expect_near(ring.quasi_static_omega(), 1059.51, 5e-3);
  const double wall = 3.8317059702 * ring.sound_speed().value / 1.4;  // the first zero of J1
  EXPECT_LT(ring.omega().value, wall);
  EXPECT_NEAR(ring.omega().value, wall, 2e-3 * wall);  // 2 gamma p/R over k_s is 1e-3
}

TEST(GasRing, StiffnessIsTheSlopeOfTheTension) {  // [York 5.12]
  for (double young : {2e3, 1e6}) {
    const double modulus = young / 0.91, r = 1.4, h = 1e-4;
    const GasRing chords(with(RingLaw::segments, young)), summed(with(RingLaw::accumulated, young));
    const double r0 = chords.unstretched_radius().value, s0 = summed.unstretched_radius().value;
    const double volume = 2 * 3.141592653589793 * r * 0.1;  // constant: the thickness 0.1 is the one at rest
    auto by_chords = [&](double at) { return modulus * 0.1 * (at / r0 - 1); };
    auto by_sum = [&](double at) { return modulus * std::log(at / s0) * volume / (2 * 3.141592653589793 * at); };
    EXPECT_NEAR(by_chords(r), 30.80 * r, 1e-9);
    EXPECT_NEAR(by_sum(r), 30.80 * r, 1e-9);
    auto stiffness = [&](auto tension) { return ((tension(r + h) - tension(r - h)) / (2 * h) - tension(r) / r) / r; };
    // the difference is off by h^2 T'''/6, about h^2 E' t/R^3
    EXPECT_NEAR(stiffness(by_chords), chords.ring_stiffness().value, 1e-7 * modulus * 0.1);
    EXPECT_NEAR(stiffness(by_sum), summed.ring_stiffness().value, 1e-7 * modulus * 0.1);
  }
}

TEST(GasRing, PrestrainOfTheSoftRing) {
  const GasRing chords(with(RingLaw::segments)), bare(with(RingLaw::bare));
  expect_near(chords.unstretched_radius(), 1.1704, 5e-5);
  expect_near(chords.strain(), 0.196, 5e-4);
  EXPECT_EQ(chords.ring_stiffness().value, bare.ring_stiffness().value);  // the prestress cancels
  expect_near(chords.tension(), 43.12, 1e-9);
  const GasRing summed(with(RingLaw::accumulated));
  expect_near(summed.ring_stiffness() / bare.ring_stiffness(), 1 - 2 * 0.196196, 5e-7);
}

TEST(GasRing, EveryRootBalancesRingAndGas) {
  for (RingLaw law : {RingLaw::segments, RingLaw::accumulated}) {
    for (double young : {2e3, 1e6}) {
      const GasRingProblem p = with(law, young);
      const GasRing ring(p);
      double before = 0;
      for (int n : {1, 2, 3, 10, 60}) {
        const Bounded w = ring.omega(n);
        EXPECT_GT(lowest(w), before);
        before = highest(w);
        const Bounded balance = Bounded(p.line_mass) * w * w - ring.ring_stiffness() + ring.pressure_shape(p.radius, n);
        // a stiff ring holds the gas's pressure next to a pole, where the rounding of z counts a thousand times
        expect_zero(balance, p.line_mass * w.value * w.value + ring.ring_stiffness().value, "balance", 1e-8);
      }
    }
  }
}

TEST(GasRing, ZerosOfJ1SeparateTheRoots) {  // Abramowitz & Stegun, table 9.5
  const double zeros[] = {0, 3.83171, 7.01559, 10.17347, 13.32369, 16.47063};
  for (double line_mass : {1e-3, 0.05, 20.0}) {
    GasRingProblem p;
    p.line_mass = line_mass;
    const GasRing ring(p);
    for (int n = 1; n <= 5; ++n) {
      EXPECT_GT(ring.wavenumber(n).value, zeros[n - 1]);
      EXPECT_LT(ring.wavenumber(n).value, zeros[n]);
    }
  }
}

TEST(GasRing, HeavyRingFeelsTheGasAsASpring) {  // z -> 0: z J0/J1 = 2 - z^2/4
  GasRingProblem p;
  p.line_mass = 1e4;
  const GasRing ring(p);
  const double z = ring.wavenumber().value;
  EXPECT_NEAR(ring.omega().value, ring.quasi_static_omega().value, z * z * ring.omega().value);
  EXPECT_LE(z, 0.02);
}

TEST(GasRing, GasObeysTheWaveEquation) {  // rho w^2 xi = dp_r, dp = -gamma p (r xi)_r/r
  const GasRingProblem p;
  const GasRing ring(p);
  for (int n : {1, 3}) {
    const double w = ring.omega(n).value, h = 1e-4;
    for (double r : {0.2, 0.9, 1.3}) {
      auto flux = [&](double at) { return at * ring.shape(at, n).value; };
      const double dilation = (flux(r + h) - flux(r - h)) / (2 * h * r);
      const double scale = p.gamma * p.pressure * 10 * n;  // k = 6 per metre for n = 3; h^2 k^3/6 of the difference
      EXPECT_NEAR(-p.gamma * p.pressure * dilation, ring.pressure_shape(r, n).value, 1e-6 * scale);
      const double rise = (ring.pressure_shape(r + h, n).value - ring.pressure_shape(r - h, n).value) / (2 * h);
      EXPECT_NEAR(rise, p.gas_density * w * w * ring.shape(r, n).value, 1e-6 * scale * 10);
    }
    EXPECT_EQ(ring.shape(0, n).value, 0);
    EXPECT_EQ(ring.shape(p.radius, n).value, 1);
  }
}

double mass_of(const GasRing& ring, const GasRingProblem& p, int i, int j) {
  const int n = 2000;
  const double circle = 2 * 3.141592653589793;
  double sum = circle * p.radius * p.line_mass;
  for (int k = 0; k < n; ++k) {
    const double r = p.radius * (k + 0.5) / n;
    sum += circle * r * p.gas_density * p.radius / n * ring.shape(r, i).value * ring.shape(r, j).value;
  }
  return sum;
}

TEST(GasRing, ModalMassIsTheIntegralAndModesAreOrthogonal) {
  const GasRingProblem p = with(RingLaw::accumulated);
  const GasRing ring(p);
  for (int n : {1, 2, 4}) {
    const double mass = ring.modal_mass(n).value;
    EXPECT_NEAR(mass_of(ring, p, n, n), mass, 1e-5 * mass);  // midpoints: (k R/2000)^2/24 of the curvature
    EXPECT_NEAR(mass_of(ring, p, n, n + 1), 0, 1e-5 * mass);
    EXPECT_NEAR(ring.mode_energy(n).value, 0.5 * mass, 1e-13 * mass);
  }
}

TEST(GasRing, AModeMovesAsOne) {
  const GasRing ring(GasRingProblem{});
  for (double t : {0.0, 0.03, 0.7}) {
    const Bounded x = ring.displacement(t, 2) * ring.omega(2), v = ring.velocity(t, 2);
    expect_zero(x * x + v * v - Bounded(1), 1, "circle");
    expect_same(ring.pressure_change(1.4, t, 2), ring.pressure_shape(1.4, 2) * ring.displacement(t, 2));
  }
}

TEST(GasRingProblem, WrongProblemsAreRefusedByKey) {
  const auto key = refused_value<GasRing, GasRingProblem>;
  using P = GasRingProblem;
  EXPECT_EQ(key(&P::youngs_modulus, 0), "youngs_modulus");
  EXPECT_EQ(key(&P::poisson_ratio, 0.5), "poisson_ratio");
  EXPECT_EQ(key(&P::thickness, 0), "thickness");
  EXPECT_EQ(key(&P::radius, -1), "radius");
  EXPECT_EQ(key(&P::line_mass, 0), "line_mass");
  EXPECT_EQ(key(&P::pressure, 0), "pressure");
  EXPECT_EQ(key(&P::gas_density, 0), "gas_density");
  EXPECT_EQ(key(&P::gamma, 1), "gamma");
  EXPECT_EQ(key(&P::velocity, std::nan("")), "velocity");
  const GasRing ring{P{}};
  EXPECT_EQ(refused_key([&] { ring.omega(0); }), "mode");
  EXPECT_EQ(refused_key([&] { ring.omega(1001); }), "mode");
  EXPECT_EQ(refused_key([&] { ring.shape(1.5); }), "radius");
  EXPECT_EQ(refused_key([&] { ring.displacement(-1); }), "time");
}

}  // namespace
}  // namespace plumbline::reference::gas_ring_test
