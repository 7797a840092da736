// Carlson's integrals: his published values, scaling, duplication, and Legendre's integrals against GSL's.
#include "reference/carlson.hpp"

#include <gsl/gsl_sf_ellint.h>

#include "reference/circle.hpp"
#include "reference/elliptic.hpp"
#include "tests/reference/checks.hpp"

namespace plumbline::reference::carlson_test {
namespace {

// B. C. Carlson, Numer. Algorithms 10 (1995) 13, section 3. He gives fourteen digits; twelve are
// asked for, because a bound must be far below what is checked.
TEST(Carlson, PublishedValues) {  // [DLMF 19.16.1, 19.16.5, 19.36.1, 19.36.2]
  expect_near(carlson_RF(1, 2, 0), 1.3110287771461, 1e-11);
  expect_near(carlson_RF(2, 3, 4), 0.58408284167715, 1e-11);
  expect_near(carlson_RD(0, 2, 1), 1.7972103521034, 1e-11);
  expect_near(carlson_RD(2, 3, 4), 0.16510527294261, 1e-11);
}

TEST(Carlson, DuplicationAndScaling) {  // [DLMF 19.26.18, 19.26.20]
  const double sets[][3] = {{0.3, 2, 5}, {1e-8, 1, 3}, {40, 0.01, 1e-3}, {0, 0.7, 200}};
  for (const auto& [x, y, z] : sets) {
    const Bounded a = sqrt(Bounded(x)), b = sqrt(Bounded(y)), c = sqrt(Bounded(z));
    const Bounded shift = a * b + b * c + c * a;
    const Bounded F = carlson_RF(x, y, z), D = carlson_RD(x, y, z);
    const Bounded more_F = carlson_RF(Bounded(x) + shift, Bounded(y) + shift, Bounded(z) + shift);
    const Bounded more_D = carlson_RD(Bounded(x) + shift, Bounded(y) + shift, Bounded(z) + shift);
    expect_zero(F - Bounded(2) * more_F, F.value, "F");
    expect_zero(D - Bounded(2) * more_D - Bounded(3) / (c * (Bounded(z) + shift)), D.value, "D");
    expect_zero(carlson_RF(9 * x, 9 * y, 9 * z) * 3.0 - F, F.value, "F scaled");
    expect_zero(carlson_RD(9 * x, 9 * y, 9 * z) * 27.0 - D, D.value, "D scaled");
  }
}

TEST(Carlson, LegendresIntegralsAreThoseOfGsl) {  // [DLMF 19.25.5, 19.25.13]
  for (double k : {0.0, 0.2, 0.7, 0.99}) {
    for (double phi : {0.1, 0.7, 1.2, 1.57}) {
      const Bounded sine = sin(Bounded(phi)), kept = Bounded(1) - Bounded(k) * k * sine * sine;
      const LegendreFD found = legendre_FD(sine, cos(Bounded(phi)), sqrt(kept));
      const double F = gsl_sf_ellint_F(phi, k, GSL_PREC_DOUBLE), E = gsl_sf_ellint_E(phi, k, GSL_PREC_DOUBLE);
      EXPECT_NEAR(found.F.value, F, 1e-13 * F);
      EXPECT_NEAR(k * k * found.D.value, F - E, 1e-13 * F);
    }
  }
}

TEST(Carlson, ModulusAboveOne) {  // sin t = sin u/sqrt m turns F into that of 1/m over sqrt m
  const double m = 1.8, sine = 0.7, delta = std::sqrt(1 - m * sine * sine);
  const LegendreFD found = legendre_FD(sine, std::sqrt(1 - sine * sine), delta);
  const double turned = gsl_sf_ellint_F(std::asin(sine * std::sqrt(m)), 1 / std::sqrt(m), GSL_PREC_DOUBLE);
  EXPECT_NEAR(found.F.value, turned / std::sqrt(m), 1e-13);
}

TEST(Carlson, CompleteIntegrals) {  // [DLMF 19.8.6]
  for (double degrees : {0.001, 5.0, 30.0, 60.0, 85.0, 89.9}) {
    const Bounded angle = pi * degrees / 180.0, square = sin(angle) * sin(angle);
    const CompleteKDC found = complete_KDC(square, cos(angle));
    const LegendreFD carlson = legendre_FD(1, 0, cos(angle));
    expect_zero(found.K - carlson.F, found.K.value, "K");
    expect_zero(found.K - elliptic_K(sin(angle), cos(angle)), found.K.value, "K by Gauss");
    expect_zero(found.D - carlson.D, found.D.value, "D");
    expect_zero(Bounded(2) * found.D - found.K - square * found.C, found.K.value, "C");
  }
  const CompleteKDC none = complete_KDC(0, 1);  // pi/2, pi/4, pi/16
  expect_zero(none.K - pi / 2.0, 1, "K of 0");
  expect_zero(none.D - pi / 4.0, 1, "D of 0");
  expect_zero(none.C - pi / 16.0, 1, "C of 0");
}

}  // namespace
}  // namespace plumbline::reference::carlson_test
