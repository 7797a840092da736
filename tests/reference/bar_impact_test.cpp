// Two equal bars meet: contact for 2 L/c under -rho c v/2, restitution 1.
#include "reference/bar_impact.hpp"

#include "tests/reference/checks.hpp"

namespace plumbline::reference::bar_impact_test {
namespace {

const BarImpactProblem other{2e11, 7800, 1e-4, 0.3, -2, 0.01, 3, -1.5};
constexpr ImpactBar bars[] = {ImpactBar::left, ImpactBar::right};

double start_of(const BarImpactProblem& p, ImpactBar bar) {
  return bar == ImpactBar::left ? p.left : p.left + p.length + p.gap;
}

TEST(BarImpact, YorksBarsInOneDimension) {  // E 1e5, rho 1, L 1.25, v = 2, gap 0.5
  const BarImpact impact{BarImpactProblem{}};
  expect_near(impact.contact_time(), 0.25, 1e-12);
  expect_near(impact.contact_duration(), 0.00791, 5e-6);
  expect_near(impact.contact_stress(), -316.2, 0.05);
  BarImpactProblem wide;  // plane stress: E/(1 - nu^2), nu = 0.3
  wide.youngs_modulus = 1e5 / 0.91;
  wide.velocity_left = 20;
  expect_near(BarImpact(wide).contact_duration(), 0.00754, 5e-6);
  expect_near(BarImpact(wide).contact_stress(), -3314.6, 0.5);
}

// W. Goldsmith, Impact, 1960, section 3.2, and every text on waves: steel rods, stress rho c v/2.
TEST(BarImpact, SteelRods) {
  const BarImpact impact(other);
  const double c = std::sqrt(2e11 / 7800);
  EXPECT_NEAR(impact.contact_duration().value, 0.6 / c, 1e-18);
  EXPECT_NEAR(impact.contact_stress().value, -7800 * c * 2.25, 1e-6);
  EXPECT_EQ(impact.velocity_after(ImpactBar::left).value, -1.5);
  EXPECT_EQ(impact.velocity_after(ImpactBar::right).value, 3);
}

TEST(BarImpact, BarsTouchDuringContactAndAtNoOtherTime) {
  for (const BarImpactProblem& p : {BarImpactProblem{}, other}) {
    const BarImpact impact(p);
    const double from = impact.contact_time().value, lasts = impact.contact_duration().value;
    auto distance = [&](double t) {
      return (Bounded(p.gap) + impact.state(ImpactBar::right, start_of(p, ImpactBar::right), t).displacement -
              impact.state(ImpactBar::left, p.left + p.length, t).displacement);
    };
    for (double share : {0.1, 0.5, 0.9}) expect_zero(distance(from + share * lasts), p.gap, "touching", 1e-9);
    for (double share : {-5.0, -0.2, 1.2, 9.0}) EXPECT_GT(distance(from + share * lasts).value, 0) << share;
  }
}

TEST(BarImpact, StressAndVelocityBehindTheFronts) {
  for (const BarImpactProblem& p : {BarImpactProblem{}, other}) {
    const BarImpact impact(p);
    const double from = impact.contact_time().value, lasts = impact.contact_duration().value;
    const double mean = 0.5 * (p.velocity_left + p.velocity_right), stress = impact.contact_stress().value;
    for (ImpactBar bar : bars) {
      const double away = bar == ImpactBar::left ? -1 : 1;
      auto at = [&](double share_of_bar, double share_of_time) {  // share of the bar from the contact
        const double x = start_of(p, ImpactBar::left) + p.length + away * share_of_bar * p.length +
                         (bar == ImpactBar::right ? p.gap : 0);
        return impact.state(bar, x, from + share_of_time * lasts);
      };
      const double own = bar == ImpactBar::left ? p.velocity_left : p.velocity_right;
      const double others = p.velocity_left + p.velocity_right - own;
      const double margin = 1e-9 * std::abs(stress);
      EXPECT_NEAR(at(0.3, 0.2).stress.value, stress, margin);  // front out at 0.4
      EXPECT_NEAR(at(0.3, 0.2).velocity.value, mean, 1e-9);
      EXPECT_NEAR(at(0.5, 0.2).stress.value, 0, margin);
      EXPECT_NEAR(at(0.5, 0.2).velocity.value, own, 1e-9);
      EXPECT_NEAR(at(0.3, 0.8).stress.value, stress, margin);  // front back at 0.4
      EXPECT_NEAR(at(0.5, 0.8).velocity.value, others, 1e-9);
      EXPECT_NEAR(at(0.3, 1.1).velocity.value, others, 1e-9);
      EXPECT_NEAR(at(0.3, 1.1).stress.value, 0, margin);
    }
  }
}

TEST(BarImpact, DisplacementIsContinuousAtContactAndRelease) {
  for (const BarImpactProblem& p : {BarImpactProblem{}, other}) {
    const BarImpact impact(p);
    for (double edge : {impact.contact_time().value, impact.release_time().value}) {
      for (ImpactBar bar : bars) {
        const double x = start_of(p, bar) + 0.37 * p.length, step = 1e-9 * edge;
        const BarState before = impact.state(bar, x, edge - step), at = impact.state(bar, x, edge),
                       after = impact.state(bar, x, edge + step);
        EXPECT_NEAR(before.displacement.value, after.displacement.value, 8 * step);
        EXPECT_NEAR(before.displacement.value, at.displacement.value, 8 * step);
      }
    }
  }
}

TEST(BarImpact, HalfOfTheRelativeEnergyIsElasticHalfWay) {
  const BarImpact impact(other);
  const double half = impact.contact_time().value + 0.5 * impact.contact_duration().value;
  const double relative = 0.25 * 7800 * 1e-4 * 0.3 * 4.5 * 4.5;  // kinetic energy in the frame of the centre of mass
  EXPECT_NEAR(impact.strain_energy(half).value, relative, 1e-9 * relative);
  EXPECT_EQ(impact.strain_energy(0).value, 0);
  EXPECT_EQ(impact.strain_energy(10 * half).value, 0);
  const double start = 0.5 * 7800 * 1e-4 * 0.3 * (9 + 2.25);
  for (double t : {0.0, half, 1.3 * half}) {
    EXPECT_NEAR((impact.kinetic_energy(t) + impact.strain_energy(t)).value, start, 1e-12 * start);
  }
  expect_near(impact.centre_of_mass_velocity(), 0.75, 1e-12);
}

TEST(BarImpactProblem, WrongProblemsAreRefusedByKey) {
  const auto key = refused_change<BarImpact, BarImpactProblem>;
  EXPECT_EQ(key([](BarImpactProblem& p) { p.youngs_modulus = 0; }), "youngs_modulus");
  EXPECT_EQ(key([](BarImpactProblem& p) { p.density = 0; }), "density");
  EXPECT_EQ(key([](BarImpactProblem& p) { p.length = -1; }), "length");
  EXPECT_EQ(key([](BarImpactProblem& p) { p.gap = -1; }), "gap");
  EXPECT_EQ(key([](BarImpactProblem& p) { p.velocity_right = 2; }), "velocity_left");
  EXPECT_EQ(refused_key([] { BarImpact({}).state(ImpactBar::left, 2.5, 0); }), "position");
  EXPECT_EQ(refused_key([] { BarImpact({}).state(ImpactBar::right, 2.5, 0); }), "position");
}

}  // namespace
}  // namespace plumbline::reference::bar_impact_test
