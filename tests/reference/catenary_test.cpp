// The catenary, inextensible and elastic: published values, equilibrium of every piece, limits.
#include "reference/catenary.hpp"

#include "tests/reference/checks.hpp"

namespace plumbline::reference::catenary_test {
namespace {

const CatenaryProblem problems[] = {{1, 1.2, 1, 0},    {3, 20, 0.2, 0}, {1, 1.0001, 5, 0},    {1, 1.2, 1, 0.3},
                                    {2, 1.5, 4, 0.05}, {1, 1, 2, 1e-6}, {300, 310, 46, 1e-8}, {0.01, 5, 1, 10}};

TEST(Catenary, ChainOfOneFifthMoreThanTheSpan) {  // 2 a sinh(d/2a) = L by Brent's method elsewhere
  const Catenary chain{CatenaryProblem{}};
  expect_near(chain.parameter(), 0.469542, 5e-7);
  expect_near(chain.sag(), 0.292344, 5e-7);
}

// Code_Aster, validation V6.02.114 (SSNL114: heavy cable) and V6.05.116, which gives the sag of its semi-analytical
// solution: 325 m of cable between supports as far apart, section 2.2783e-4 m^2, E 5.7e10 Pa, density 2844.23 kg/m^3.
TEST(Catenary, PublishedElasticCable) {
  const double area = 2.2783e-4;
  const Catenary cable({325, 325, 2844.23 * 9.81 * area, 1 / (5.7e10 * area)});
  expect_near(cable.sag(), 6.352, 5e-4);
}

TEST(Catenary, EndsAreAtTheSupports) {
  for (const CatenaryProblem& p : problems) {
    const Catenary chain(p);
    const double scale = std::max(p.span, p.length), margin = 1e-9;  // the nearly straight one amplifies by 1/(L - d)
    expect_zero(chain.x(0), scale, "left x", margin);
    expect_zero(chain.x(p.length) - p.span, scale, "right x", margin);
    EXPECT_EQ(chain.y(0).value, 0);
    EXPECT_EQ(chain.y(p.length).value, 0);
    expect_same(chain.x(0.5 * p.length), Bounded(0.5 * p.span));
  }
}

// A piece is held by the tensions at its ends: their horizontal parts are equal, their vertical parts carry its weight;
// and it is longer than unstretched by the tension times the compliance.
TEST(Catenary, EveryPieceIsInEquilibrium) {
  for (const CatenaryProblem& p : problems) {
    const Catenary chain(p);
    const double h = 1e-3 * std::min(p.length, chain.parameter().value);
    for (double share : {0.1, 0.35, 0.5, 0.8}) {
      const double s = share * p.length;
      const double dx = (chain.x(s + h) - chain.x(s - h)).value, dy = (chain.y(s + h) - chain.y(s - h)).value;
      const double stretch = 1 + p.compliance * chain.tension(s).value;
      // chords of an arc differ by (h/a)^2/6 from tangent and length; x and y carry their rounding over 2 h
      const double margin = 1e-6 + 4 * (chain.x(s).bound + chain.y(s).bound + 1e-16 * p.span) / h;
      EXPECT_NEAR(std::hypot(dx, dy) / (2 * h), stretch, margin * stretch);
      EXPECT_NEAR(std::atan2(dy, dx), chain.slope_angle(s).value, margin);
      const double pull = chain.tension(s).value, angle = chain.slope_angle(s).value;
      EXPECT_NEAR(pull * std::cos(angle), chain.horizontal_force().value, 1e-9 * pull);
      EXPECT_NEAR(pull * std::sin(angle), p.weight * (s - 0.5 * p.length), 1e-9 * pull);
    }
  }
}

TEST(Catenary, StretchedLengthIsThatOfTheCurve) {
  for (const CatenaryProblem& p : {problems[3], problems[4], problems[6]}) {
    const Catenary chain(p);
    double length = 0;
    const int n = 2000;
    for (int i = 0; i < n; ++i) length += (1 + p.compliance * chain.tension(p.length * (i + 0.5) / n).value) / n;
    EXPECT_NEAR(chain.stretched_length().value, length * p.length,
                1e-5 * p.compliance * p.weight * p.length * p.length);
  }
  EXPECT_EQ(Catenary(problems[1]).stretched_length().value, 20);
}

TEST(Catenary, BecomesInextensibleAsTheComplianceVanishes) {
  const Catenary hard({1, 1.2, 1, 0});
  for (double compliance : {1e-3, 1e-6, 1e-9}) {
    const Catenary chain({1, 1.2, 1, compliance});
    EXPECT_NEAR(chain.sag().value, hard.sag().value, 2 * compliance);
    EXPECT_NEAR(chain.parameter().value, hard.parameter().value, 2 * compliance);
  }
}

TEST(Catenary, NearlyStraightIsAParabola) {  // L = d (1 + 8/3 (f/d)^2) and higher
  for (double more : {1e-4, 1e-8, 1e-12}) {
    const double length = 2 * (1 + more);
    const Catenary chain({2, length, 3, 0});
    const double exact_more = (length - 2) / 2, sag = 2 * std::sqrt(3 * exact_more / 8);
    EXPECT_NEAR(chain.sag().value, sag, sag * (exact_more + 1e-14));
    EXPECT_LE(chain.sag().bound, 1e-13 * sag);  // the difference of lengths is exact
  }
}

TEST(Catenary, TautElasticStringHasTheTensionOfItsStretch) {
  const Catenary string({1.01, 1, 1e-6, 1e-3});  // H = 0.01/1e-3, sag w d^2/(8 H)
  EXPECT_NEAR(string.horizontal_force().value, 10, 1e-6);
  EXPECT_NEAR(string.sag().value, 1e-6 * 1.01 / 80, 1e-10 * 1.01 / 80);
}

TEST(CatenaryProblem, WrongProblemsAreRefusedByKey) {
  auto key = [](const CatenaryProblem& problem) { return refused_key([&] { Catenary chain(problem); }); };
  EXPECT_EQ(key({0, 1, 1, 0}), "span");
  EXPECT_EQ(key({1, 0, 1, 0}), "length");
  EXPECT_EQ(key({1, 1, 1, 0}), "length");
  EXPECT_EQ(key({1, 2, 0, 0}), "weight");
  EXPECT_EQ(key({1, 2, 1, -1}), "compliance");
  EXPECT_EQ(key({1, 1, 1, 1e-9}), "accepted");
  EXPECT_EQ(refused_key([] { Catenary({}).x(1.3); }), "position");
}

}  // namespace
}  // namespace plumbline::reference::catenary_test
