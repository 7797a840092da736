// The simple wave: Riemann invariants, conservation, the sound limit, the time of breaking.
#include "reference/simple_wave.hpp"

#include "tests/reference/flow_checks.hpp"

namespace plumbline::reference::simple_wave_test {
namespace {

std::vector<SimpleWaveProblem> all_problems() {
  return {{0.01, 0.3, 0.25, 1, 1, 1.4}, {0.6, 0.3, 0.25, 1, 1, 1.4},   {-0.6, 0.3, 0.25, 1, 1, 1.4},
          {2, -1, 3, 0.2, 5, 1.05},     {-1.5, 2, 0.5, 3, 7, 5.0 / 3}, {0.4, 0, 1, 1, 1, 3}};
}

// f = (1 - s^2)^6 falls fastest at s = 1/sqrt(11), by 12/sqrt(11) (10/11)^5 = 2.24655.
TEST(SimpleWavePublished, BreakingTimeAndNoFoldBeforeIt) {
  const SimpleWave wave({0.5, 0.3, 0.25, 1, 1, 1.4});
  const double slope = 12 / std::sqrt(11.0) * std::pow(10.0 / 11, 5) * 0.5 / 0.25;
  EXPECT_NEAR(wave.breaking_time().value, 2 / (2.4 * slope), 1e-15);
  double steepest = 0;  // d(u + c)/dx at t = 0, by differences
  for (int i = 1; i < 4000; ++i) {
    const double x = 0.05 + 0.5 * i / 4000, h = 1e-5;
    const double difference = wave.sample(x + h, 0).velocity.value - wave.sample(x - h, 0).velocity.value;
    steepest = std::min(steepest, 1.2 * difference / (2 * h));
  }
  EXPECT_NEAR(-1 / steepest, wave.breaking_time().value, 1e-6);  // of the scan: (0.5/4000)^2 over the width squared
  const double nearly = 0.9999 * wave.breaking_time().value;
  double last = wave.sample(0.9, nearly).density.value;
  for (int i = 1; i < 3000; ++i) {
    const double x = 0.9 - 0.9 * i / 3000, density = wave.sample(x, nearly).density.value;
    EXPECT_GE(density, 1);
    EXPECT_TRUE(std::isfinite(density));
    EXPECT_LT(std::abs(density - last), 0.45);  // no jump larger than the pulse itself, 0.47
    last = density;
  }
  EXPECT_EQ(refused_key([&] { wave.sample(0.3, wave.breaking_time().value); }), "time");
  EXPECT_EQ(SimpleWave({0, 0.3, 0.25, 1, 1, 1.4}).breaking_time().value, rounding::infinity);
}

TEST(SimpleWaveIdentity, EntropyAndInvariantAreTheSameEverywhere) {
  for (const SimpleWaveProblem& p : all_problems()) {
    const SimpleWave wave(p);
    const Bounded gamma(p.gamma), two_over = Bounded(2) / (gamma - 1.0), c0 = wave.sound_speed();
    const double t = 0.8 * wave.breaking_time().value;
    const Bounded rest = log(Bounded(p.pressure)) - gamma * log(Bounded(p.density));
    for (double share : {-0.99, -0.5, 0.0, 0.3, 0.9}) {
      const Sample s = wave.sample(p.centre + c0.value * t + share * p.half_width, t);
      const Bounded c = sqrt(gamma * s.pressure / s.density);
      expect_zero(log(s.pressure) - gamma * log(s.density) - rest, 100, "entropy");
      expect_zero(s.velocity - two_over * c + two_over * c0, 100 * two_over.value * c0.value, "invariant");
      expect_zero(s.energy * (gamma - 1.0) * s.density - s.pressure, s.pressure.value, "equation of state");
    }
  }
}

TEST(SimpleWaveIdentity, EachStateTravelsWithItsOwnSpeed) {
  for (const SimpleWaveProblem& p : all_problems()) {
    const SimpleWave wave(p);
    for (double late : {0.2, 0.9}) {
      const double t = late * wave.breaking_time().value;
      for (double s : {-0.9, -0.4, 0.1, 0.35, 0.8}) {
        const double x0 = p.centre + s * p.half_width;
        const Sample start = wave.sample(x0, 0);
        const double c = std::sqrt(p.gamma * start.pressure.value / start.density.value);
        const Sample then = wave.sample(x0 + (start.velocity.value + c) * t, t);
        // x carries a rounding of a few units of its size; slopes grow tenfold by 0.9 of the breaking time
        const double margin = 1e-13 * (1 + std::abs(p.centre) / p.half_width) * 10 * std::abs(p.amplitude);
        EXPECT_NEAR(then.velocity.value, start.velocity.value, margin + 1e-13 * c * t / p.half_width);
      }
    }
  }
}

TEST(SimpleWaveIdentity, MassMomentumAndEnergyAreKept) {
  for (const SimpleWaveProblem& p : all_problems()) {
    const SimpleWave wave(p);
    auto totals = [&](double t) {
      const double front = p.centre + p.half_width + wave.sound_speed().value * t, back = front - 2 * p.half_width;
      auto total = [&](auto density) {  // over_body counts both sides of a plane
        return 0.5 * over_body(1, back, front, [&](double x) { return density(wave.sample(x, t)); });
      };
      return std::array<double, 3>{
          total([&](const Sample& s) { return s.density.value - p.density; }),
          total([](const Sample& s) { return s.density.value * s.velocity.value; }), total([&](const Sample& s) {
            return s.density.value * (s.energy.value + 0.5 * s.velocity.value * s.velocity.value) -
                   p.pressure / (p.gamma - 1);
          })};
    };
    const auto first = totals(0), later = totals(0.85 * wave.breaking_time().value);
    for (int i : {0, 1, 2}) EXPECT_NEAR(later[i] / first[i], 1, 1e-9);  // quadrature 1e-11 of pieces that cancel
  }
}

TEST(SimpleWaveIdentity, IsLinearSoundForASmallAmplitude) {  // p - p0 = rho c u at x - c t, then order a^2
  const double a = 1e-6, c = std::sqrt(1.4 * 2 / 0.5), t = 1.3;
  const SimpleWave wave({a, 0.2, 0.3, 0.5, 2, 1.4});
  for (double s : {-0.6, 0.0, 0.4}) {
    const double shape = std::pow(1 - s * s, 6);
    const Sample sound = wave.sample(0.2 + 0.3 * s + c * t, t);
    EXPECT_NEAR(sound.velocity.value / a, shape, 1e-4);  // steepening: 1.2 a t/half_width times the slope, 1.2e-5
    EXPECT_NEAR((sound.pressure.value - 2) / (0.5 * c * sound.velocity.value), 1, 1e-5);
  }
}

TEST(SimpleWaveSample, GasBesideThePulseIsAtRest) {
  for (const SimpleWaveProblem& p : all_problems()) {
    const SimpleWave wave(p);
    const double t = 0.5 * wave.breaking_time().value, middle = p.centre + wave.sound_speed().value * t;
    for (double x : {middle - 1.000001 * p.half_width, middle + 1.000001 * p.half_width, middle + 30}) {
      const Sample s = wave.sample(x, t);
      EXPECT_EQ(s.velocity.value, 0);
      EXPECT_EQ(s.velocity.bound, 0);
      EXPECT_EQ(s.density.value, p.density);
      EXPECT_EQ(s.pressure.value, p.pressure);
    }
    EXPECT_LT(wave.sample(middle + p.half_width, t).velocity.bound, 1e-60);  // (1e-13)^6 and margin: C^5 at the ends
  }
}

TEST(SimpleWaveProblem, WrongProblemsAreRefusedByKey) {
  auto key = [](const SimpleWaveProblem& problem) { return refused_key([&] { SimpleWave wave(problem); }); };
  EXPECT_EQ(key({-6, 0, 1, 1, 1, 1.4}), "amplitude");  // 2 c/(gamma - 1) = 5.916
  EXPECT_EQ(key({-5.9, 0, 1, 1, 1, 1.4}), "accepted");
  EXPECT_EQ(key({0.1, rounding::infinity, 1, 1, 1, 1.4}), "centre");
  EXPECT_EQ(key({0.1, 0, 0, 1, 1, 1.4}), "half_width");
  EXPECT_EQ(key({0.1, 0, 1, 0, 1, 1.4}), "density");
  EXPECT_EQ(key({0.1, 0, 1, 1, 0, 1.4}), "pressure");
  EXPECT_EQ(key({0.1, 0, 1, 1, 1, 1}), "gamma");
  EXPECT_EQ(refused_key([] { SimpleWave({}).sample(0, -1); }), "time");
}

}  // namespace
}  // namespace plumbline::reference::simple_wave_test
