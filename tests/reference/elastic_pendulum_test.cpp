// The elastic pendulum: York's problem, the rigid limit [Landau 11.1], published amplitudes, equation of motion,
// energy.
#include "reference/elastic_pendulum.hpp"

#include <gsl/gsl_sf_ellint.h>

#include "reference/circle.hpp"
#include "tests/reference/checks.hpp"

namespace plumbline::reference::elastic_pendulum_test {
namespace {

constexpr double degree = 0.017453292519943295769;

ElasticPendulumProblem soft() {
  ElasticPendulumProblem p = pendulum_at(1.7, 0.8);
  p.mass = 2;
  p.gravity = 9.81;
  p.youngs_modulus = 700;
  p.area = 0.5;  // E A/(m g) = 17.8
  return p;
}

TEST(RigidPendulum, IsGslsEllipticIntegral) {  // [Landau 11.1]
  for (double angle : {0.01, 0.3, -1.0, 1.5, 2.9}) {
    const Bounded period = rigid_pendulum_period(0.73, 20.0, angle);
    const double k = std::abs(std::sin(angle / 2)),
                 other = 4 * std::sqrt(0.73 / 20) * gsl_sf_ellint_Kcomp(k, GSL_PREC_DOUBLE);
    EXPECT_NEAR(period.value, other, 1e-13 * other);
    EXPECT_LE(period.bound, 1e-12 * period.value);
  }
}

// Ratio to 2 pi sqrt(L/g) by amplitude: R. A. Nelson, M. G. Olsson, Am. J. Phys. 54 (1986) 112, table I, and handbooks.
TEST(RigidPendulum, PublishedAmplitudes) {  // [Landau 11.1]
  auto ratio = [](double degrees) { return rigid_pendulum_period(1.0, 1.0, degrees * degree) / (Bounded(2) * pi); };
  expect_near(ratio(10), 1.00191, 5e-6);
  expect_near(ratio(30), 1.01741, 5e-6);
  expect_near(ratio(60), 1.07318, 5e-6);
  expect_near(ratio(90), 1.18034, 5e-6);
}

TEST(ElasticPendulum, YorksGeometry) {  // from his input: 18.437 degrees, 0.7346
  const ElasticPendulum york{ElasticPendulumProblem{}};
  expect_near(york.angle() / degree, -18.437, 5e-4);
  expect_near(york.rest_length(), 0.7346, 1e-5);
  expect_near(york.axial_omega(), 203.1, 0.05);  // sqrt(1e6 0.1/(0.73461 3.3))
  expect_near(york.rigid_period(), 1.21202, 5e-6);
  EXPECT_LE(york.period().bound, 1e-10);
}

TEST(ElasticPendulum, SizesOfYorksTable) {  // 19.8 degrees, 0.73: rigid 1.20942
  const ElasticPendulum table(pendulum_at(0.73, 19.8 * degree));
  expect_near(table.rigid_period(), 1.20942, 5e-6);
  EXPECT_NEAR(table.period().value, 1.20987, 5e-5);  // an RK4 computation elsewhere, its last digits unsure
}

TEST(ElasticPendulum, BecomesRigidAsTheStringHardens) {  // [Landau 11.1]
  for (double angle : {0.2, -0.9, 1.4}) {
    for (double kappa : {1e4, 1e6}) {
      ElasticPendulumProblem p = pendulum_at(2.5, angle);
      p.youngs_modulus = kappa * p.mass * p.gravity / p.area;
      const ElasticPendulum pendulum(p);
      const double rigid = pendulum.rigid_period().value;
      // the mean stretch is between cos(angle)/kappa and (3 - 2 cos(angle))/kappa, the axial swing adds to its root
      EXPECT_NEAR(pendulum.period().value / rigid, 1, 3 / kappa);
      EXPECT_GT(pendulum.period().value, rigid);
      EXPECT_NEAR(pendulum.crossing(1).value / rigid, 0.25, 3 / kappa);
      EXPECT_NEAR(pendulum.amplitude_ratio().value, 1, 3 / kappa);
    }
  }
}

TEST(ElasticPendulum, SmallSwingsOfAStringAtRest) {  // 2 pi sqrt(L0 (1 + 1/kappa)/g), and angle^2/16 more
  ElasticPendulumProblem p = pendulum_at(1.25, 1e-4);
  p.youngs_modulus = 20 * p.mass * p.gravity / p.area;
  p.strain = 1.0 / 20;
  const ElasticPendulum pendulum(p);
  const double expected = 2 * pi.value * std::sqrt(1.25 / p.gravity);
  EXPECT_NEAR(pendulum.period().value, expected, 1e-8 * expected);
  EXPECT_NEAR(pendulum.at(0.3).tension.value, p.mass * p.gravity, 1e-7 * p.mass * p.gravity);
}

TEST(ElasticPendulum, KeepsItsEnergy) {
  ElasticPendulumProblem stretched = soft();
  stretched.strain = 0.09;
  for (ElasticPendulumProblem p : {ElasticPendulumProblem{}, soft(), stretched}) {
    for (bool one_way : {true, false}) {
      p.one_way = one_way;
      const ElasticPendulum pendulum(p);
      const Bounded k = pendulum.stiffness(), m(p.mass), half(0.5);
      auto energy = [&](const PendulumState& s) {
        Bounded stretch = s.length - pendulum.rest_length();
        if (one_way && stretch.value < 0) stretch = {0, stretch.bound};
        return half * m * (s.velocity_x * s.velocity_x + s.velocity_y * s.velocity_y) +
               m * p.gravity * (s.y - p.pivot_y) + half * k * stretch * stretch;
      };
      const double times[] = {0, 0.05, 0.3, 0.31, 1, 2.2};
      const std::vector<PendulumState> states = pendulum.at(times);
      const double scale = p.mass * p.gravity * pendulum.rest_length().value;
      for (const PendulumState& s : states) expect_zero(energy(s) - energy(states[0]), scale, "energy", 1e-8);
    }
  }
}

TEST(ElasticPendulum, ObeysNewton) {
  ElasticPendulumProblem slack = soft();
  slack.strain = 0.09;  // goes slack on its way back
  for (const ElasticPendulumProblem& p : {ElasticPendulumProblem{}, soft(), slack}) {
    const ElasticPendulum pendulum(p);
    const double h = 1e-4 / pendulum.axial_omega().value;
    for (double t : {0.02, 0.4, 0.77, 1.3}) {
      const double times[] = {t - h, t, t + h};
      const std::vector<PendulumState> s = pendulum.at(times);
      const double along_x = (p.pivot_x - s[1].x.value) / s[1].length.value;
      const double along_y = (p.pivot_y - s[1].y.value) / s[1].length.value;
      const double ax = (s[2].velocity_x.value - s[0].velocity_x.value) / (2 * h);
      const double ay = (s[2].velocity_y.value - s[0].velocity_y.value) / (2 * h);
      const double weight = p.mass * p.gravity;
      // truncation (w h)^2/6 = 2e-9 of the axial force, rounding over 2 h: 1e-13/(w h)
      EXPECT_NEAR(p.mass * ax, s[1].tension.value * along_x, 1e-7 * weight);
      EXPECT_NEAR(p.mass * ay, s[1].tension.value * along_y - weight, 1e-7 * weight);
      EXPECT_NEAR((s[2].x.value - s[0].x.value) / (2 * h), s[1].velocity_x.value, 1e-7);
      EXPECT_NEAR((s[2].y.value - s[0].y.value) / (2 * h), s[1].velocity_y.value, 1e-7);
      const double pull = std::max(0.0, (pendulum.stiffness() * (s[1].length - pendulum.rest_length())).value);
      EXPECT_NEAR(s[1].tension.value, pull, 1e-9 * pendulum.stiffness().value * pendulum.rest_length().value);
    }
  }
}

TEST(ElasticPendulum, TurningPointsAndCrossingsAreWhereTheyAreSaidToBe) {
  for (const ElasticPendulumProblem& p : {ElasticPendulumProblem{}, soft()}) {
    const ElasticPendulum pendulum(p);
    const std::vector<PendulumExtreme> turns = pendulum.extremes(3);
    const std::vector<Bounded> passes = pendulum.crossings(3);
    ASSERT_EQ(turns.size(), 4u);
    EXPECT_EQ(turns[0].time.value, 0);
    EXPECT_EQ(turns[0].angle.value, pendulum.angle().value);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_LT(turns[i].time.value, passes[i].value);
      EXPECT_LT(passes[i].value, turns[i + 1].time.value);
      EXPECT_LT(turns[i].angle.value * turns[i + 1].angle.value, 0);
      const PendulumState at_pass = pendulum.at(passes[i].value), at_turn = pendulum.at(turns[i + 1].time.value);
      EXPECT_NEAR(at_pass.angle.value, 0, 1e-9);
      EXPECT_NEAR(at_turn.angle.value, turns[i + 1].angle.value, 1e-9);
      const double momentum = (at_turn.x.value - p.pivot_x) * at_turn.velocity_y.value -
                              (at_turn.y.value - p.pivot_y) * at_turn.velocity_x.value;
      EXPECT_NEAR(momentum, 0, 1e-8);
    }
    EXPECT_EQ(pendulum.period().value, turns[2].time.value);
  }
}

TEST(ElasticPendulum, OneWayMattersOnlyWhereTheStringGoesSlack) {
  ElasticPendulumProblem p;
  p.one_way = false;
  EXPECT_EQ(ElasticPendulum(p).period().value, ElasticPendulum{ElasticPendulumProblem{}}.period().value);
  ElasticPendulumProblem slack = soft(), both = soft();
  slack.strain = both.strain = 0.09;
  both.one_way = false;
  EXPECT_GT(std::abs(ElasticPendulum(slack).at(1.5).x.value - ElasticPendulum(both).at(1.5).x.value), 1e-4);
}

// A uniform rigid rod with the bob at its end: moment of inertia m L^2 (1 + mu/3), moment of weight m g L (1 + mu/2).
TEST(ElasticPendulum, OwnMassOfTheStringMakesItFaster) {
  const ElasticPendulum york{ElasticPendulumProblem{}};
  expect_near(york.string_mass_ratio(), 0.01 * 0.73460659 / 3.3, 1e-9);
  const double mu = york.string_mass_ratio().value;
  EXPECT_NEAR(york.string_factor().value, 1 - mu / 12, mu * mu);
  EXPECT_LE(york.heavy_period().bound, 1e-5 * york.heavy_period().value);  // 1 % of a gate of 0.1 %
  EXPECT_EQ(york.heavy_period().value, york.period().value * york.string_factor().value);
  ElasticPendulumProblem none;
  none.density = 0;
  EXPECT_EQ(ElasticPendulum(none).string_factor().value, 1);
  EXPECT_EQ(ElasticPendulum(none).string_factor().bound, 0);
}

// Twice what the rigid rod leaves out, by the source's estimates: the energy of the sag, mu^2/90/cos(p)^2; the swing about
// it, mu^1.5/(12 pi^2)/cos(p) at either end; half of the stretch s, of which the share mu is the string's; the axial swing
// of amplitude s, whose phase w T = 2 pi sqrt(kappa) changes by mu w T/6 or, where that is above 2, is unknown.
TEST(ElasticPendulum, BoundOfTheStringsOwnMass) {
  struct Own {
    double mu, kappa, strain;
  };
  for (const auto& [mu, kappa, strain] :
       {Own{0.02, 1e9, 0}, Own{0.02, 1e6, 0.05}, Own{1e-3, 12, 0}, Own{1e-3, 400, -0.04}}) {
    for (double angle : {0.3, -1.1}) {
      ElasticPendulumProblem p = pendulum_at(2.0, angle);
      p.density = mu * p.mass * (1 + strain) / (p.area * 2.0);
      p.youngs_modulus = kappa * p.mass * p.gravity / p.area;
      p.strain = strain;
      const double steep = 1 / std::cos(angle), turn = 2 * pi.value * std::sqrt(kappa),
                   s = 1 / kappa + std::abs(strain);
      const double sag = mu * mu / 90 * steep * steep, swing = std::pow(mu, 1.5) / (6 * pi.value * pi.value) * steep;
      const double axial = std::min(2.0, mu * turn / 6) * s / turn, left_out = sag + swing + mu * s / 2 + axial;
      EXPECT_NEAR(ElasticPendulum(p).string_factor().bound, 2 * left_out, 1e-6 * left_out) << mu << " " << kappa;
    }
  }
}

TEST(ElasticPendulumProblem, WrongProblemsAreRefusedByKey) {
  const auto key = refused_change<ElasticPendulum, ElasticPendulumProblem>;
  EXPECT_EQ(key([](ElasticPendulumProblem& p) { p.bob_y = 2; }), "bob_y");
  EXPECT_EQ(key([](ElasticPendulumProblem& p) { p.bob_x = p.pivot_x; }), "bob_x");
  EXPECT_EQ(key([](ElasticPendulumProblem& p) { p.mass = 0; }), "mass");
  EXPECT_EQ(key([](ElasticPendulumProblem& p) { p.gravity = -1; }), "gravity");
  EXPECT_EQ(key([](ElasticPendulumProblem& p) { p.youngs_modulus = 100; }), "youngs_modulus");
  EXPECT_EQ(key([](ElasticPendulumProblem& p) { p.area = 0; }), "area");
  EXPECT_EQ(key([](ElasticPendulumProblem& p) { p.density = -1; }), "density");
  EXPECT_EQ(key([](ElasticPendulumProblem& p) { p.strain = 0.2; }), "strain");
  const ElasticPendulum york{ElasticPendulumProblem{}};
  EXPECT_EQ(refused_key([&] { york.at(-1); }), "time");
  EXPECT_EQ(refused_key([&] { york.at(1e9); }), "time");
  EXPECT_EQ(refused_key([&] { york.extreme(-1); }), "n");
  EXPECT_EQ(refused_key([&] { york.crossing(0); }), "n");
}

}  // namespace
}  // namespace plumbline::reference::elastic_pendulum_test
