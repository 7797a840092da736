// K(k) and Gauss's mean [DLMF 19.8.5].
#include "reference/elliptic.hpp"

#include <gsl/gsl_sf_ellint.h>

#include "reference/circle.hpp"
#include "reference/elementary.hpp"
#include "tests/reference/checks.hpp"

namespace plumbline::reference::elliptic_test {
namespace {

TEST(Elliptic, GaussHimself) {  // [DLMF 19.8.5], M(sqrt 2, 1), Gauss's diary of 30 May 1799
  expect_near(gauss_mean(sqrt(Bounded(2)), 1.0), 1.1981402347355922074, 1e-11);
  EXPECT_LE(gauss_mean(sqrt(Bounded(2)), 1.0).bound, 1e-14);
}

// M. Abramowitz, I. A. Stegun, Handbook of Mathematical Functions, table 17.1, by m = k^2.
TEST(Elliptic, PublishedValues) {  // [DLMF 19.8.5]
  auto by_m = [](double m) { return elliptic_K(sqrt(Bounded(m)), sqrt(Bounded(1) - m)); };
  expect_near(by_m(0.0), 1.570796326794897, 1e-10);
  expect_near(by_m(0.5), 1.854074677301372, 1e-10);
  expect_near(by_m(0.99), 3.695637362989875, 1e-10);
}

TEST(Elliptic, AgreesWithGslAndStaysBoundedNearOne) {  // [DLMF 19.8.5]
  for (double degrees : {1.0, 20.0, 45.0, 80.0, 89.0}) {
    const Bounded angle = pi * degrees / 180.0;
    const Bounded K = elliptic_K(sin(angle), cos(angle));
    EXPECT_NEAR(K.value, gsl_sf_ellint_Kcomp(std::sin(angle.value), GSL_PREC_DOUBLE), K.bound + 1e-13);
    EXPECT_LE(K.bound, 1e-12);
  }
  const Bounded small(1e-9);  // K = log(4/k') + order k'^2 log k'
  const Bounded K = elliptic_K(sqrt(Bounded(1) - small * small), small);
  EXPECT_NEAR(K.value, std::log(4e9), 1e-13);
  EXPECT_LE(K.bound, 1e-12);
}

}  // namespace
}  // namespace plumbline::reference::elliptic_test
