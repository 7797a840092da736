#include "cases/harness/laboratory/wave.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace plumbline::wave_test {
namespace {

// The equations of the bar by hand, on hat functions: nodes stand at 0 ... cells, the first and the last do not move.
struct ByHand {
  int cells, ppc;
  std::size_t points() const { return static_cast<std::size_t>(cells * ppc); }
  double place(std::size_t p) const { return (static_cast<double>(p) + 0.5) / ppc; }
  double weight(int node, std::size_t p) const { return std::max(0.0, 1 - std::abs(place(p) - node)); }
  double slope(int node, std::size_t p) const { return weight(node, p) == 0 ? 0 : place(p) < node ? 1.0 : -1.0; }

  // Rates of (velocities, strains): v_p' = sum a_i N_ip, eps_p' = sum v_i dN_ip/dx.
  std::vector<double> rates(const std::vector<double>& state) const {
    const std::size_t n = points();
    const double mass = 1.0 / ppc;  // and volume; the modulus is one
    std::vector<double> rate(2 * n, 0.0);
    for (int i = 1; i < cells; ++i) {
      double m = 0, momentum = 0, force = 0;
      for (std::size_t p = 0; p < n; ++p) {
        m += mass * weight(i, p);
        momentum += mass * weight(i, p) * state[p];
        force -= mass * state[n + p] * slope(i, p);
      }
      for (std::size_t p = 0; p < n; ++p) {
        rate[p] += force / m * weight(i, p);
        rate[n + p] += momentum / m * slope(i, p);
      }
    }
    return rate;
  }
};

// The matrix whose exponential the orders are measured by, column by column.
TEST(StandingWave, RatesAsByHandOnHats) {
  const ByHand hand{4, 2};
  const auto rows = StandingWave({}, 4, 2).rates();
  ASSERT_EQ(rows.size(), 2 * hand.points());
  for (std::size_t k = 0; k < rows.size(); ++k) {
    std::vector<double> unit(rows.size(), 0.0);
    unit[k] = 1;
    const std::vector<double> expected = hand.rates(unit);
    for (std::size_t j = 0; j < rows.size(); ++j) EXPECT_NEAR(rows[j][k], expected[j], 1e-14) << j << " " << k;
  }
}

// The exact motion obeys the equations: its central difference over 1e-4, off by 1e-8/6 of third derivatives and by
// roundings over 1e-4.
TEST(StandingWave, ExactMotionObeysTheEquations) {
  const ByHand hand{4, 2};
  const StandingWave wave({}, 4, 2);
  const double t = 2.5, step = 1e-4;
  const auto before = wave.exact(t - step), here = wave.exact(t), after = wave.exact(t + step);
  const std::vector<double> rate = hand.rates(here);
  double largest = 0;
  for (std::size_t k = 0; k < rate.size(); ++k) {
    EXPECT_NEAR((after[k] - before[k]) / (2 * step), rate[k], 1e-8);
    largest = std::max(largest, std::abs(rate[k]));
  }
  EXPECT_GT(largest, 0.1);
}

// It begins between its extremes: speeds of 0.8, strains of 0.6 at the most.
TEST(StandingWave, BeginsAsAStandingWave) {
  const int cells = 32;
  const auto start = StandingWave({}, cells, 2).exact(0);
  for (std::size_t p = 0; p < start.size() / 2; ++p) {
    const double phase = std::acos(-1.0) * (static_cast<double>(p) + 0.5) / 2 / cells;
    EXPECT_NEAR(start[p], 0.8 * std::sin(phase), 1e-14);
    EXPECT_NEAR(start[start.size() / 2 + p], 0.6 * std::cos(phase), 1e-14);
  }
}

}  // namespace
}  // namespace plumbline::wave_test
