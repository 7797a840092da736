// A standing sound wave: the acoustic equations, the walls, and bounds that hold for the nonlinear gas.
#include "reference/standing_wave.hpp"

#include "tests/reference/flow_checks.hpp"

namespace plumbline::reference::standing_wave_test {
namespace {

const StandingWaveProblem air{1e-5, 2 * M_PI, 1, 1, 1.4};
const StandingWaveProblem loud{2e-3, 3, 1.3, 2, 5.0 / 3};

TEST(StandingWavePublished, SwingsWithTheSpeedOfSound) {  // Landau, Lifshitz, section 64
  for (const StandingWaveProblem& p : {air, loud}) {
    const StandingWave wave(p);
    const double c = std::sqrt(p.gamma * p.pressure / p.density), quarter = wave.period().value / 4;
    EXPECT_NEAR(wave.sound_speed().value, c, 1e-15 * c);
    EXPECT_NEAR(wave.period().value, 2 * M_PI / (c * p.wavenumber), 1e-14);
    const double crest = M_PI / (2 * p.wavenumber), second = 10 * p.amplitude / c;  // order, of the first
    EXPECT_NEAR(wave.sample(crest, 0).velocity.value, p.amplitude, 1e-15 * p.amplitude);
    EXPECT_NEAR(wave.sample(crest, quarter).velocity.value, 0, second * p.amplitude);
    EXPECT_NEAR(wave.sample(crest, 2 * quarter).velocity.value, -p.amplitude, second * p.amplitude);
    EXPECT_NEAR(wave.sample(0, quarter).density.value / p.density - 1, -p.amplitude / c, second * p.amplitude / c);
    EXPECT_NEAR(wave.sample(0, quarter).velocity.value, 0, 1e-15 * p.amplitude) << "at the wall";
  }
}

// Mass and momentum of the nonlinear gas are balanced but for orders above the second; e from p and rho. [York 4.4]
TEST(StandingWaveIdentity, EquationsOfMotion) {
  for (const StandingWaveProblem& p : {air, loud}) {
    const StandingWave wave(p);
    const double t = 0.3 * wave.period().value, k = 1e-3 * t, x = 0.4 / p.wavenumber, h = 1e-3 * x;
    const double c = wave.sound_speed().value, mach = p.amplitude / c, size = mach * c * p.wavenumber;
    const auto slope = [&](auto field) {
      return (field(wave.sample(x + h, t)) - field(wave.sample(x - h, t))) / (2 * h);
    };
    const auto rate = [&](auto field) {
      return (field(wave.sample(x, t + k)) - field(wave.sample(x, t - k))) / (2 * k);
    };
    const auto density = [](const Sample& s) { return s.density.value; };
    const auto velocity = [](const Sample& s) { return s.velocity.value; };
    const auto pressure = [](const Sample& s) { return s.pressure.value; };
    const auto flux = [](const Sample& s) { return s.density.value * s.velocity.value; };
    const Sample s = wave.sample(x, t);
    // Differences: truncated at 1e-6 of the wave, rounded at 1e-16 of the gas over their width; the third order.
    const double off = 1e-5 + 30 * mach * mach;
    EXPECT_NEAR(rate(density), -slope(flux), p.density * (size * off + 1e-15 / k));
    EXPECT_NEAR(s.density.value * (rate(velocity) + s.velocity.value * slope(velocity)), -slope(pressure),
                p.density * c * size * off + 1e-15 * p.pressure / h);
    const Bounded energy = s.pressure / (Bounded(p.gamma - 1) * s.density);
    EXPECT_LE(std::abs(s.energy.value - energy.value), s.energy.bound + energy.bound);
  }
}

// Riemann's invariants u +- 2 c/(gamma - 1) of the nonlinear gas, by steps on a grid along their own curves.
TEST(StandingWaveBounds, HoldForTheNonlinearGas) {
  const StandingWaveProblem& p = loud;
  const StandingWave wave(p);
  const double c0 = wave.sound_speed().value, g = p.gamma;
  const auto start = [&](double x) { return p.amplitude * std::sin(p.wavenumber * x); };
  const auto nonlinear = [&](double x, double t, int steps) {
    const int cells = 800;
    const double length = 2 * M_PI / p.wavenumber, dx = length / cells, dt = t / steps;
    std::vector<double> up(cells), down(cells);
    for (int i = 0; i < cells; ++i) up[i] = down[i] = start(i * dx);
    const auto read = [&](const std::vector<double>& w, double place) {  // cubic, periodic
      const double at = place / dx;
      const int i = static_cast<int>(std::floor(at));
      const double f = at - i;
      const auto v = [&](int k) { return w[static_cast<std::size_t>(((i + k) % cells + cells) % cells)]; };
      return -f * (f - 1) * (f - 2) / 6 * v(-1) + (f + 1) * (f - 1) * (f - 2) / 2 * v(0) -
             (f + 1) * f * (f - 2) / 2 * v(1) + (f + 1) * f * (f - 1) / 6 * v(2);
    };
    for (int n = 0; n < steps; ++n) {
      std::vector<double> next_up(cells), next_down(cells);
      for (int i = 0; i < cells; ++i) {
        const auto foot = [&](double sign) {
          double place = i * dx;
          for (int k = 0; k < 4; ++k) {
            const double a = read(up, place), b = read(down, place);
            place = i * dx - dt * ((a + b) / 2 + sign * (c0 + (g - 1) / 4 * (a - b)));
          }
          return place;
        };
        next_up[i] = read(up, foot(1));
        next_down[i] = read(down, foot(-1));
      }
      up = next_up;
      down = next_down;
    }
    const double a = read(up, x), b = read(down, x);
    return std::pair{(a + b) / 2, c0 + (g - 1) / 4 * (a - b)};
  };
  const double t = 1.3 * wave.period().value;
  for (const double turn : {0.07, 0.31, 0.64}) {
    const double x = turn * 2 * M_PI / p.wavenumber;
    const auto [u, c] = nonlinear(x, t, 1200);
    const Sample s = wave.sample(x, t);
    const double density = p.density * std::pow(c / c0, 2 / (g - 1));
    EXPECT_LE(std::abs(s.velocity.value - u), s.velocity.bound) << turn;
    EXPECT_LE(std::abs(s.density.value - density), s.density.bound) << turn;
    EXPECT_LT(s.velocity.bound, 1e-3 * p.amplitude) << "and that says something";
  }
}

TEST(StandingWaveArguments, AreChecked) {
  for (const auto& [key, problem] :
       {std::pair{"amplitude", StandingWaveProblem{0.1}}, std::pair{"wavenumber", StandingWaveProblem{1e-6, 0}},
        std::pair{"density", StandingWaveProblem{1e-6, 1, -1}}}) {
    try {
      const StandingWave wave(problem);
      ADD_FAILURE() << key;
    } catch (const ParameterError& error) {
      EXPECT_EQ(error.key, key);
    }
  }
  EXPECT_THROW(StandingWave(loud).sample(0, 1e6), ParameterError) << "it breaks before";
}

}  // namespace
}  // namespace plumbline::reference::standing_wave_test
