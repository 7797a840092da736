// Viscous decay of a shear: closed form, heat against kinetic energy lost, the equations of the sound it makes.
#include "reference/shear_decay.hpp"

#include "tests/reference/flow_checks.hpp"

namespace plumbline::reference::shear_decay_test {
namespace {

const ShearDecayProblem thick{0.02, 2 * M_PI, 0.03, 1.3, 2, 5.0 / 3};
const ShearDecayProblem thin{0.05, M_PI, 1e-3, 1, 1, 1.4};

TEST(ShearDecayPublished, HalvesInItsHalfLife) {  // Landau, Lifshitz, section 24: e^(-nu k^2 t), nu = mu/rho
  for (const ShearDecayProblem& p : {thick, thin}) {
    const ShearDecay shear(p);
    const double rate = p.viscosity / p.density * p.wavenumber * p.wavenumber, half = std::log(2.0) / rate;
    EXPECT_NEAR(shear.decay_rate().value, rate, 1e-14 * rate);
    EXPECT_EQ(shear.sample(0, 0).velocity.value, p.amplitude);
    EXPECT_NEAR(shear.sample(0, half).velocity.value, p.amplitude / 2, 1e-14);
    EXPECT_NEAR(shear.sample(M_PI / p.wavenumber, 2 * half).velocity.value, -p.amplitude / 4, 1e-14);
    EXPECT_NEAR(shear.sample(M_PI / p.wavenumber / 3, half).velocity.value, p.amplitude / 4, 1e-14);
  }
}

// e = p/((gamma - 1) rho) [York 4.4], exactly at the start and later to the order that the solution keeps.
TEST(ShearDecayIdentity, EquationOfState) {
  for (const ShearDecayProblem& p : {thick, thin}) {
    const ShearDecay shear(p);
    EXPECT_NEAR(shear.sample(0.1, 0).energy.value, p.pressure / ((p.gamma - 1) * p.density), 1e-14 * p.pressure);
    for (double t : {0.3, 2.0}) {
      const Sample s = shear.sample(0.4 / p.wavenumber, t / shear.decay_rate().value);
      const Bounded expected = s.pressure / (Bounded(p.gamma - 1) * s.density);
      EXPECT_LE(std::abs(s.energy.value - expected.value), s.energy.bound + expected.bound);
    }
  }
}

TEST(ShearDecayIdentity, DiffusionEquation) {  // rho u_t = mu u_xx: York's stress 2 mu D' [York 4.1]
  for (const ShearDecayProblem& p : {thick, thin}) {
    const ShearDecay shear(p);
    const double x = 0.3 / p.wavenumber, t = 0.7 / shear.decay_rate().value, h = 1e-3 / p.wavenumber, k = 1e-3 * t;
    auto u = [&](double at, double when) { return shear.sample(at, when).velocity.value; };
    const double rate = (u(x, t + k) - u(x, t - k)) / (2 * k);
    const double curvature = (u(x + h, t) - 2 * u(x, t) + u(x - h, t)) / (h * h);
    EXPECT_NEAR(p.density * rate / (p.viscosity * curvature), 1, 1e-6);  // truncation 1e-6/6
  }
}

TEST(ShearDecayIdentity, HeatIsTheKineticEnergyLost) {
  for (const ShearDecayProblem& p : {thick, thin}) {
    const ShearDecay shear(p);
    for (double t : {0.0, 0.3 / shear.decay_rate().value, 30 / shear.decay_rate().value}) {
      const Bounded u = Bounded(p.amplitude) * 0.5 * p.amplitude * p.density * 0.5;  // mean of rho u^2/2 at t = 0
      const double left = std::exp(-2 * shear.decay_rate().value * t);
      EXPECT_NEAR(shear.heat(t).value, u.value * (1 - left), 1e-14 * u.value);
    }
  }
}

/// Derivative in time of one amplitude, by differences of fourth order.
double rate_of(const std::function<double(double)>& f, double t, double k) {
  return (8 * (f(t + k) - f(t - k)) - (f(t + 2 * k) - f(t - 2 * k))) / (12 * k);
}

// Mass, momentum along x with the viscosity 4/3 mu of York's stress [York 4.1], and pressure with the heat as source.
TEST(ShearDecayIdentity, SoundObeysLinearAcoustics) {
  for (const ShearDecayProblem& p : {thick, thin}) {
    const ShearDecay shear(p);
    const double K = 2 * p.wavenumber, c = shear.sound_speed().value, u2 = p.amplitude * p.amplitude;
    auto density = [&](double t) { return shear.sample(0, t).density.value - p.density; };  // amplitude of cos K x
    auto mean = [&](double t) { return (p.gamma - 1) * shear.heat(t).value; };
    auto pressure = [&](double t) { return shear.sample(0, t).pressure.value - p.pressure - mean(t); };
    auto along = [&](double t) { return shear.longitudinal_velocity(M_PI / (2 * K), t).value; };  // of sin K x
    for (double turns : {0.2, 1.1, 7.3}) {
      const double t = turns * 2 * M_PI / (c * K), k = 1e-3 / (c * K);
      const double source = (p.gamma - 1) * p.viscosity * p.wavenumber * p.wavenumber * u2 / 2 *
                            std::exp(-2 * shear.decay_rate().value * t);
      const double scale = source + std::abs(p.density * c * c * K * along(t));
      // rounding of values near 1 over k: 1e-16 p/k
      const double margin = 1e-6 * scale + 1e-13 * p.pressure * c * K;
      EXPECT_NEAR(rate_of(pressure, t, k), -p.density * c * c * K * along(t) - source, margin);
      EXPECT_NEAR(rate_of(density, t, k) * c * c, -p.density * c * c * K * along(t), margin);
      EXPECT_NEAR(p.density * rate_of(along, t, k), K * pressure(t) - 4.0 / 3 * p.viscosity * K * K * along(t),
                  1e-6 * K * std::abs(pressure(t)) + 1e-12 * K * p.pressure);
      EXPECT_NEAR(rate_of(mean, t, k), source, margin);
    }
  }
}

TEST(ShearDecayIdentity, EndsInEvenPressureAndColderDenserNodes) {
  const ShearDecay shear(thick);  // sound and shear are both gone after 30 decay times
  const double t = 30 / shear.decay_rate().value;
  const Sample antinode = shear.sample(0, t), node = shear.sample(0.5 * M_PI / thick.wavenumber, t);
  EXPECT_NEAR(antinode.pressure.value, node.pressure.value, 1e-12);
  EXPECT_GT(antinode.density.value, node.density.value);  // no heat where u_y is largest: its slope is zero there
  EXPECT_GT(node.energy.value, antinode.energy.value);
}

TEST(ShearDecaySample, BoundsShrinkWithTheSquareOfTheAmplitude) {
  ShearDecayProblem p = thin;
  p.amplitude = 0.08;
  const Sample large = ShearDecay(p).sample(0.1, 2);
  p.amplitude = 0.008;
  const Sample small = ShearDecay(p).sample(0.1, 2);
  const double relative = (large.velocity.bound / 0.08) / (small.velocity.bound / 0.008);
  EXPECT_NEAR(relative, 100, 1);
  EXPECT_NEAR(large.density.bound / small.density.bound, 1e4, 100);  // fourth order: the second is in the value
  EXPECT_LT(small.velocity.bound, 1e-4 * 0.008);
}

TEST(ShearDecaySample, WithoutViscosityNothingChanges) {
  const ShearDecay shear({0.1, M_PI, 0, 1, 1, 1.4});
  const Sample s = shear.sample(1, 100);
  EXPECT_NEAR(s.velocity.value, -0.1, 1e-15);
  EXPECT_EQ(s.pressure.value, 1);
  EXPECT_EQ(s.density.value, 1);
  EXPECT_LE(s.velocity.bound, 1e-15);
}

TEST(ShearDecayProblem, WrongProblemsAreRefusedByKey) {
  auto key = [](const ShearDecayProblem& problem) { return refused_key([&] { ShearDecay shear(problem); }); };
  EXPECT_EQ(key({0.7, 3, 0.01, 1, 1, 1.4}), "amplitude");
  EXPECT_EQ(key({0.1, 0, 0.01, 1, 1, 1.4}), "wavenumber");
  EXPECT_EQ(key({0.1, 3, -1, 1, 1, 1.4}), "viscosity");
  EXPECT_EQ(key({0.1, 3, 0.3, 1, 1, 1.4}), "viscosity");  // 0.3 times 3 is above half of 1.18
  EXPECT_EQ(key({0.1, 3, 0.01, 0, 1, 1.4}), "density");
  EXPECT_EQ(key({0.1, 3, 0.01, 1, 0, 1.4}), "pressure");
  EXPECT_EQ(key({0.1, 3, 0.01, 1, 1, 1}), "gamma");
  EXPECT_EQ(refused_key([] { ShearDecay({}).sample(0, -1); }), "time");
}

}  // namespace
}  // namespace plumbline::reference::shear_decay_test
