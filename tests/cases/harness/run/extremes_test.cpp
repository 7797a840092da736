// Synthetic histories with known extremes; the error allowed is that of the interpolating parabola.
#include "cases/harness/run/extremes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <numeric>
#include <random>
#include <stdexcept>

namespace plumbline::extremes_test {
namespace {

constexpr double pi = std::numbers::pi;

struct History {
  std::vector<double> times, values;
};

History sample(const std::function<double(double)>& signal, double begin, double end,
               const std::function<double()>& step) {
  History history;
  double t = begin;
  while (t < end) {
    history.times.push_back(t);
    history.values.push_back(signal(t));
    t += step();
  }
  return history;
}

double uniform(std::mt19937_64& engine) { return static_cast<double>(engine() >> 11) * 0x1p-53; }

constexpr double period = 0.0198592;  // the spring's, s
constexpr double omega = 2 * pi / period;
constexpr double amplitude = 0.0025;

double swing(double t) { return amplitude * (1 - std::cos(omega * t)); }

// Bounds of the header; the next order is smaller by (omega tau)^2, allowed for by the factor.
double next_order(double tau) { return 1 + omega * omega * tau * tau; }
double time_error(double tau) { return omega * omega * tau * tau * tau / (36 * std::sqrt(3)) * next_order(tau); }
double value_error(double tau) { return 3 * amplitude * std::pow(omega * tau, 4) / 128 * next_order(tau); }

TEST(Extremes, OfACosineToTheErrorOfTheParabola) {
  for (int samples : {12, 37, 100, 1001}) {
    const double tau = period / (samples + 0.37);  // no period is a whole number of steps: every position occurs
    const History history = sample(swing, 0, 20.2 * period, [&] { return tau; });
    const auto extremes = find_extremes(history.times, history.values);
    ASSERT_EQ(extremes.size(), 40u) << samples;
    for (std::size_t k = 0; k < extremes.size(); ++k) {
      const double exact = (static_cast<double>(k) + 1) * period / 2;
      EXPECT_EQ(extremes[k].maximum, k % 2 == 0);
      EXPECT_NEAR(extremes[k].time, exact, time_error(tau) + 1e-12 * exact);
      EXPECT_NEAR(extremes[k].value, k % 2 == 0 ? 2 * amplitude : 0, value_error(tau) + 1e-12 * amplitude);
    }
    // 19 whole periods on either side, two ends each wrong by at most the error of an extreme
    ASSERT_TRUE(mean_period(extremes));
    EXPECT_NEAR(*mean_period(extremes), period, 2 * time_error(tau) / 19 + 1e-12 * period);
  }
}

TEST(Extremes, TheBoundIsSharp) {
  const double tau = 0.01 * period;
  const double sample_off_extreme = tau / std::sqrt(12);  // where the parabola errs most
  const History history = sample(swing, period / 2 - sample_off_extreme - 2 * tau, 0.6 * period, [&] { return tau; });
  const auto extremes = find_extremes(history.times, history.values);
  ASSERT_EQ(extremes.size(), 1u);
  EXPECT_GT(std::abs(extremes[0].time - period / 2), 0.98 * omega * omega * tau * tau * tau / (36 * std::sqrt(3)));
}

TEST(Extremes, OfUnequalSteps) {
  std::mt19937_64 engine(7);
  const double tau = period / 40;
  const History history = sample(swing, 0, 50.2 * period, [&] { return tau * (0.1 + 0.9 * uniform(engine)); });
  const auto extremes = find_extremes(history.times, history.values);
  ASSERT_EQ(extremes.size(), 100u);
  const double bound = omega * omega * tau * tau * tau / 8 * next_order(tau);
  for (std::size_t k = 0; k < extremes.size(); ++k)
    EXPECT_NEAR(extremes[k].time, (static_cast<double>(k) + 1) * period / 2, bound);
}

TEST(Extremes, OfAParabolaAreExactForAnySteps) {
  const std::vector<double> times{1000, 1000.1, 1000.7, 1001.8, 1002.0};
  std::vector<double> values = times;
  for (double& value : values) value = 5 - 3 * (value - 1000.9) * (value - 1000.9);
  const auto extremes = find_extremes(times, values);
  ASSERT_EQ(extremes.size(), 1u);
  EXPECT_NEAR(extremes[0].time, 1000.9, 1e-12);  // some ulp of 1000
  EXPECT_NEAR(extremes[0].value, 5, 1e-12);
  EXPECT_TRUE(extremes[0].maximum);
}

TEST(Extremes, OfEqualSamplesLieInTheirMiddle) {
  const std::vector<double> times{0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
  const auto two = find_extremes(times, std::vector<double>{0, 1, 2, 3, 3, 2, 1, 1, 2, 3});
  ASSERT_EQ(two.size(), 2u);
  EXPECT_NEAR(two[0].time, 3.5, 1e-14);
  EXPECT_TRUE(two[0].maximum);
  EXPECT_NEAR(two[1].time, 6.5, 1e-14);
  EXPECT_FALSE(two[1].maximum);
  const auto flat = find_extremes(times, std::vector<double>{0, 1, 2, 2, 2, 2, 2, 1, 0, -1});
  ASSERT_EQ(flat.size(), 1u);
  EXPECT_NEAR(flat[0].time, 4, 1e-14);
  const auto step = find_extremes(times, std::vector<double>{0, 1, 1, 1, 2, 3, 3, 4, 5, 6});
  EXPECT_TRUE(step.empty());  // a landing on the way up is no extreme
}

TEST(Extremes, OfALopsidedFlatTopIsItsMiddle) {
  const std::vector<double> times{0, 1, 2, 3, 4, 5};
  const auto extremes = find_extremes(times, std::vector<double>{1.999, 2, 2, 2, 2, -1000});
  ASSERT_EQ(extremes.size(), 1u);
  EXPECT_EQ(extremes[0].time, 2.5);
  EXPECT_EQ(extremes[0].value, 2);
}

// Through a cusp the least-squares parabola bends upwards; the equal samples at the top decide.
TEST(Extremes, OfACuspUnderNoiseAreItsSamples) {
  for (int tail : {0, 20}) {  // the vertex lies outside the stretch, or inside
    std::vector<double> values{0, 89.9, 100, 100, 96, 93.5, 92, 91.2, 90.7, 90.4, 90.2, 90.1};
    for (int i = 0; i < tail; ++i) values.push_back(90.1 - 0.001 * i);
    values.insert(values.end(), {89.9, 50});
    std::vector<double> times(values.size());
    std::iota(times.begin(), times.end(), 0.0);
    const auto extremes = find_extremes(times, values, 1);
    ASSERT_EQ(extremes.size(), 1u);
    EXPECT_EQ(extremes[0].time, 2.5);
    EXPECT_EQ(extremes[0].value, 100);
  }
}

// Samples at 7 + u, u = -15..15, on 100 - 0.2 u^2; those at u = -3, -2, -1 are lifted by 2.3, 1.3, 0.7 to 100.5. The
// stretch is u = -11..11, sum u^2 = 1012: the lift tilts the parabola by -10.2/1012 and moves its vertex by that over
// 0.4. The middle of the equal samples would be two off.
TEST(Extremes, OfEqualSamplesUnderNoiseComeFromTheWholeStretch) {
  std::vector<double> times, values;
  for (int u = -15; u <= 15; ++u) {
    times.push_back(7 + u);
    values.push_back(-3 <= u && u <= -1 ? 100.5 : 100 - 0.2 * u * u);
  }
  const auto extremes = find_extremes(times, values, 2.3);
  ASSERT_EQ(extremes.size(), 1u);
  EXPECT_NEAR(extremes[0].time, 7 - 10.2 / 1012 / 0.4, 0.005);
}

TEST(Extremes, EndsAndMonotoneOrConstantHistoriesHaveNone) {
  const std::vector<double> times{0, 1, 2, 3};
  EXPECT_TRUE(find_extremes(times, std::vector<double>{0, 1, 2, 3}).empty());
  EXPECT_TRUE(find_extremes(times, std::vector<double>{3, 2, 1, 0}).empty());
  EXPECT_TRUE(find_extremes(times, std::vector<double>{1, 1, 1, 1}).empty());
  EXPECT_TRUE(find_extremes({}, {}).empty());
  EXPECT_EQ(find_extremes(times, std::vector<double>{0, 2, 1, 0}).size(), 1u);
}

TEST(Extremes, SurviveNoise) {
  const double noise = 0.002 * amplitude, tau = period / 2000;
  std::mt19937_64 engine(11);
  const History history = sample([&](double t) { return swing(t) + noise * (2 * uniform(engine) - 1); }, 0.1 * period,
                                 20.3 * period, [&] { return tau; });
  EXPECT_GT(find_extremes(history.times, history.values).size(), 400u);  // taken at face value
  const auto extremes = find_extremes(history.times, history.values, noise);
  ASSERT_EQ(extremes.size(), 40u);
  // Slope of a least-squares line over a stretch +-T with N samples of deviation sigma: sigma sqrt(3/N)/T.
  // Divided by the curvature a omega^2 it is the deviation of the vertex. The stretch is 10 noise deep:
  // a (omega T)^2/2.
  const double half = std::sqrt(2 * 10 * noise / amplitude) / omega;
  const double sigma = noise / std::sqrt(3);
  const double deviation = sigma * std::sqrt(3 / (2 * half / tau)) / half / (amplitude * omega * omega);
  for (std::size_t k = 0; k < extremes.size(); ++k)
    EXPECT_NEAR(extremes[k].time, (static_cast<double>(k) + 1) * period / 2, 4 * deviation);
  EXPECT_NEAR(*mean_period(extremes), period, 4 * deviation * std::sqrt(2) / 19);
}

TEST(Extremes, NoiseOfZeroDepthLeavesACleanSignalAlone) {
  const History history = sample(swing, 0, 5.2 * period, [] { return period / 30; });
  const auto plain = find_extremes(history.times, history.values);
  const auto tolerant = find_extremes(history.times, history.values, 1e-12 * amplitude);
  ASSERT_EQ(plain.size(), tolerant.size());
  for (std::size_t k = 0; k < plain.size(); ++k) EXPECT_DOUBLE_EQ(plain[k].time, tolerant[k].time);
}

TEST(Extremes, RejectWhatIsNoHistory) {
  const std::vector<double> times{0, 1, 2}, values{0, 1, 0};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(find_extremes(times, std::vector<double>{0, 1}), std::invalid_argument);
  EXPECT_THROW(find_extremes(times, std::vector<double>{0, nan, 0}), std::invalid_argument);
  EXPECT_THROW(find_extremes(std::vector<double>{0, nan, 2}, values), std::invalid_argument);
  EXPECT_THROW(find_extremes(std::vector<double>{0, 0, 2}, values), std::invalid_argument);
  EXPECT_THROW(find_extremes(std::vector<double>{0, 2, 1}, values), std::invalid_argument);
  EXPECT_THROW(find_extremes(std::vector<double>{0, 1, std::numeric_limits<double>::infinity()}, values),
               std::invalid_argument);
  EXPECT_THROW(find_extremes(times, values, nan), std::invalid_argument);
  EXPECT_THROW(find_extremes(times, values, -1), std::invalid_argument);
}

TEST(MeanPeriod, TakesWholePeriodsOfOneKind) {
  // An asymmetric swing: minima follow maxima after 0.3, yet the period is 1.
  std::vector<Extreme> extremes{{0.0, 1, true}, {0.3, 0, false}, {1.0, 1, true}, {1.3, 0, false}, {2.0, 1, true}};
  EXPECT_DOUBLE_EQ(*mean_period(extremes), 1);
  extremes.resize(3);
  EXPECT_DOUBLE_EQ(*mean_period(extremes), 1);
  extremes.resize(2);
  EXPECT_FALSE(mean_period(extremes));
  EXPECT_FALSE(mean_period({}));
}

TEST(MeanPeriod, WeighsEveryPeriodTheSame) {
  const std::vector<Extreme> drifting{{0, 1, true}, {0.5, 0, false}, {1, 1, true}, {1.9, 0, false}, {2.2, 1, true}};
  EXPECT_DOUBLE_EQ(*mean_period(drifting), (1 + 1.2 + 1.4) / 3);
}

}  // namespace
}  // namespace plumbline::extremes_test
