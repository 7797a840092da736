// Two samples of times: how many times longer the second takes, with a 95 % interval that supposes no distribution.
#pragma once

#include <span>

namespace plumbline {

struct TimeRatio {
  double estimate = 1;       // of the second over the first
  double low = 0, high = 0;  // 95 % interval; (0, inf) where the samples are too small to have one
};

// Smallest samples that have a 95 % interval: with three and three the surest order of all has the probability 1/20.
inline constexpr std::size_t least_samples = 4;

// The median of all ratios second_j/first_i (Hodges and Lehmann, of the logarithms), and the ratios that the exact
// distribution of Mann and Whitney's statistic cuts off at 2.5 % either side [Hollander, Wolfe, Chicken 2014, 4.2, 4.3].
// Times > 0 in any one unit. Throws std::invalid_argument on an empty sample or a time that is not positive.
TimeRatio time_ratio(std::span<const double> first, std::span<const double> second);

}  // namespace plumbline
