// A few points side by side: one lane each, as many as the instruction set has. Loops over the points of a bin work on
// packs; the lanes of a last, partial pack beyond `count` hold whatever follows and are neither stored nor summed.
#pragma once

#include <cstdint>
#include <cstring>

#include "kernel/lanes.hpp"

namespace plumbline {

// 0 <= count <= lanes. Read from a list: making it of the count takes twice as long.
[[gnu::always_inline]] inline PackMask first_lanes(int count) {
  static constexpr std::int64_t all_then_none[] = {-1, -1, -1, -1, -1, -1, -1, -1, 0, 0, 0, 0, 0, 0, 0, 0};
  static_assert(2 * lanes <= sizeof all_then_none / sizeof all_then_none[0]);
  PackMask::Lanes mask;
  std::memcpy(&mask, all_then_none + 8 - count, sizeof mask);
  return PackMask(mask);
}

// `at` must have `lanes` readable values, see Columns.
[[gnu::always_inline]] inline Pack load(const double* at) {
  Pack::Lanes values;
  std::memcpy(&values, at, sizeof values);
  return Pack(values);
}

// Stores the first `count` lanes.
[[gnu::always_inline]] inline void store(double* at, const Pack& value, int count) {
  if (count >= lanes) {
    const Pack::Lanes values = value.values();
    std::memcpy(at, &values, sizeof values);
  } else {
#if defined(__AVX__) && !defined(__AVX512F__)
    _mm256_maskstore_pd(at, (__m256i)first_lanes(count).held(), value.values());
#else
    for (int k = 0; k < count; ++k) at[k] = value[static_cast<std::size_t>(k)];
#endif
  }
}

// The same of lanes that hold whole numbers.
[[gnu::always_inline]] inline void store_as_integers(int* at, const Pack& value, int count) {
  for (int k = 0; k < count; ++k) at[k] = static_cast<int>(value[static_cast<std::size_t>(k)]);
}

// The first `count` lanes, the others zero, whatever they hold.
[[gnu::always_inline]] inline Pack kept(const Pack& value, int count) {
  return Pack((Pack::Lanes)((PackMask::Lanes)value.values() & first_lanes(count).held()));
}

[[gnu::always_inline]] inline double sum(const Pack& value) {
  double half[lanes / 2];
  for (std::size_t k = 0; k < lanes / 2; ++k) half[k] = value[k] + value[k + lanes / 2];
  for (int length = lanes / 4; length > 0; length /= 2) {
    for (int k = 0; k < length; ++k) half[k] += half[k + length];
  }
  return half[0];
}

// Calls visit(p, count) for packs of points first ... last-1; `count` lanes of each are points.
template <class Visit>
[[gnu::always_inline]] inline void for_packs(int first, int last, Visit&& visit) {
  for (int p = first; p < last; p += lanes) visit(p, last - p < lanes ? last - p : lanes);
}

// sum(packs[k]) in lane k for the first `count` lanes, added in the order of sum(); what the others hold is of no use.
template <int count>
[[gnu::always_inline]] inline Pack lane_sums(const Pack* packs) {
  static_assert(count <= lanes);
#if defined(__AVX__) && !defined(__AVX512F__)
  const auto pack = [&](int k) { return packs[k < count ? k : 0].values(); };
  const auto halves = [](Pack::Lanes a, Pack::Lanes b) {
    return _mm256_add_pd(_mm256_permute2f128_pd(a, b, 0x20), _mm256_permute2f128_pd(a, b, 0x31));
  };
  // Sums of the packs 0 and 2, then 1 and 3.
  return Pack(_mm256_hadd_pd(halves(pack(0), pack(2)), halves(pack(1), pack(3))));
#else
  return Pack([&](std::size_t k) { return k < count ? sum(packs[k]) : 0.0; });
#endif
}

// Adds sum(sums[k]) to values[k].
template <int count>
[[gnu::always_inline]] inline void add_lane_sums(const Pack* sums, double* values) {
  constexpr int rest = count % lanes;
  for (int k = 0; k + lanes <= count; k += lanes)
    store(values + k, load(values + k) + lane_sums<lanes>(sums + k), lanes);
  if constexpr (rest > 0) {
    const Pack last = lane_sums<rest>(sums + (count - rest));
    for (int k = 0; k < rest; ++k) values[count - rest + k] += last[static_cast<std::size_t>(k)];
  }
}

}  // namespace plumbline
