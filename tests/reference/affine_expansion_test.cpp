// The affine expansion of a gas into a vacuum: special cases in closed form, conservation, the equations of motion.
#include "reference/affine_expansion.hpp"

#include "tests/reference/flow_checks.hpp"

namespace plumbline::reference::affine_expansion_test {
namespace {

std::vector<AffineExpansionProblem> all_problems() {
  return {{2, 0.38, 1, 100, 1.4}, {1, 0.7, 2.5, 3, 1.4}, {3, 1.3, 0.2, 11, 5.0 / 3}, {3, 1, 1, 1, 1.05},
          {2, 2, 1, 1, 2},        {1, 1, 1, 0.01, 3},    {3, 0.5, 4, 2, 2.5}};
}

/// The time in which sound crosses the gas, about.
double unit_of_time(const AffineExpansionProblem& p) { return p.radius / std::sqrt(p.pressure / p.density); }

// R0 = 0.38, p_c = 100, rho_c = 1, gamma = 1.4, cylinder: six digits of a separate integration of R'' in time.
TEST(AffineExpansionPublished, Cylinder) {
  const AffineExpansion gas({2, 0.38, 1, 100, 1.4});
  EXPECT_NEAR(gas.radius(0.005).value, 0.402624, 5e-7);
  EXPECT_NEAR(gas.radius(0.01).value, 0.466320, 1e-6);
  EXPECT_NEAR(gas.radius(0.02).value, 0.680549, 5e-7);
  EXPECT_NEAR(gas.edge_speed(0.02).value, 25.5355, 5e-5);
  EXPECT_NEAR(gas.final_speed().value, 41.833, 5e-4);
}

// d (gamma - 1) = 2: R'' goes as 1/R^3 and R^2 = R0^2 + (w t)^2 exactly (Dyson 1968 for the monatomic sphere).
TEST(AffineExpansionPublished, RadiusInClosedFormWhereRpowerIsMinusThree) {
  for (const AffineExpansionProblem& p :
       {AffineExpansionProblem{3, 1.3, 0.2, 11, 5.0 / 3}, AffineExpansionProblem{2, 0.38, 1, 100, 2},
        AffineExpansionProblem{1, 1.7, 3, 0.4, 3}}) {
    const AffineExpansion gas(p);
    for (double share : {1e-8, 1e-3, 0.4, 1.0, 2.0, 30.0, 1e5}) {
      const double t = share * unit_of_time(p);
      const Bounded path = gas.final_speed() * t, r = sqrt(Bounded(p.radius) * p.radius + path * path);
      const double gamma_rounded = 30 * rounding::unit;  // 5/3 is rounded: the exponent is not quite 2
      EXPECT_NEAR(gas.radius(t).value, r.value, gas.radius(t).bound + r.bound + gamma_rounded * r.value);
      EXPECT_NEAR(gas.edge_speed(t).value, (gas.final_speed() * path / r).value, 100 * rounding::unit * path.value / t);
      EXPECT_LE(gas.radius(t).bound, sharp * r.value);
    }
  }
}

// d (gamma - 1) = 1: t w/R0 = sqrt(y (y - 1)) + arcosh(sqrt(y)).
TEST(AffineExpansionPublished, TimeInClosedFormWhereRpowerIsMinusTwo) {
  const AffineExpansionProblem p{2, 0.6, 2, 5, 1.5};
  const AffineExpansion gas(p);
  for (double y : {1.0001, 1.3, 1.999, 2.001, 7.0, 400.0}) {
    const double t = (std::sqrt(y * (y - 1)) + std::acosh(std::sqrt(y))) * p.radius / gas.final_speed().value;
    EXPECT_NEAR(gas.radius(t).value / p.radius, y, 1e-14 * y);  // some ten roundings of the check itself
  }
}

TEST(AffineExpansionIdentity, MassEnergyAndEntropyAreKept) {
  for (const AffineExpansionProblem& p : all_problems()) {
    const AffineExpansion expansion(p);
    const int d = p.dimension;
    for (double share : {0.0, 0.5, 3.0}) {
      const AffineGas gas = expansion.at(share * unit_of_time(p));
      const double edge = gas.radius().value;
      const double mass = over_body(d, 0, edge, [&](double r) { return gas.sample(r).density.value; });
      const double energy = over_body(d, 0, edge, [&](double r) {
        const Sample s = gas.sample(r);
        return s.density.value * (s.energy.value + 0.5 * s.velocity.value * s.velocity.value);
      });
      const double margin =
          1e-9;  // the quadrature is asked for 1e-11; a root at the edge (gamma > 2) costs two decades
      EXPECT_NEAR(mass / expansion.mass().value, 1, margin);
      EXPECT_NEAR(energy / expansion.energy().value, 1, margin);
      const Bounded at_start = log(Bounded(p.pressure)) - Bounded(p.gamma) * log(Bounded(p.density));
      for (double xi : {0.0, 0.3, 0.9}) {
        const Sample s = gas.sample(xi * edge);
        expect_zero(log(s.pressure) - Bounded(p.gamma) * log(s.density) - at_start, 100, "entropy");
        expect_zero(s.energy * (Bounded(p.gamma) - 1.0) * s.density - s.pressure, 100 * s.pressure.value, "state");
      }
    }
  }
}

TEST(AffineExpansionIdentity, GasObeysNewtonsLaw) {  // Du/Dt = -(dp/dr)/rho, at the same gas: r goes with R
  for (const AffineExpansionProblem& p : all_problems()) {
    const AffineExpansion expansion(p);
    const double t = 0.8 * unit_of_time(p), h = 1e-4 * t;
    const AffineGas now = expansion.at(t), before = expansion.at(t - h), after = expansion.at(t + h);
    for (double xi : {0.2, 0.7}) {
      auto at = [xi](const AffineGas& gas) { return gas.sample(xi * gas.radius().value); };
      const double acceleration = (at(after).velocity.value - at(before).velocity.value) / (2 * h);
      const double r = xi * now.radius().value, step = 1e-4 * now.radius().value;
      const double gradient = (now.sample(r + step).pressure.value - now.sample(r - step).pressure.value) / (2 * step);
      // truncation (1e-4)^2 times (1/(gamma - 1))^2 at gamma = 1.05, rounding 1e-13/1e-4
      EXPECT_NEAR(acceleration * at(now).density.value / -gradient, 1, 1e-5);
      // the edge moves as the gas there does
      EXPECT_NEAR((after.radius().value - before.radius().value) / (2 * h * now.edge_speed().value), 1, 1e-7);
    }
  }
}

TEST(AffineExpansionIdentity, FirstIntegral) {  // (R'/w)^2 = 1 - (R0/R)^(d (gamma - 1))
  for (const AffineExpansionProblem& p : all_problems()) {
    const AffineExpansion expansion(p);
    for (double share : {1e-3, 0.5, 20.0}) {
      const AffineGas gas = expansion.at(share * unit_of_time(p));
      const Bounded exponent = Bounded(p.dimension) * (Bounded(p.gamma) - 1.0), v = gas.edge_speed();
      const Bounded rest = Bounded(1) - pow(Bounded(p.radius) / gas.radius(), exponent);
      expect_zero(v / expansion.final_speed() * v / expansion.final_speed() - rest, 10, "energy of the edge");
    }
  }
}

TEST(AffineExpansionSample, NothingIsHotterThanItWas) {
  const AffineExpansion expansion({2, 0.38, 1, 100, 1.4});
  for (double t : {0.0, 0.005, 0.02}) {
    for (double r : {0.0, 0.1, 0.3}) EXPECT_LE(lowest(expansion.sample(r, t).energy), 250);
  }
}

TEST(AffineExpansionSample, EdgeAndBeyond) {
  const AffineExpansion expansion({2, 0.38, 1, 100, 1.4});
  const AffineGas gas = expansion.at(0.01);
  const double edge = gas.radius().value;
  EXPECT_EQ(gas.sample(edge).density.value, 0);
  EXPECT_LT(gas.sample(edge).density.bound, 1e-30);  // (1e-14)^2.5
  EXPECT_LT(gas.sample(edge * (1 - 1e-9)).density.value, 1e-20);
  EXPECT_EQ(gas.sample(2 * edge).density.value, 0);
  EXPECT_EQ(gas.sample(2 * edge).energy.value, 0);
  EXPECT_EQ(gas.sample(2 * edge).velocity.value, gas.edge_speed().value);
  EXPECT_EQ(expansion.sample(0.2, 0).velocity.value, 0);
  EXPECT_EQ(expansion.radius(0).value, 0.38);
  expect_same(expansion.sample(0.2, 0.01), gas.sample(0.2));
}

TEST(AffineExpansionProblem, WrongProblemsAreRefusedByKey) {
  auto key = [](const AffineExpansionProblem& p) { return refused_key([&] { AffineExpansion gas(p); }); };
  EXPECT_EQ(key({0, 1, 1, 1, 1.4}), "dimension");
  EXPECT_EQ(key({2, 0, 1, 1, 1.4}), "radius");
  EXPECT_EQ(key({2, 1, 0, 1, 1.4}), "density");
  EXPECT_EQ(key({2, 1, 1, 0, 1.4}), "pressure");
  EXPECT_EQ(key({2, 1, 1, 1, 1}), "gamma");
  EXPECT_EQ(refused_key([] { AffineExpansion({}).radius(-1); }), "time");
  EXPECT_EQ(refused_key([] { AffineExpansion({}).sample(-1, 1); }), "radius");
}

}  // namespace
}  // namespace plumbline::reference::affine_expansion_test
