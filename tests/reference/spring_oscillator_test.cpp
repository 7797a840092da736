#include "reference/spring_oscillator.hpp"

#include <gsl/gsl_sf_elljac.h>
#include <gtest/gtest.h>

#include <cmath>

#include "reference/parameter.hpp"

namespace plumbline::reference::spring_oscillator_test {
namespace {

// Within the bound that it states, and that bound is a few thousand roundings.
void expect_within(Bounded found, double exact) {
  EXPECT_LE(std::abs(found.value - exact), found.bound + 1e-15);
  EXPECT_LE(found.bound, 1e-12);
}

TEST(SpringOscillator, LinearInClosedForm) {
  for (const double t : {0.0, 0.3, 2.0, 17.0}) {
    const auto found = spring_oscillator({.gravity = 0.2, .displacement = 0.3, .velocity = -0.4}, t);
    expect_within(found.displacement, 0.2 + 0.1 * std::cos(t) - 0.4 * std::sin(t));
    expect_within(found.velocity, -0.1 * std::sin(t) - 0.4 * std::cos(t));
  }
}

TEST(SpringOscillator, DampedInClosedForm) {
  const double zeta = 0.25, w = std::sqrt(1 - zeta * zeta), t = 3;
  const auto found = spring_oscillator({.damping = zeta, .displacement = 1}, t);
  expect_within(found.displacement, std::exp(-zeta * t) * (std::cos(w * t) + zeta / w * std::sin(w * t)));
  expect_within(found.velocity, -std::exp(-zeta * t) / w * std::sin(w * t));
}

TEST(SpringOscillator, HardeningByJacobisFunctions) {  // [DLMF 22.13.14]
  for (const double u0 : {0.1, 0.7, 2.0}) {
    const double w = std::sqrt(1 + u0 * u0), m = u0 * u0 / (2 * w * w), t = 2.5;
    double sn = 0, cn = 0, dn = 0;
    gsl_sf_elljac_e(w * t, m, &sn, &cn, &dn);
    const auto found = spring_oscillator({.law = SpringLaw::hardening, .displacement = u0}, t);
    EXPECT_NEAR(found.displacement.value, u0 * cn, 1e-13 * (1 + u0 * u0));
    EXPECT_NEAR(found.velocity.value, -u0 * w * sn * dn, 1e-13 * (1 + u0 * u0 * u0));
  }
}

// So fast that halving the steps never settles within rounding: what the last halving changed is the bound.
TEST(SpringOscillator, BoundWhereStepsDoNotSettle) {  // [DLMF 22.13.14]
  for (const double u0 : {60.0, 150.0}) {
    const double w = std::sqrt(1 + u0 * u0), m = u0 * u0 / (2 * w * w), t = 0.9;
    double sn = 0, cn = 0, dn = 0;
    gsl_sf_elljac_e(w * t, m, &sn, &cn, &dn);
    const auto found = spring_oscillator({.law = SpringLaw::hardening, .displacement = u0}, t);
    EXPECT_LE(std::abs(found.displacement.value - u0 * cn), found.displacement.bound);
    EXPECT_LE(std::abs(found.velocity.value + u0 * w * sn * dn), found.velocity.bound);
    EXPECT_GT(found.displacement.bound, 1e-12 * u0);  // else it has settled, and says nothing here
  }
}

// v^2/2 + W(u) with W' = -f: of a gas column W = u/gamma + (1 + u)^(1 - gamma) / (gamma (gamma - 1)).
TEST(SpringOscillator, AGasColumnKeepsItsEnergy) {
  for (const double gamma : {1.2, 1.4, 3.0}) {
    const auto energy = [&](double u, double v) {
      return v * v / 2 + u / gamma + std::pow(1 + u, 1 - gamma) / (gamma * (gamma - 1));
    };
    const SpringOscillatorProblem problem{
        .law = SpringLaw::gas_column, .gamma = gamma, .displacement = -0.4, .velocity = 0.1};
    for (const double t : {0.5, 4.0}) {
      const auto now = spring_oscillator(problem, t);
      EXPECT_NEAR(energy(now.displacement.value, now.velocity.value), energy(-0.4, 0.1), 1e-13);
    }
  }
}

TEST(SpringOscillator, RefusesWhatIsNoState) {
  EXPECT_THROW(spring_oscillator({.damping = -1}, 1), ParameterError);
  EXPECT_THROW(spring_oscillator({.law = SpringLaw::gas_column, .gamma = 1}, 1), ParameterError);
  EXPECT_THROW(spring_oscillator({.law = SpringLaw::gas_column, .displacement = -1}, 1), ParameterError);
  EXPECT_THROW(spring_oscillator({}, -1), ParameterError);
}

}  // namespace
}  // namespace plumbline::reference::spring_oscillator_test
