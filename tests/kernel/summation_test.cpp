#include "kernel/summation.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace plumbline::summation_test {
namespace {

TEST(Summation, SmallSumsAreTakenInOrder) {
  EXPECT_EQ(block_sum<double>(0, [](int) { return 1.0; }), 0);
  EXPECT_EQ(block_sum<double>(block_points, [](int p) { return p + 1.0; }), block_points * (block_points + 1) / 2);
}

// Blocks depend on the number of points alone: the value is that of blocks summed in order, then pairwise.
TEST(Summation, LargeSumsAreBlockwiseThenPairwise) {
  const int n = 3 * block_points + 17;
  const auto term = [](int p) { return 1.0 / (p + 1); };
  double blocks[4] = {0, 0, 0, 0};
  for (int p = 0; p < n; ++p) blocks[p / block_points] += term(p);
  EXPECT_EQ(block_sum<double>(n, term), (blocks[0] + blocks[1]) + (blocks[2] + blocks[3]));
}

TEST(Summation, PairwiseSumOfNothingIsZero) {
  EXPECT_EQ(pairwise_sum<double>(nullptr, 0), 0);
  const std::vector<double> terms{1, 2, 3, 4, 5};
  EXPECT_EQ(pairwise_sum(terms.data(), terms.size()), 15);
}

// Plain summation loses the ones altogether: 1e16 + 1 = 1e16 in double. (Neumaier 1974)
TEST(Summation, RunningSumCarriesWhatRoundingDrops) {
  RunningSum sum;
  for (double term : {1.0, 1e16, 1.0, -1e16}) sum.add(term);
  EXPECT_EQ(sum.value(), 2);
  RunningSum tenths;
  for (int k = 0; k < 1000000; ++k) tenths.add(0.1);
  EXPECT_NEAR(tenths.value(), 1e5, 1.5e-11);  // a spacing of doubles there; plain summation is off by 1e-6
}

}  // namespace
}  // namespace plumbline::summation_test
