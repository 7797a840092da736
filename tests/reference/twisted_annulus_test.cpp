// The twisted ring: small twists, equilibrium and energy by differences alone, and what is refused.
#include "reference/twisted_annulus.hpp"

#include "tests/reference/checks.hpp"

namespace plumbline::reference::twisted_annulus_test {
namespace {

TwistedAnnulusProblem ring(double twist) { return {7, 0.1, 0.02, 0.4, 0.75, twist}; }

// Without strain q is g: both integrals are elementary in x = p^2/R^2. Finite twists change them by a share of the twist.
TEST(TwistedAnnulus, SmallTwistsAreTheClassicTensionField) {  // [Annulus 5, 6]
  const double twist = 1e-6;
  const TwistedAnnulus small(ring(twist));
  const double p = small.arm().value, inner = p * p / 0.16, outer = p * p / 0.5625;
  const auto side = [](double x) { return std::log(x / (1 - x)) - 1 / (1 - x); };
  EXPECT_NEAR(side(inner), side(outer), 1e-4);
  const double torque = 4 * M_PI * 0.02 * 7 * p * p * twist / (1 / (1 - inner) - 1 / (1 - outer));
  EXPECT_NEAR(small.torque().value / torque, 1, 1e-4);
  EXPECT_NEAR(small.energy().value / (torque * twist / 2), 1, 1e-4);
}

struct Forces {
  double radial, turning, hoop, moment;  // R P_rR, R theta' P_tR, P_tT, R r P_tR
};

/// From where points stand alone: gradient by differences over h, the larger principal strain and its direction, and its stress E e1.
Forces forces_at(const TwistedAnnulus& ring, double modulus, double R, double h) {
  const AnnulusPoint less = ring.at(R - h), here = ring.at(R), more = ring.at(R + h);
  const double r = here.radius.value, radial = (more.radius.value - less.radius.value) / (2 * h);
  const double turn = (more.turned.value - less.turned.value) / (2 * h);
  const double f[2][2] = {{radial, 0}, {r * turn, r / R}};
  const double first = 0.5 * (f[0][0] * f[0][0] + f[1][0] * f[1][0] - 1), mixed = 0.5 * f[1][0] * f[1][1];
  const double second = 0.5 * (f[1][1] * f[1][1] - 1), angle = 0.5 * std::atan2(2 * mixed, first - second);
  const double strain = 0.5 * (first + second) + std::hypot(0.5 * (first - second), mixed);
  const double n[2] = {std::cos(angle), std::sin(angle)}, stress = modulus * strain;
  const double m[2] = {f[0][0] * n[0], f[1][0] * n[0] + f[1][1] * n[1]};
  return {R * stress * m[0] * n[0], R * turn * stress * m[1] * n[0], stress * m[1] * n[1],
          R * r * stress * m[1] * n[0]};
}

// Of a ring of material: its radial force changes by what turns with it and by what runs around it, its moment not at all. Errors are
// h^2 of third derivatives, below 1e3, and rounding over h^2.
TEST(TwistedAnnulus, EveryRingIsInEquilibrium) {  // [Annulus 1, 2, 3, 4]
  const double h = 1e-4;
  for (const double twist : {0.01, 0.1, 0.3}) {
    const TwistedAnnulus twisted(ring(twist));
    for (const double R : {0.42, 0.5, 0.6, 0.73}) {
      const Forces here = forces_at(twisted, 7, R, h);
      const double rise = (forces_at(twisted, 7, R + h, h).radial - forces_at(twisted, 7, R - h, h).radial) / (2 * h);
      EXPECT_NEAR(rise, here.turning + here.hoop, 1e-5) << twist << " " << R;
      EXPECT_NEAR(2 * M_PI * 0.02 * here.moment / twisted.torque().value, 1, 1e-5) << twist << " " << R;
    }
  }
}

TEST(TwistedAnnulus, TorqueIsTheSlopeOfTheEnergy) {  // [Annulus 6]
  const double h = 1e-4;
  for (const double twist : {0.01, 0.1, 0.3}) {
    const double slope = (TwistedAnnulus(ring(twist + h)).energy().value -
                          TwistedAnnulus(ring(twist - h)).energy().value) /
                         (2 * h);
    EXPECT_NEAR(slope / TwistedAnnulus(ring(twist)).torque().value, 1, 1e-6);
  }
}

TEST(TwistedAnnulus, RimsKeepTheirRadii) {  // [Annulus 3, 4]
  const TwistedAnnulus twisted(ring(0.2));
  for (const auto& [radius, turned] : {std::pair{0.4, -0.2}, {0.75, 0.0}}) {
    const AnnulusPoint rim = twisted.at(radius);
    expect_near(rim.radius, radius, 1e-10);
    expect_near(rim.turned, turned, 1e-10);
  }
}

// The stretch across is that of the area over that along: by differences, det F = r r'/R.
TEST(TwistedAnnulus, TheRestOfTheAreaIsAcross) {  // [Annulus 7]
  const TwistedAnnulus twisted(ring(0.2));
  for (const double R : {0.45, 0.6}) {
    const double h = 1e-5, slope = (twisted.at(R + h).radius.value - twisted.at(R - h).radius.value) / (2 * h);
    const AnnulusPoint point = twisted.at(R);
    EXPECT_NEAR((point.along * point.across).value, point.radius.value * slope / R, 1e-8);
  }
}

TEST(TwistedAnnulus, TautRingsAreRefused) {  // [Annulus 7]
  const auto key = [](double nu, double inner, double twist) {
    return refused_key([=] { TwistedAnnulus({1, nu, 0.01, inner, 1, twist}); });
  };
  EXPECT_EQ(key(0.3, 0.5, 0.05), "poisson_ratio");
  EXPECT_EQ(key(0.3, 0.6, 0.05), "accepted");
  EXPECT_EQ(key(0.3, 0.6, 0.2), "poisson_ratio");
  EXPECT_EQ(key(0, 0.1, 0.05), "accepted");
  EXPECT_EQ(key(0, 0.5, 2), "twist");
}

TEST(TwistedAnnulus, WrongProblemsAreRefusedByKey) {
  const auto key = [](double TwistedAnnulusProblem::*member, double value) {
    return refused_value<TwistedAnnulus>(member, value);
  };
  EXPECT_EQ(key(&TwistedAnnulusProblem::youngs_modulus, 0), "youngs_modulus");
  EXPECT_EQ(key(&TwistedAnnulusProblem::poisson_ratio, -0.1), "poisson_ratio");
  EXPECT_EQ(key(&TwistedAnnulusProblem::thickness, 0), "thickness");
  EXPECT_EQ(key(&TwistedAnnulusProblem::inner_radius, 0), "inner_radius");
  EXPECT_EQ(key(&TwistedAnnulusProblem::outer_radius, 0.5), "outer_radius");
  EXPECT_EQ(key(&TwistedAnnulusProblem::twist, std::nan("")), "twist");
  EXPECT_EQ(refused_key([] { TwistedAnnulus().at(0.4); }), "position");
  EXPECT_EQ(refused_key([] { TwistedAnnulus().at(1.1); }), "position");
}

}  // namespace
}  // namespace plumbline::reference::twisted_annulus_test
