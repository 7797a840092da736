// Sums whose value depends on the terms and their order alone, never on threads, and that lose few digits.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace plumbline {

// Points per block of a global sum. Blocks are summed in order, then pairwise.
inline constexpr int block_points = 256;

// Pairwise sum of block results. T needs + and value initialisation.
template <class T>
T pairwise_sum(const T* terms, std::size_t count) {
  if (count == 0) return T{};
  if (count == 1) return terms[0];
  const std::size_t half = count / 2;
  return pairwise_sum(terms, half) + pairwise_sum(terms + half, count - half);
}

// sum over p in [0, points) of term(p), blockwise. T is double or a struct of sums with operator+=, operator+.
template <class T, class Term>
T block_sum(int points, Term&& term) {
  if (points <= block_points) {
    T sum{};
    for (int p = 0; p < points; ++p) sum += term(p);
    return sum;
  }
  std::vector<T> blocks(static_cast<std::size_t>((points + block_points - 1) / block_points));
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const int start = static_cast<int>(b) * block_points;
    const int end = start + block_points < points ? start + block_points : points;
    T sum{};
    for (int p = start; p < end; ++p) sum += term(p);
    blocks[b] = sum;
  }
  return pairwise_sum(blocks.data(), blocks.size());
}

// Running sum over many steps with a carried correction. (Neumaier 1974, doi 10.1002/zamm.19740540106)
class RunningSum {
 public:
  void add(double term) {
    const double next = sum_ + term;
    correction_ += std::abs(sum_) >= std::abs(term) ? (sum_ - next) + term : (term - next) + sum_;
    sum_ = next;
  }
  double value() const { return sum_ + correction_; }

 private:
  double sum_ = 0, correction_ = 0;
};

}  // namespace plumbline
