// Piston between a spring and a closed column of gas.
#include "reference/piston_container.hpp"

#include "reference/circle.hpp"
#include "tests/reference/checks.hpp"

namespace plumbline::reference::piston_container_test {
namespace {

PistonContainerProblem york(double mass, double spring_density) {
  PistonContainerProblem p;
  p.mass = mass;
  p.spring_density = spring_density;
  return p;
}

/// No length, modulus or density like another.
PistonContainerProblem mixed() { return {3, 1.3, 0.7, 0.4, 0.35, 0.2, 1.9, 0.8, 0.6}; }

TEST(PistonContainer, YorksFrequencies) {  // [York 6.2]
  const PistonContainer light(york(0.1, 0)), heavy(york(1, 0));
  EXPECT_EQ(light.stiffness().value, 100);
  expect_near(light.omega(), 886.43, 5e-3);  // half of the last digit; York's table 3 prints 886.2
  expect_near(heavy.omega(), 281.15, 5e-3);  // table 3: 281.2
  expect_near(light.omega(2), 1.98e4, 50);
  expect_near(light.period(), 0.00709, 5e-6);  // table 3
  expect_near(heavy.period(), 0.02234, 1e-5);  // table 3, from the rounded 281.2
}

TEST(PistonContainer, TheDecksSpringIsNotMassless) {  // numbers of a separate solution: 865.4 and 909.4, 281.6
  const PistonContainer light(york(0.1, 1e-3)), heavy(york(1, 1e-3));
  expect_near(light.omega(4), 865.4, 5e-2);
  expect_near(light.omega(5), 909.4, 5e-2);
  expect_near(heavy.omega(2), 281.6, 5e-2);
}

// Light gas and spring: a third of their masses moves with the piston, an upper bound by Rayleigh's principle; the sum
// of the squared periods is a lower one (Dunkerley).
TEST(PistonContainer, FirstFrequencyIsNearTheLumpedOne) {  // [York 6.2]
  for (double mass : {0.1, 1.0, 30.0}) {
    const PistonContainer system(york(mass, 1e-6));
    const double k = system.stiffness().value + system.gas_stiffness().value;
    const double third = (system.gas_mass().value + system.spring_mass().value) / 3;
    const double lumped = std::sqrt(k / (mass + third));
    EXPECT_LE(system.omega().value, lumped * (1 + 1e-15));
    // the next term of w L/c cot(w L/c) is (w L/c)^4/45, and (w L/c)^2 = m_g/(m + m_g/3) at most
    const double ratio = system.gas_mass().value / mass;
    EXPECT_NEAR(system.omega().value, lumped, lumped * (ratio * ratio / 45 + 1e-15));
  }
}

TEST(PistonContainer, EveryRootBalancesTheForces) {
  for (const PistonContainerProblem& p : {york(0.1, 0), york(0.1, 1e-3), york(1, 1e-5), mixed()}) {
    const PistonContainer system(p);
    double before = 0;
    for (int n : {1, 2, 3, 7, 40}) {
      const Bounded w = system.omega(n);
      EXPECT_GT(lowest(w), before);
      before = highest(w);
      const Bounded gas = Bounded(p.bulk_modulus) * p.area * system.slope(p.gas_length, n);
      const double above = std::nextafter(p.gas_length, 2 * p.gas_length);
      const Bounded spring = Bounded(p.spring_modulus) * p.area * system.slope(above, n);
      const double scale = std::abs(gas.value) + std::abs(spring.value) + p.mass * w.value * w.value;
      // The place above the piston is off by rounding, which turns the phase by w/c times it; next to a pole the rounding
      // of the phase counts as the cotangent's slope.
      expect_zero(gas - spring - Bounded(p.mass) * w * w + Bounded(0, 1e-13 * scale * n), scale, "force", 1e-4);
    }
    EXPECT_GT(lowest(system.omega(3001)), highest(system.omega(3000)));  // beyond those kept
    EXPECT_GT(lowest(system.omega(2049)), highest(system.omega(2048)));
  }
}

TEST(PistonContainer, ShapeIsOneAtThePistonAndZeroAtTheWalls) {
  for (const PistonContainerProblem& p : {york(0.1, 0), york(0.1, 1e-3), mixed()}) {
    const PistonContainer system(p);
    for (int n : {1, 2, 5}) {
      EXPECT_EQ(system.shape(0, n).value, 0);
      EXPECT_NEAR(system.shape(p.gas_length + p.spring_length, n).value, 0, 1e-12);
      EXPECT_EQ(system.shape(p.gas_length, n).value, 1);
      const double near = 1e-9 * p.gas_length;
      for (double y : {p.gas_length - near, p.gas_length + near})
        EXPECT_NEAR(system.shape(y, n).value, 1, 1.01 * near * std::abs(system.slope(y, n).value) + 1e-12);
      for (double y : {0.3 * p.gas_length, p.gas_length + 0.6 * p.spring_length}) {
        const double h = 1e-5 * p.gas_length, scale = std::abs(system.slope(y, n).value) + 1 / p.gas_length;
        const double difference = (system.shape(y + h, n).value - system.shape(y - h, n).value) / (2 * h);
        EXPECT_NEAR(difference, system.slope(y, n).value, 1e-6 * scale);  // h^2 times the third derivative, rounding/h
      }
    }
  }
}

/// The mass of the product of two modes, by midpoints; kinks only at the piston, where pieces meet.
double mass_of(const PistonContainer& system, const PistonContainerProblem& p, int i, int j) {
  const int n = 4000;
  double sum = p.mass;
  for (int k = 0; k < n; ++k) {
    const double in_gas = p.gas_length * (k + 0.5) / n, in_spring = p.gas_length + p.spring_length * (k + 0.5) / n;
    sum += p.gas_density * p.area * p.gas_length / n * system.shape(in_gas, i).value * system.shape(in_gas, j).value;
    sum += p.spring_density * p.area * p.spring_length / n * system.shape(in_spring, i).value *
           system.shape(in_spring, j).value;
  }
  return sum;
}

TEST(PistonContainer, ModalMassIsTheIntegralAndModesAreOrthogonal) {
  for (const PistonContainerProblem& p : {york(0.1, 0), york(0.1, 1e-3), mixed()}) {
    const PistonContainer system(p);
    for (int n : {1, 2, 4}) {
      const double mass = system.modal_mass(n).value;
      EXPECT_NEAR(mass_of(system, p, n, n), mass, 1e-5 * mass);  // (phase/n)^2/24 of the midpoint rule
      const double other = system.modal_mass(n + 1).value;
      EXPECT_NEAR(mass_of(system, p, n, n + 1), 0, 1e-5 * std::sqrt(mass * other));
      EXPECT_NEAR(system.mode_energy(n).value, 0.5 * mass * p.velocity * p.velocity, 1e-14 * mass);
    }
  }
}

// All of the piston's momentum is in the modes: sum m/M_n = 1. By the inequality of Cauchy and Schwarz m/M_n is at most
// 2 k/(m w_n^2), k the sum of the stiffnesses, which bounds those left out: a root missed or invented would show.
TEST(PistonContainer, NoModeIsMissing) {
  for (const PistonContainerProblem& p : {york(0.1, 0), york(0.1, 1e-3), york(1, 1e-5), mixed()}) {
    const PistonContainer system(p);
    const double k = system.stiffness().value + system.gas_stiffness().value;
    double sum = 0, last = 0;
    const double poles = std::sqrt(system.gas_mass().value / system.gas_stiffness().value) +
                         std::sqrt(system.spring_mass().value / system.stiffness().value);
    for (int n = 1; n <= 2000; ++n) {
      last = system.omega(n).value;
      sum += system.participation(n).value * last / p.velocity;
    }
    const double rest = 2 * k / p.mass * poles / pi.value / (last * 0.99);  // sum of 2 k/(m w^2), w spaced pi/poles
    EXPECT_LE(sum, 1 + 1e-12);
    EXPECT_GE(sum, 1 - rest - 1e-12);
    EXPECT_LE(rest, 0.02);
  }
}

// Until a wave has come back from a wall both sides are dampers: m x'' = -(Z_gas + Z_spring) x'.
TEST(PistonContainer, GoesAsADamperUntilTheFirstEcho) {
  for (const PistonContainerProblem& p : {york(0.1, 1e-3), york(1, 1e-5), mixed()}) {
    const PistonContainer system(p);
    const double gas = std::sqrt(system.gas_mass().value * system.gas_stiffness().value);
    const double spring = std::sqrt(system.spring_mass().value * system.stiffness().value);
    const double first = 2 * std::min(system.gas_mass().value / gas, system.spring_mass().value / spring);
    for (double share : {0.0, 0.1, 0.5, 0.97}) {
      const double t = share * first, rate = (gas + spring) / p.mass;
      const double place = -p.velocity * std::expm1(-rate * t) / rate;
      EXPECT_NEAR(system.displacement(t).value, place, system.displacement(t).bound + 1e-14 * std::abs(place));
      EXPECT_NEAR(system.velocity(t).value, p.velocity * std::exp(-rate * t), system.velocity(t).bound);
      EXPECT_LE(system.displacement(t).bound, 1e-6 * std::abs(p.velocity) / system.omega().value);
      EXPECT_LE(system.velocity(t).bound, 1e-2 * std::abs(p.velocity));
    }
  }
}

TEST(PistonContainer, MasslessSpringWithDamperUntilTheFirstEcho) {  // [York 6.2]
  const PistonContainerProblem p = york(0.1, 0);
  const PistonContainer system(p);
  const double half = 0.5 * std::sqrt(system.gas_mass().value * system.gas_stiffness().value) / p.mass;
  const double square = half * half - system.stiffness().value / p.mass, w = std::sqrt(square);
  for (double t : {5e-5, 2e-4, 3.1e-4}) {
    const double place = p.velocity * std::exp(-half * t) * std::sinh(w * t) / w;
    EXPECT_NEAR(system.displacement(t).value, place, system.displacement(t).bound);
  }
}

TEST(PistonContainer, SpringOfLittleMassIsTheMasslessOne) {
  const PistonContainer massless(york(0.1, 0)), light(york(0.1, 1e-9));
  // w L_s/c_s cot of it = 1 - (w L_s/c_s)^2/3: the spring weighs a third of 2e-8 kg on 0.1 kg
  EXPECT_NEAR(light.omega().value, massless.omega().value, massless.omega().value * 0.5 * 2e-8 / 3 / 0.1 * 1.01);
  EXPECT_LT(light.omega().value, massless.omega().value);
  for (double t : {1e-3, 0.02})
    EXPECT_NEAR(light.displacement(t).value, massless.displacement(t).value, 1e-6 / 886);  // phase 4e-8 w t
}

TEST(PistonContainer, EqualColumnsHaveModesWithThePistonAtRest) {  // both poles k pi c/L at one place
  PistonContainerProblem p{3, 1.5, 2, 0.5, 0.7, 2, 3, 1.5, 1};
  const PistonContainer system(p);
  const double apart = pi.value * std::sqrt(1.5) / 1.5;
  for (int n : {2, 4, 10}) {
    EXPECT_LE(std::abs(system.omega(n).value - n / 2 * apart), system.omega(n).bound + 1e-15 * n * apart);
    EXPECT_LE(system.omega(n).bound, 1e-13 * n);
    EXPECT_LE(std::abs(system.participation(n).value), system.participation(n).bound);
    EXPECT_LE(system.participation(n).bound, 1e-20);
  }
  PistonContainerProblem one = p;  // a column of twice the impedance has the other modes
  one.bulk_modulus *= 2;
  one.gas_density *= 2;
  one.spring_modulus = 1e-14;
  one.spring_density = 0;
  const PistonContainer single(one);
  for (int n : {1, 2, 5}) EXPECT_NEAR(system.omega(2 * n - 1).value, single.omega(n).value, 1e-12);
}

TEST(PistonContainer, AModeMovesAsOne) {
  const PistonContainerProblem p = york(0.1, 1e-3);
  const PistonContainer system(p);
  for (int n : {1, 5}) {
    const Bounded w = system.omega(n);
    for (double t : {0.0, 1e-3, 0.03}) {
      const Bounded x = system.mode_displacement(t, n) * w, v = system.mode_velocity(t, n);
      expect_zero(x * x + v * v - Bounded(p.velocity) * p.velocity, 1, "circle", 1e-11);
    }
  }
}

TEST(PistonContainerProblem, WrongProblemsAreRefusedByKey) {
  const auto key = refused_value<PistonContainer, PistonContainerProblem>;
  using P = PistonContainerProblem;
  EXPECT_EQ(key(&P::spring_modulus, 0), "spring_modulus");
  EXPECT_EQ(key(&P::spring_length, -1), "spring_length");
  EXPECT_EQ(key(&P::spring_density, -1e-9), "spring_density");
  EXPECT_EQ(key(&P::area, 0), "area");
  EXPECT_EQ(key(&P::mass, 0), "mass");
  EXPECT_EQ(key(&P::gas_density, 0), "gas_density");
  EXPECT_EQ(key(&P::bulk_modulus, std::nan("")), "bulk_modulus");
  EXPECT_EQ(key(&P::gas_length, 0), "gas_length");
  EXPECT_EQ(key(&P::velocity, rounding::infinity), "velocity");
  const PistonContainer system{P{}};
  EXPECT_EQ(refused_key([&] { system.omega(0); }), "mode");
  EXPECT_EQ(refused_key([&] { system.shape(40.1); }), "position");
  EXPECT_EQ(refused_key([&] { system.displacement(-1); }), "time");
}

}  // namespace
}  // namespace plumbline::reference::piston_container_test
