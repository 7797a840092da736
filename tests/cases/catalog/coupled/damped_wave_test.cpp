// Frequency and damping of oscillations that are known.
#include "cases/catalog/coupled/damped_wave.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace plumbline::damped_wave_test {
namespace {

struct Samples {
  std::vector<double> times, values;
};

// e^(-delta t) cos(omega_d t) with omega_d^2 = omega^2 - delta^2, 80 samples a period and a little uneven.
Samples wave(double omega, double damping, double periods) {
  const double delta = damping * omega, seen = std::sqrt(omega * omega - delta * delta);
  Samples s;
  for (int k = 0; k <= 80 * periods; ++k) {
    const double t = 2 * std::numbers::pi / omega * (k + 0.2 * std::sin(k)) / 80;
    s.times.push_back(t);
    s.values.push_back(std::exp(-delta * t) * std::cos(seen * t));
  }
  return s;
}

TEST(DampedWave, FindsFrequencyAndDamping) {
  for (const double damping : {0.0, 0.01, 0.1}) {
    const Samples s = wave(25.0, damping, 4);
    const auto found = damped_wave(s.times, s.values);
    ASSERT_TRUE(found);
    // With even steps a zero is off by (omega tau)^2 tau/62 = 1e-6 periods, an extreme by 3 (omega tau)^4/128 = 1e-6.
    EXPECT_NEAR(found->omega, 25, 25 * 2e-5 + 25 * damping * 1e-3) << damping;
    EXPECT_NEAR(found->damping, damping, 2e-4 * damping + 1e-6) << damping;
  }
}

TEST(DampedWave, NeedsAWholePeriod) {
  const Samples s = wave(25.0, 0.01, 1.1);
  EXPECT_FALSE(damped_wave(s.times, s.values));
  EXPECT_FALSE(damped_wave({}, {}));
}

}  // namespace
}  // namespace plumbline::damped_wave_test
