// Gas at rest in a closed membrane.
#include "reference/membrane_equilibrium.hpp"

#include "reference/circle.hpp"
#include "reference/gas_ring.hpp"
#include "tests/reference/checks.hpp"

namespace plumbline::reference::membrane_equilibrium_test {
namespace {

using Problem = MembraneEquilibriumProblem;

Problem york(double length, double gas_energy = 0.47463 * 250) {
  Problem p;
  p.length = length;
  p.gas_energy = gas_energy;
  return p;
}

/// A soft membrane: strains of order one, where the laws differ.
Problem soft(MembraneLaw law) {
  Problem p{120, 0.5, 1.6, 1.7, 900, -0.2, 0.07, 2.5, 11};
  p.law = law;
  return p;
}

TEST(MembraneEquilibrium, YorksBag) {  // separate solutions, half of the last digit given
  const MembraneState deck = MembraneEquilibrium(york(2.19919)).state();
  expect_near(deck.radius, 1.4006, 5e-5);
  expect_near(deck.pressure, 30.801, 5e-4);
  expect_near(deck.stress, 431.40, 5e-3);
  expect_near(deck.strain, 3.9e-4, 5e-6);
  const MembraneState by_mass = MembraneEquilibrium(york(2.187)).state();
  expect_near(by_mass.radius, 1.393, 5e-4);
  expect_near(by_mass.pressure, 31.1, 5e-2);
  expect_near(by_mass.stress, 433.5, 0.5);
  const MembraneState outline = MembraneEquilibrium(york(2.118, 0.533 * 250)).state();
  expect_near(outline.radius, 1.3489, 1e-4);
  expect_near(outline.pressure, 37.3, 5e-2);
  expect_near(outline.stress, 503, 0.5);
}

TEST(MembraneEquilibrium, IsentropicEnd) {
  const MembraneState cold = MembraneEquilibrium(york(2.19919)).isentropic();
  // 19.26 is that of the unstretched bag of R = 1.4; the equilibrium's radius is 2.8e-4 larger, its pressure 2.8 times that
  expect_near(cold.pressure, 19.26 * (1 - 2.8 * 2.8e-4), 5e-3);
  expect_near(cold.radius, 1.4004, 5e-5);
}

TEST(MembraneEquilibrium, FirstLawAndBalance) {  // [York 5.12]
  for (MembraneLaw law : {MembraneLaw::segments, MembraneLaw::accumulated}) {
    for (int n : {0, 1, 2, 7, 300}) {
      const Problem p = soft(law);
      const MembraneEquilibrium bag(p);
      const MembraneState s = bag.state(n);
      expect_zero(s.gas_energy + s.membrane_energy + p.lost - p.gas_energy, 120, "first law");
      expect_zero(s.pressure * s.area - (Bounded(p.gamma) - 1.0) * s.gas_energy, 100, "gas");
      expect_zero(s.tension * s.length - Bounded(2) * s.pressure * s.area, 100, "virial");
      const double stretch = s.length.value / p.length, modulus = 900 / (1 - 0.04);
      const double strain = law == MembraneLaw::segments ? stretch - 1 : std::log(stretch);
      EXPECT_NEAR(s.strain.value, strain, 1e-14);
      EXPECT_NEAR(s.stress.value, modulus * strain, 1e-11);
      EXPECT_GT(strain, 0.2);
      // accumulated: the stress acts in the constant volume t L spread over the stretched length
      EXPECT_NEAR(s.tension.value, modulus * strain * 0.07 / (law == MembraneLaw::segments ? 1 : stretch),
                  1e-12 * modulus);
    }
  }
}

TEST(MembraneEquilibrium, VirialIdentity) {  // stress V = 2 (gamma - 1) U, with the stretch for segments
  const MembraneEquilibrium summed(soft(MembraneLaw::accumulated)), chords(soft(MembraneLaw::segments));
  expect_zero(summed.virial_stress() - summed.state().stress, 100, "accumulated");
  const MembraneState s = chords.state();
  expect_zero(chords.virial_stress() - s.stress * (Bounded(1) + s.strain), 100, "segments");
  expect_near(MembraneEquilibrium(york(2.19919)).virial_stress(), 431.57, 5e-3);
}

TEST(MembraneEquilibrium, EachVertexIsAtRest) {  // two chords pull, half the pressure on each of them pushes
  for (int n : {1, 2, 5, 12}) {
    const MembraneState s = MembraneEquilibrium(soft(MembraneLaw::segments)).state(n);
    const double theta = pi.value / (2 * n), r = s.radius.value;
    const double x[] = {r * std::cos(theta), r, r * std::cos(theta)},
                 y[] = {-r * std::sin(theta), 0, r * std::sin(theta)};
    double push = 0, pull = 0, area = 0, length = 0;
    for (int side : {0, 1}) {
      const double dx = x[side + 1] - x[side], dy = y[side + 1] - y[side], chord = std::hypot(dx, dy);
      push += 0.5 * s.pressure.value * dy;  // outward normal times length: (dy, -dx)
      pull += s.tension.value * (x[1] - x[side == 0 ? 0 : 2]) / chord;
      area += 0.25 * n * (x[side] * y[side + 1] - x[side + 1] * y[side]);
      length = n * chord;
    }
    EXPECT_NEAR(push, pull, 1e-12 * push) << n;
    EXPECT_NEAR(s.area.value, area, 1e-13 * area);
    EXPECT_NEAR(s.length.value, length, 1e-13 * length);
    EXPECT_NEAR(s.apothem.value, r * std::cos(0.5 * theta), 1e-14 * r);
  }
}

TEST(MembraneEquilibrium, ManyChordsAreTheCircle) {  // 1/cos(pi/(4n)) - 1 = (pi/4n)^2/2 in the pressure, and less in R
  const MembraneEquilibrium bag(york(2.19919));
  const MembraneState round = bag.state();
  for (int n : {20, 200, 2000}) {
    const double share = std::pow(pi.value / (4 * n), 2);
    const MembraneState s = bag.state(n);
    EXPECT_NEAR(s.radius.value / round.radius.value - 1, share / 6, share * share + 1e-14);
    EXPECT_NEAR(s.pressure.value / round.pressure.value - 1, share / 3, share * share + 1e-14);
    EXPECT_EQ(s.strain.value, round.strain.value);  // the shape does not enter
  }
}

double other_energy(const Problem& p, int n, double radius, double gas, double area) {
  const double half = pi.value / (4 * std::max(n, 1)),
               modulus = p.youngs_modulus / (1 - p.poisson_ratio * p.poisson_ratio);
  const double length = n == 0 ? pi.value / 2 * radius : 2 * n * std::sin(half) * radius;
  const double now = n == 0 ? pi.value / 4 * radius * radius : n * std::sin(half) * std::cos(half) * radius * radius;
  const double strain = p.law == MembraneLaw::segments ? length / p.length - 1 : std::log(length / p.length);
  return 0.5 * modulus * p.thickness * p.length * strain * strain + gas * std::pow(area / now, p.gamma - 1);
}

// The energy of membrane and adiabatic gas as a function of the radius alone: least at the end, its curvature M w^2.
TEST(MembraneEquilibrium, EnergyIsLeastAndItsCurvatureIsTheBreathing) {
  for (MembraneLaw law : {MembraneLaw::segments, MembraneLaw::accumulated}) {
    for (int n : {0, 1, 6}) {
      const Problem p = soft(law);
      const MembraneEquilibrium bag(p);
      const MembraneState s = bag.state(n);
      auto energy = [&](double r) { return other_energy(p, n, r, s.gas_energy.value, s.area.value); };
      const double r = s.radius.value, h = 1e-4 * r;
      EXPECT_NEAR((energy(r + h) - energy(r - h)) / (2 * h), 0,
                  1e-5 * p.gas_energy / r);  // h^2/6 of the third derivative
      const double curvature = (energy(r + h) - 2 * energy(r) + energy(r - h)) / (h * h);
      const double omega = std::sqrt(curvature / bag.membrane_mass().value);
      EXPECT_NEAR(s.breathing_omega.value, omega,
                  1e-5 * omega);  // rounding 1e-16 100/h^2, h^2 of the fourth derivative
      EXPECT_NEAR(s.breathing_period.value, 2 * pi.value / s.breathing_omega.value, 1e-14);
    }
  }
}

TEST(MembraneEquilibrium, BreathesAsTheRingAroundAGas) {
  for (MembraneLaw law : {MembraneLaw::segments, MembraneLaw::accumulated}) {
    const Problem p = soft(law);
    const MembraneEquilibrium bag(p);
    const MembraneState s = bag.state();
    const double stretch = s.length.value / p.length;
    const bool chords = law == MembraneLaw::segments;
    GasRingProblem ring{p.youngs_modulus, p.poisson_ratio, p.thickness / (chords ? 1 : stretch), s.radius.value};
    ring.line_mass = bag.membrane_mass().value / s.length.value;
    ring.pressure = s.pressure.value;
    ring.gamma = p.gamma;
    ring.law = chords ? RingLaw::segments : RingLaw::accumulated;
    const GasRing other(ring);
    EXPECT_NEAR(other.quasi_static_omega().value, s.breathing_omega.value, 1e-12 * s.breathing_omega.value);
    EXPECT_NEAR(other.dry_omega().value, s.dry_omega.value, 1e-12 * s.breathing_omega.value);
    EXPECT_NEAR(other.strain().value, s.strain.value, 1e-13);
    EXPECT_NEAR(other.unstretched_radius().value, p.length * 2 / pi.value, 1e-13);
  }
  expect_near(MembraneEquilibrium(york(2.19919)).state().breathing_period, 0.006, 5e-4);
}

TEST(MembraneEquilibrium, IsentropicEndKeepsTheEntropyAndRests) {
  for (MembraneLaw law : {MembraneLaw::segments, MembraneLaw::accumulated}) {
    for (int n : {0, 3}) {
      Problem p = soft(law);
      p.lost = 0;
      const MembraneState s = MembraneEquilibrium(p).isentropic(n);
      const double start = (p.gamma - 1) * p.gas_energy * std::pow(p.gas_area, p.gamma - 1);
      EXPECT_NEAR(s.pressure.value * std::pow(s.area.value, p.gamma), start, 1e-12 * start);
      expect_zero(s.tension * s.length - Bounded(2) * s.pressure * s.area, 100, "virial");
      EXPECT_LT(s.radius.value, MembraneEquilibrium(p).state(n).radius.value);  // heat drives the membrane out
    }
  }
}

TEST(MembraneEquilibrium, WhatIsLostHeatsNothing) {
  Problem p = york(2.19919);
  p.lost = 3.6;
  Problem less = york(2.19919, p.gas_energy - 3.6);
  expect_same(MembraneEquilibrium(p).state().stress, MembraneEquilibrium(less).state().stress);
  // to first order in the strain the stress goes as the energy left
  const double share = MembraneEquilibrium(p).state().stress.value / 431.4036;
  EXPECT_NEAR(share, 1 - 3.6 / 118.6575, 1e-4);
}

TEST(MembraneEquilibriumProblem, WrongProblemsAreRefusedByKey) {
  const auto key = refused_value<MembraneEquilibrium, Problem>;
  EXPECT_EQ(key(&Problem::gas_energy, 0), "gas_energy");
  EXPECT_EQ(key(&Problem::gas_area, 0), "gas_area");
  EXPECT_EQ(key(&Problem::gamma, 1), "gamma");
  EXPECT_EQ(key(&Problem::length, 0), "length");
  EXPECT_EQ(key(&Problem::youngs_modulus, -1), "youngs_modulus");
  EXPECT_EQ(key(&Problem::poisson_ratio, -0.5), "poisson_ratio");
  EXPECT_EQ(key(&Problem::thickness, 0), "thickness");
  EXPECT_EQ(key(&Problem::density, 0), "density");
  EXPECT_EQ(key(&Problem::lost, 119), "lost");
  EXPECT_EQ(key(&Problem::lost, -1), "lost");
  EXPECT_EQ(refused_key([] { MembraneEquilibrium(Problem{}).state(-1); }), "segments");
}

}  // namespace
}  // namespace plumbline::reference::membrane_equilibrium_test
