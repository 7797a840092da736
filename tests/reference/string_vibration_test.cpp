// The taut string: wave equation, energies, and the period at a finite amplitude.
#include "reference/string_vibration.hpp"

#include "reference/circle.hpp"
#include "tests/reference/checks.hpp"

namespace plumbline::reference::string_vibration_test {
namespace {

const StringVibrationProblem second{3e5, 0.02, 4, 0.003, 1.3, 2, 2e-3};
const StringVibrationProblem fifth{7e4, 0.5, 0.3, 0.05, 0.4, 5, -1e-3};

TEST(StringVibration, ExactNumbers) {  // T = 1e6 0.1 0.01 = 1000, c = sqrt(1e6 0.01/0.1), T/(rho A) = c^2
  const StringVibration string{StringVibrationProblem{}};
  expect_near(string.tension(), 1000, 1e-9);
  expect_near(string.wave_speed() * string.wave_speed(), 1e5, 1e-6);
  expect_near(string.period(), 2 / std::sqrt(1e5), 1e-12);
  expect_near(string.unstretched_length(), 1 / 1.01, 1e-12);
}

TEST(StringVibration, FrequencyIsTheWaveSpeedOverTwiceTheLength) {
  for (const StringVibrationProblem& p : {second, fifth}) {
    const StringVibration string(p);
    const Bounded frequency = Bounded(1) / string.period();
    expect_same(frequency * 2.0 * p.length, string.wave_speed(), p.mode);
    expect_same(string.wave_speed() * string.wave_speed() * p.density * p.area, string.tension());
  }
}

TEST(StringVibration, ObeysTheWaveEquation) {  // y_tt = c^2 y_xx, by slope and velocity
  for (const StringVibrationProblem& p : {StringVibrationProblem{}, second, fifth}) {
    const StringVibration string(p);
    const double w = string.omega().value, c = string.wave_speed().value, h = 1e-4 * p.length / p.mode;
    const double d = h / c, t = 0.4 / w, size = std::abs(p.amplitude) * w * w;
    for (double x : {0.1 * p.length, 0.27 * p.length, 0.5 * p.length}) {
      const double bend = (string.slope(x + h, t).value - string.slope(x - h, t).value) / (2 * h);
      const double push = (string.velocity(x, t + d).value - string.velocity(x, t - d).value) / (2 * d);
      EXPECT_NEAR(push, c * c * bend, 1e-6 * size);  // truncation (k h)^2/3 = 3e-8
      const double slope = (string.displacement(x + h, t).value - string.displacement(x - h, t).value) / (2 * h);
      const double speed = (string.displacement(x, t + d).value - string.displacement(x, t - d).value) / (2 * d);
      EXPECT_NEAR(slope, string.slope(x, t).value, 1e-6 * size / (w * c));
      EXPECT_NEAR(speed, string.velocity(x, t).value, 1e-6 * size / w);
    }
    expect_zero(string.displacement(0, t), std::abs(p.amplitude), "left end");
    expect_zero(string.displacement(p.length, t), std::abs(p.amplitude), "right end");
  }
}

TEST(StringVibration, EnergyIsTheIntegralOfItsDensity) {
  for (const StringVibrationProblem& p : {second, fifth}) {
    const StringVibration string(p);
    const double t = 0.7 / string.omega().value;
    const int n = 64;  // the mean of sin^2 over whole periods is exact by midpoints
    double kinetic = 0, potential = 0;
    for (int i = 0; i < n; ++i) {
      const double x = p.length * (i + 0.5) / n, v = string.velocity(x, t).value, s = string.slope(x, t).value;
      kinetic += 0.5 * p.density * p.area * v * v * p.length / n;
      potential += 0.5 * string.tension().value * s * s * p.length / n;
    }
    EXPECT_NEAR(kinetic, string.kinetic_energy(t).value, 1e-12 * string.energy().value);
    EXPECT_NEAR(potential, string.potential_energy(t).value, 1e-12 * string.energy().value);
    expect_same(string.kinetic_energy(t) + string.potential_energy(t), string.energy());
  }
}

// Duffing's equation: to first order the frequency rises by 3/8 gamma A^2, gamma A^2 = (k A)^2/(4 eps0); next term
// -21/256 (gamma A^2)^2 (A. H. Nayfeh, D. T. Mook, Nonlinear Oscillations, section 2.1.1).
TEST(StringVibration, KirchhoffsPeriodForSmallAmplitudes) {
  for (double amplitude : {0.0, 1e-6, 1e-4, 1e-3}) {
    StringVibrationProblem p = second;
    p.amplitude = amplitude;
    const StringVibration string(p);
    const double steep = 2 * pi.value / p.length * amplitude, z = steep * steep / (4 * p.strain);
    const double faster = string.period().value / string.kirchhoff_period().value - 1;
    EXPECT_NEAR(faster, 3.0 / 8 * z - 21.0 / 256 * z * z, z * z * z + 1e-14);
  }
}

TEST(StringVibration, KirchhoffsPeriodForLargeAmplitudes) {  // of q'' = -w^2 gamma q^3: 7.416298709205487/(w sqrt(z))
  StringVibrationProblem p = second;
  p.amplitude = 1e4;
  const StringVibration string(p);
  const double steep = 2 * pi.value / p.length * p.amplitude, z = steep * steep / (4 * p.strain);
  const double expected = 7.416298709205487 / (string.omega().value * std::sqrt(z));
  EXPECT_NEAR(string.kirchhoff_period().value, expected, expected * (2 / z + 1e-14));
}

TEST(StringVibrationProblem, WrongProblemsAreRefusedByKey) {
  auto key = [](const StringVibrationProblem& problem) {
    return refused_key([&] { StringVibration string(problem); });
  };
  EXPECT_EQ(key({0, 1, 1, 1, 1, 1, 1}), "youngs_modulus");
  EXPECT_EQ(key({1, 0, 1, 1, 1, 1, 1}), "area");
  EXPECT_EQ(key({1, 1, 0, 1, 1, 1, 1}), "density");
  EXPECT_EQ(key({1, 1, 1, 0, 1, 1, 1}), "strain");
  EXPECT_EQ(key({1, 1, 1, 1, 0, 1, 1}), "length");
  EXPECT_EQ(key({1, 1, 1, 1, 1, 0, 1}), "mode");
  EXPECT_EQ(refused_key([] { StringVibration({}).displacement(-0.1, 0); }), "position");
}

}  // namespace
}  // namespace plumbline::reference::string_vibration_test
