#include "kernel/logarithm.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/kernel/scenes.hpp"

namespace plumbline::logarithm_test {
namespace {

constexpr double inf = HUGE_VAL, nan = std::numeric_limits<double>::quiet_NaN();
using Limits = std::numeric_limits<double>;

std::vector<double> logarithms(std::vector<double> x) {
  const std::size_t count = x.size();
  x.resize(count + static_cast<std::size_t>(lanes), 1.0);
  std::vector<double> result(x.size());
  for_packs(0, static_cast<int>(count),
            [&](int p, int) { store(result.data() + p, logarithm(load(x.data() + p)), lanes); });
  result.resize(count);
  return result;
}

// In units in the last place of the logarithm, of which extended precision is taken as exact.
double largest_error(const std::vector<double>& x) {
  const std::vector<double> logs = logarithms(x);
  double largest = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    const long double exact = std::log(static_cast<long double>(x[k]));
    const double rounded = std::abs(static_cast<double>(exact)), unit = std::nextafter(rounded, inf) - rounded;
    largest = std::max(largest, static_cast<double>(std::abs(static_cast<long double>(logs[k]) - exact)) / unit);
  }
  return largest;
}

TEST(Logarithm, IsPreciseToOneUnitInTheLastPlace) {
  scenes::Random random(5);
  std::vector<double> usual, near_one, wide;
  for (int k = 0; k < 100000; ++k) {
    usual.push_back(random(0.2, 3));
    near_one.push_back(1 + random(-1, 1) * std::pow(10, random(-15, -1)));
    wide.push_back(std::pow(10, random(-307, 308)));
  }
  EXPECT_LT(largest_error(usual), 1);
  EXPECT_LT(largest_error(near_one), 1);
  EXPECT_LT(largest_error(wide), 1);
  EXPECT_LT(largest_error({Limits::min(), Limits::max(), 2, 0.5, std::sqrt(0.5), std::nextafter(std::sqrt(0.5), 0),
                           std::sqrt(2), std::nextafter(1, 0), std::nextafter(1, 2)}),
            1);
}

TEST(Logarithm, OfOneIsZero) { EXPECT_EQ(logarithms({1}), std::vector<double>{0}); }

// One such number in a pack changes no other lane but by rounding.
TEST(Logarithm, OfWhatIsNotPositiveIsNoNumber) {
  for (int lane = 0; lane < lanes; ++lane) {
    for (double x : {0.0, -0.0, -1.0, -inf, inf, nan, Limits::denorm_min(), Limits::min() / 4, -Limits::min()}) {
      std::vector<double> all(static_cast<std::size_t>(lanes), 3.0);
      all[static_cast<std::size_t>(lane)] = x;
      const std::vector<double> logs = logarithms(all);
      for (int k = 0; k < lanes; ++k) {
        const double own = logs[static_cast<std::size_t>(k)], expected = std::log(all[static_cast<std::size_t>(k)]);
        if (std::isnan(expected)) {
          EXPECT_TRUE(std::isnan(own)) << x;
        } else if (std::isinf(expected)) {
          EXPECT_EQ(own, expected) << x;
        } else {
          EXPECT_NEAR(own, expected, Limits::epsilon() * std::abs(expected)) << x;
        }
      }
    }
  }
}

}  // namespace
}  // namespace plumbline::logarithm_test
