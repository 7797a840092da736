// Circular sheets under pressure: Hencky's series, the inextensible balloon, balances of forces at points and over all.
#include "reference/circular_membrane.hpp"

#include "reference/circle.hpp"
#include "reference/quadrature.hpp"
#include "tests/reference/checks.hpp"

namespace plumbline::reference::circular_membrane_test {
namespace {

// W. B. Fichter, NASA TP-3658 (1997), the first terms of Hencky's series: stress in the middle b0/4 q^(2/3). Finite
// loads change both by a share of the strain, q^(2/3).
TEST(CircularMembrane, SmallLoadsAreHenckysProblem) {  // [Surface 10]
  const double q = 1e-9, third = std::cbrt(q);
  for (const auto& [nu, b] : {std::pair{0.2, 1.6827}, {0.3, 1.7244}, {0.4, 1.7769}}) {
    const CircularMembrane membrane({q, nu, 1});
    EXPECT_NEAR(membrane.stress().value / (third * third), b / 4, 5e-5 / 4 + third * third);
    const double a[] = {1 / b,
                        1 / (2 * std::pow(b, 4)),
                        5 / (9 * std::pow(b, 7)),
                        55 / (72 * std::pow(b, 10)),
                        7 / (6 * std::pow(b, 13)),
                        205 / (108 * std::pow(b, 16)),
                        17051 / (5292 * std::pow(b, 19))};
    for (double s : {0.0, 0.3, 0.5}) {
      double series = 0, last = 0;
      for (int n = 0; n < 7; ++n) series += last = a[n] * (1 - std::pow(s, 2 * n + 2));
      // further terms fall at least as fast as the last two do, by 2.5
      EXPECT_NEAR(membrane.at(s).height.value / third, series + last / 3, last / 3 + 5e-5) << nu << " " << s;
    }
  }
  EXPECT_NEAR(CircularMembrane({q, 0.3, 1}).height().value / third, 0.6534, 5e-5);
}

// A prototype's shooting in other variables, half of its last printed digit.
TEST(CircularMembrane, FiniteLoads) {  // [Surface 10]
  for (const auto& [q, height] : {std::pair{1e-3, 0.65404}, {1e-2, 0.65625}, {0.05, 0.66177}, {0.1, 0.66683}}) {
    expect_near(CircularMembrane({q, 0.3, 1}).height() / std::cbrt(q), height, 5e-6);
  }
}

constexpr double margin = 1e-10;  // bounds of r, 1e-12, are divided by the least s and hoop strains taken from that

struct Slopes {
  double radius, height, force;  // r', height', (s S1 r')'
};

/// By differences over h: errors h^2 times third derivatives.
template <class Membrane>
Slopes slopes_at(const Membrane& membrane, double s, double h) {
  auto slope = [&](auto member, double at) {
    return ((membrane.at(at + h).*member).value - (membrane.at(at - h).*member).value) / (2 * h);
  };
  auto force = [&](double at) {
    return at * membrane.at(at).meridian_stress.value * slope(&MembranePoint::radius, at);
  };
  return {slope(&MembranePoint::radius, s), slope(&MembranePoint::height, s), (force(s + h) - force(s - h)) / (2 * h)};
}

/// Forces of a ring and of all that it encloses, and the stretch that the stress belongs to.
template <class Membrane>
void expect_balance(const Membrane& membrane, double q, double s) {
  const double h = 1e-3, rough = 1e-4;
  const MembranePoint p = membrane.at(s);
  const Slopes d = slopes_at(membrane, s, h);
  const double r = p.radius.value, S1 = p.meridian_stress.value, S2 = p.hoop_stress.value, size = q * r * r;
  EXPECT_NEAR(-s * S1 * d.height, 0.5 * q * r * r, rough * size) << s;
  EXPECT_NEAR(d.force, S2 * r / s + q * r * d.height, rough * (S1 + size / s)) << s;
  EXPECT_NEAR(d.radius * d.radius + d.height * d.height, p.meridian_stretch.value * p.meridian_stretch.value, rough);
}

TEST(CircularMembrane, EveryPieceIsInEquilibrium) {  // [Surface 10]
  for (double q : {1e-4, 0.05, 0.5}) {
    for (double nu : {0.0, 0.3, 0.5}) {
      const CircularMembrane membrane({q, nu, 1});
      for (double s : {0.05, 0.4, 0.9}) {
        expect_balance(membrane, q, s);
        const MembranePoint p = membrane.at(s);
        const Bounded hoop = p.radius / s, e2 = Bounded(0.5) * (hoop - 1.0) * (hoop + 1.0);
        const Bounded e1 = Bounded(0.5) * (p.meridian_stretch - 1.0) * (p.meridian_stretch + 1.0);
        expect_zero((Bounded(1) - Bounded(nu) * nu) * p.meridian_stress - e1 - e2 * nu, 1, "law", margin);
        expect_zero(p.hoop_stress - e2 - p.meridian_stress * nu, 1, "law", margin);
      }
    }
  }
}

/// int (S1 l1^2 + S2 l2^2) s ds over [from, to].
template <class Membrane>
Bounded pull(const Membrane& membrane, double from, double to) {
  auto f = [&](double s) {
    const MembranePoint p = membrane.at(s);
    const Bounded hoop = p.radius / s;
    return Bounded(s) * (p.meridian_stress * p.meridian_stretch * p.meridian_stretch + p.hoop_stress * hoop * hoop);
  };
  return integrate(f, from, to);
}

// Growth without change of shape: 3 p V is what the stresses do, and what the clamp does.
TEST(CircularMembrane, WorkOfGrowth) {  // [Surface 10]
  for (double q : {1e-3, 0.05, 0.7}) {
    const CircularMembrane membrane({q, 0.3, 1});
    const MembranePoint rim = membrane.at(1);
    EXPECT_NEAR(rim.radius.value, 1, 1e-12);
    EXPECT_NEAR(rim.height.value, 0, 1e-12);
    // at the rim: radial force S1 r', of l1^2 = r'^2 + y'^2 and S1 y' = q/2
    const Bounded down = Bounded(q) / (Bounded(2) * rim.meridian_stress);
    const Bounded slope = sqrt(rim.meridian_stretch * rim.meridian_stretch - down * down);
    const Bounded clamp = Bounded(2) * pi * rim.meridian_stress * slope;
    const Bounded stresses = Bounded(2) * pi * pull(membrane, 0, 1);
    EXPECT_NEAR((Bounded(3) * q * membrane.volume() + clamp).value, stresses.value, 1e-10 * stresses.value);
  }
}

TEST(CircularMembrane, OnlyRatiosCount) {
  const CircularMembrane one({0.05, 0.3, 1}), three({0.05, 0.3, 3});
  expect_same(three.height(), one.height(), 3);
  expect_same(three.volume(), one.volume(), 27);
  expect_same(three.stress(), one.stress());
  expect_same(three.at(1.2).radius, one.at(0.4).radius, 3);
  expect_same(three.at(0).height, three.height());
  expect_same(three.at(0).meridian_stress, one.stress());
}

// By the prototype, whose law sets the hoop stress to zero in every step.
TEST(MylarBalloon, FiniteLoads) {  // [Surface 11]
  const double figures[][4] = {
      {1e-4, 0.76282, 0.45755, 1.21882}, {1e-3, 0.76323, 0.45949, 1.22098}, {1e-2, 0.76643, 0.46818, 1.23836}};
  for (const auto& [q, rim, height, volume] : figures) {
    const MylarBalloon balloon({q, 0.3, 1});
    expect_near(balloon.rim_radius(), rim, 5e-6);
    expect_near(balloon.half_height(), height, 5e-6);
    expect_near(balloon.volume(), volume, 5e-6);
  }
}

// W. Paulsen, Amer. Math. Monthly 101 (1994) 953, in Gamma functions. What is elastic adds: the stretch of the
// meridians, of the order of q ln(1/q), and the taut middle, as wide as q^(1/5), which is flat: q^(3/5) of the height.
TEST(MylarBalloon, SmallLoadsAreTheInextensibleBalloon) {  // [Surface 11]
  const double root = std::sqrt(pi.value);
  const double rim = 4 * std::tgamma(0.75) / (root * std::tgamma(0.25));
  const double height = rim * root * std::tgamma(0.75) / (4 * std::tgamma(1.25));
  const double volume = 2 * pi.value / 3 * rim * rim;
  EXPECT_NEAR(rim, 0.7627, 1e-4);
  EXPECT_NEAR(height / rim, 0.599, 1e-3);
  EXPECT_NEAR(volume, 1.2185, 1e-4);
  for (double q : {1e-9, 1e-7, 1e-5}) {
    const MylarBalloon balloon({q, 0.3, 1});
    EXPECT_NEAR(balloon.rim_radius().value, rim, q * std::log(1 / q));
    EXPECT_NEAR(balloon.half_height().value, height, std::pow(q, 0.6));
    EXPECT_NEAR(balloon.volume().value, volume, 2 * pi.value * q * std::log(1 / q));
    EXPECT_NEAR(balloon.taut_radius().value, std::pow(q, 0.2), 0.01 * std::pow(q, 0.2));
  }
}

TEST(MylarBalloon, EveryPieceIsInEquilibrium) {  // [Surface 10, 11]
  for (double q : {1e-3, 0.01, 0.3}) {
    const double nu = 0.3;
    const MylarBalloon balloon({q, nu, 1});
    const double edge = balloon.taut_radius().value;
    const Bounded seam = Bounded(0.5) * q * balloon.rim_radius() * balloon.rim_radius();
    for (double s : {0.3 * edge, 0.9 * edge, 0.8 * edge + 0.2, 0.5 * edge + 0.5}) {
      expect_balance(balloon, q, s);
      const MembranePoint p = balloon.at(s);
      const Bounded hoop = p.radius / s, e2 = Bounded(0.5) * (hoop - 1.0) * (hoop + 1.0);
      const Bounded e1 = Bounded(0.5) * (p.meridian_stretch - 1.0) * (p.meridian_stretch + 1.0);
      if (s < edge) {
        expect_zero((Bounded(1) - Bounded(nu) * nu) * p.meridian_stress - e1 - e2 * nu, 1, "law", margin);
        EXPECT_GT(p.hoop_stress.value, 0);
      } else {
        expect_zero(p.meridian_stress - e1, 1, "one-way law", margin);
        EXPECT_EQ(p.hoop_stress.value, 0);
        EXPECT_LT((e2 + e1 * nu).value, 0);
        expect_zero(Bounded(s) * p.meridian_stress * p.meridian_stretch - seam, 1, "force along the meridian", margin);
      }
    }
  }
}

TEST(MylarBalloon, WorkOfGrowth) {  // [Surface 11]
  for (double q : {1e-3, 0.05, 0.3}) {
    const MylarBalloon balloon({q, 0.3, 1});
    const double edge = balloon.taut_radius().value;
    const Bounded stresses = Bounded(4) * pi * (pull(balloon, 0, edge) + pull(balloon, edge, 1));
    EXPECT_NEAR(3 * q * balloon.volume().value, stresses.value, 1e-10 * stresses.value);
  }
}

TEST(MylarBalloon, SheetsMeetUprightAndPartsFit) {  // [Surface 11]
  const MylarBalloon balloon({0.02, 0.3, 2});
  const double edge = balloon.taut_radius().value;
  expect_same(balloon.at(2).radius, balloon.rim_radius());
  EXPECT_EQ(balloon.at(2).height.value, 0);
  expect_same(balloon.at(0).height, balloon.half_height());
  const MembranePoint last = balloon.at(2 - 1e-4);  // r = R - y^2/R, as the curvature is 2/R there
  EXPECT_NEAR((balloon.rim_radius() - last.radius).value * balloon.rim_radius().value,
              last.height.value * last.height.value, 1e-11);
  const MembranePoint in = balloon.at(edge * (1 - 1e-9)), out = balloon.at(edge * (1 + 1e-9));
  EXPECT_NEAR(in.radius.value, out.radius.value, 1e-8);
  EXPECT_NEAR(in.height.value, out.height.value, 1e-8);
  EXPECT_NEAR(in.meridian_stress.value, out.meridian_stress.value, 1e-10);
  EXPECT_NEAR(in.hoop_stress.value, 0, 1e-10);
  expect_same(MylarBalloon({0.02, 0.3, 1}).volume(), balloon.volume(), 0.125);
}

TEST(CircularMembraneProblem, WrongProblemsAreRefusedByKey) {
  auto clamped = [](double CircularMembraneProblem::*member, double value) {
    return refused_value<CircularMembrane, CircularMembraneProblem>(member, value);
  };
  auto sewn = [](double CircularMembraneProblem::*member, double value) {
    return refused_value<MylarBalloon, CircularMembraneProblem>(member, value);
  };
  for (double wrong : {0.0, -1.0, 1e-10, 1.1, std::nan("")}) {
    EXPECT_EQ(clamped(&CircularMembraneProblem::load, wrong), "load");
    EXPECT_EQ(sewn(&CircularMembraneProblem::load, wrong), "load");
  }
  EXPECT_EQ(clamped(&CircularMembraneProblem::poisson_ratio, -0.1), "poisson_ratio");
  EXPECT_EQ(sewn(&CircularMembraneProblem::poisson_ratio, 0.6), "poisson_ratio");
  EXPECT_EQ(clamped(&CircularMembraneProblem::radius, 0), "radius");
  EXPECT_EQ(sewn(&CircularMembraneProblem::radius, -1), "radius");
  EXPECT_EQ(sewn(&CircularMembraneProblem::load, 1), "load");  // taut all over
  EXPECT_EQ(refused_key([] { CircularMembrane().at(1.1); }), "position");
  EXPECT_EQ(refused_key([] { MylarBalloon().at(-0.1); }), "position");
}

}  // namespace
}  // namespace plumbline::reference::circular_membrane_test
