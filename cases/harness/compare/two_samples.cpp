#include "cases/harness/compare/two_samples.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace plumbline {
namespace {

// Probability of each value of Mann and Whitney's statistic, 0 ... m n, if both samples are drawn alike: the largest
// of all values belongs to the second sample with probability n/(m + n) and then exceeds m of the first.
std::vector<double> mann_whitney(std::size_t m, std::size_t n) {
  std::vector<std::vector<double>> rows(m + 1, std::vector<double>{1});  // for n = 0
  for (std::size_t j = 1; j <= n; ++j) {
    rows[0] = {1};
    for (std::size_t i = 1; i <= m; ++i) {
      std::vector<double> next(i * j + 1, 0.0);
      const double of_second = static_cast<double>(j) / static_cast<double>(i + j);
      const std::vector<double>& without_second = rows[i];     // (i, j - 1)
      const std::vector<double>& without_first = rows[i - 1];  // (i - 1, j)
      for (std::size_t u = 0; u < without_second.size(); ++u) next[u + i] += of_second * without_second[u];
      for (std::size_t u = 0; u < without_first.size(); ++u) next[u] += (1 - of_second) * without_first[u];
      rows[i] = std::move(next);
    }
  }
  return rows[m];
}

// How many of the sorted ratios the interval leaves out at each end; negative where none may be left in.
std::ptrdiff_t left_out(std::size_t m, std::size_t n) {
  const std::vector<double> probability = mann_whitney(m, n);
  double below = 0;
  std::ptrdiff_t count = -1;
  for (const double p : probability) {
    below += p;
    if (below > 0.025) break;
    ++count;
  }
  return count;
}

void require_times(std::span<const double> times) {
  if (times.empty()) throw std::invalid_argument("no times");
  for (const double t : times) {
    if (!(t > 0) || !std::isfinite(t)) throw std::invalid_argument("a time is not positive");
  }
}

}  // namespace

TimeRatio time_ratio(std::span<const double> first, std::span<const double> second) {
  require_times(first);
  require_times(second);
  std::vector<double> ratios;
  for (const double a : first) {
    for (const double b : second) ratios.push_back(b / a);
  }
  std::sort(ratios.begin(), ratios.end());
  const std::size_t count = ratios.size(), middle = count / 2;
  TimeRatio ratio;
  ratio.estimate = count % 2 == 1 ? ratios[middle] : std::sqrt(ratios[middle - 1] * ratios[middle]);
  const std::ptrdiff_t cut = left_out(first.size(), second.size());
  if (cut < 0) {
    ratio.high = std::numeric_limits<double>::infinity();
    return ratio;
  }
  ratio.low = ratios[static_cast<std::size_t>(cut)];
  ratio.high = ratios[count - 1 - static_cast<std::size_t>(cut)];
  return ratio;
}

}  // namespace plumbline
