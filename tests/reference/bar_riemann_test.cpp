// d'Alembert in a finite bar: the Riemann problem, reflections, conservation, and modes put together from pieces.
#include "reference/bar_riemann.hpp"

#include "reference/bar_vibration.hpp"
#include "tests/reference/checks.hpp"

namespace plumbline::reference::bar_riemann_test {
namespace {

/// c = 2, rho c = 6, on [-1, 2].
BarRiemannProblem bar_of_three(BarEnd left, BarEnd right) {
  return {12, 3, 0.5, -1, 3, left, right, {{-1, 0.4, -2}, {0.1, -1.1, 5}, {1.3, 0.7, 0.5}}};
}

constexpr BarEnd ends[] = {BarEnd::free, BarEnd::fixed};

TEST(BarRiemann,
     StateBetweenTheWaves) {  // v* = (v1 + v2)/2 + (s2 - s1)/(2 rho c), s* = (s1 + s2)/2 + rho c (v2 - v1)/2
  BarRiemannProblem p = bar_of_three(BarEnd::free, BarEnd::free);
  p.pieces = {{-1, 0.4, -2}, {0.5, -1.1, 5}};
  const BarRiemann bar(p);
  expect_near(bar.wave_speed(), 2, 1e-11);
  expect_near(bar.impedance(), 6, 1e-11);
  for (double x : {0.11, 0.5, 0.89}) {  // fronts at 0.5 -+ 0.4
    const BarState s = bar.state(x, 0.2);
    expect_near(s.velocity, (0.4 - 1.1) / 2 + 7.0 / 12, 1e-11);
    expect_near(s.stress, 1.5 + 3 * -1.5, 1e-10);
  }
  expect_near(bar.state(0.09, 0.2).velocity, 0.4, 1e-11);
  expect_near(bar.state(0.91, 0.2).stress, 5, 1e-10);
}

TEST(BarRiemann, StartsAsToldWithTheRightValueAtAJump) {
  const BarRiemann bar(bar_of_three(BarEnd::free, BarEnd::fixed));
  EXPECT_EQ(bar.state(-1, 0).stress.value, -2);
  EXPECT_EQ(bar.state(0.1, 0).velocity.value, -1.1);
  EXPECT_EQ(bar.state(0.0999, 0).velocity.value, 0.4);
  EXPECT_EQ(bar.state(2, 0).stress.value, 0.5);
  EXPECT_EQ(bar.state(0.1, 0).velocity.bound, 0);
}

TEST(BarRiemann, EndsKeepTheirConditions) {
  for (BarEnd left : ends) {
    for (BarEnd right : ends) {
      const BarRiemann bar(bar_of_three(left, right));
      for (double t : {0.013, 0.41, 1.7, 2.9, 7.77, 20.3}) {
        const BarState at_left = bar.state(-1, t), at_right = bar.state(2, t);
        expect_zero(left == BarEnd::free ? at_left.stress : at_left.velocity, 5, "left", 1e-10);
        expect_zero(right == BarEnd::free ? at_right.stress : at_right.velocity, 5, "right", 1e-10);
      }
    }
  }
}

TEST(BarRiemann, RepeatsWithTheTransitTimes) {  // free: 2 L/c; one fixed end: turned after 2 L/c, the same after 4
  for (BarEnd left : ends) {
    for (BarEnd right : ends) {
      const BarRiemann bar(bar_of_three(left, right));
      const double cycle = 2 * bar.transit_time().value, sign = left == right ? 1 : -1;
      for (double x : {-0.7, 0.33, 1.6}) {
        for (double t : {0.05, 0.61}) {
          const BarState first = bar.state(x, t), next = bar.state(x, t + cycle), late = bar.state(x, t + 50 * cycle);
          expect_same(next.velocity, Bounded(sign) * first.velocity);
          expect_same(next.stress, Bounded(sign) * first.stress);
          expect_same(late.velocity, first.velocity);
          EXPECT_LE(late.displacement.bound, 1e-11);
        }
      }
    }
  }
}

TEST(BarRiemann, EnergyAndMomentumAreConserved) {
  for (BarEnd left : ends) {
    for (BarEnd right : ends) {
      const BarRiemannProblem p = bar_of_three(left, right);
      const BarRiemann bar(p);
      for (double t : {0.01, 0.37, 1.23, 4.9}) {
        double energy = 0, momentum = 0;  // piecewise constant: midpoints err in the cells of the fronts alone
        const int n = 20000;
        for (int i = 0; i < n; ++i) {
          const BarState s = bar.state(-1 + 3 * (i + 0.5) / n, t);
          const double v = s.velocity.value, stress = s.stress.value, volume = p.area * 3 / n;
          energy += 0.5 * (p.density * v * v + stress * stress / p.youngs_modulus) * volume;
          momentum += p.density * v * volume;
        }
        EXPECT_NEAR(energy, bar.energy().value, 1e-3 * bar.energy().value);
        const bool both_free = left == BarEnd::free && right == BarEnd::free;
        EXPECT_TRUE(!both_free || std::abs(momentum - bar.momentum().value) < 1e-3);
      }
    }
  }
}

TEST(BarRiemann, DisplacementIsTheIntegralOfVelocityAndGivesTheStress) {
  for (BarEnd left : ends) {
    for (BarEnd right : ends) {
      const BarRiemannProblem p = bar_of_three(left, right);
      const BarRiemann bar(p);
      for (double x : {-0.95, 0.2, 1.31}) {
        double moved = 0;
        const int n = 20000;
        const double end = 5.3;
        for (int i = 0; i < n; ++i) moved += bar.state(x, end * (i + 0.5) / n).velocity.value * end / n;
        EXPECT_NEAR(bar.state(x, end).displacement.value, moved, 2e-3);  // a dozen fronts, one cell each
        EXPECT_LE(bar.state(x, end).displacement.bound, 1e-13);
        const double h = 1e-6;  // the stress at the start is there without displacement
        const double strain = (bar.state(x + h, end).displacement - bar.state(x - h, end).displacement).value / (2 * h);
        EXPECT_NEAR(p.youngs_modulus * strain, bar.state(x, end).stress.value - bar.state(x, 0).stress.value, 1e-7);
      }
    }
  }
}

TEST(BarRiemann, ManyPiecesMakeAMode) {  // the fixed and free bar of bar_vibration.hpp, sampled: error of order 1/n
  const BarVibrationProblem mode{100, 1, 1, 25, 0.1, 2};
  const BarVibration exact(mode);
  BarRiemannProblem p{100, 1, 1, 0, 25, BarEnd::fixed, BarEnd::free, {}};
  const int n = 500;
  for (int i = 0; i < n; ++i) p.pieces.push_back({25.0 * i / n, exact.velocity(25 * (i + 0.5) / n, 0).value, 0});
  const BarRiemann bar(p);
  const double k = exact.wavenumber().value, jump = 0.1 * k * 25 / n;
  for (double x : {3.3, 11.1, 24.0}) {
    for (double t : {0.9, 4.4, 13.0}) {
      EXPECT_NEAR(bar.state(x, t).velocity.value, exact.velocity(x, t).value, 2 * jump);
      EXPECT_NEAR(bar.state(x, t).stress.value, exact.stress(x, t).value, 2 * jump * 10);
      EXPECT_NEAR(bar.state(x, t).displacement.value, exact.displacement(x, t).value, 1e-3 * exact.amplitude().value);
    }
  }
}

TEST(BarRiemann, BoundCoversBothSidesOfAFront) {
  const BarRiemann bar({1e5, 1, 1, 0, 1, BarEnd::free, BarEnd::free, {{0, 1, 0}, {0.5, 0, 0}}});
  const double t = 1e-3, front = 0.5 + bar.wave_speed().value * t;
  EXPECT_GE(bar.state(front, t).velocity.bound, 0.5);  // 0.5 behind, 0 ahead
  EXPECT_LE(bar.state(front - 1e-12, t).velocity.bound, 1e-14);
  EXPECT_LE(bar.state(front + 1e-12, t).velocity.bound, 1e-14);
  EXPECT_LE(bar.state(front, t).displacement.bound, 1e-15);
}

TEST(BarRiemannProblem, WrongProblemsAreRefusedByKey) {
  const auto key = refused_change<BarRiemann, BarRiemannProblem>;
  EXPECT_EQ(key([](BarRiemannProblem& p) { p.youngs_modulus = 0; }), "youngs_modulus");
  EXPECT_EQ(key([](BarRiemannProblem& p) { p.density = -1; }), "density");
  EXPECT_EQ(key([](BarRiemannProblem& p) { p.area = 0; }), "area");
  EXPECT_EQ(key([](BarRiemannProblem& p) { p.length = 0; }), "length");
  EXPECT_EQ(key([](BarRiemannProblem& p) { p.left = 0.1; }), "from");
  EXPECT_EQ(key([](BarRiemannProblem& p) { p.pieces.clear(); }), "from");
  EXPECT_EQ(key([](BarRiemannProblem& p) { p.pieces[1].from = 1; }), "from");
  EXPECT_EQ(key([](BarRiemannProblem& p) { p.pieces[0].stress = std::nan(""); }), "stress");
  EXPECT_EQ(refused_key([] { BarRiemann({}).state(1.1, 0.1); }), "position");
  EXPECT_EQ(refused_key([] { BarRiemann({}).state(0.1, -0.1); }), "time");
}

}  // namespace
}  // namespace plumbline::reference::bar_riemann_test
