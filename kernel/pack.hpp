// A few points side by side: one lane each, as many as the instruction set has. Loops over the points of a bin work on
// packs; the lanes of a last, partial pack beyond `count` hold whatever follows and are neither stored nor summed.
#pragma once

#if defined(__AVX2__)
#include <immintrin.h>
#endif

#include <experimental/simd>

namespace plumbline {

using Pack = std::experimental::native_simd<double>;
using PackMask = Pack::mask_type;
inline constexpr int lanes = static_cast<int>(Pack::size());

[[gnu::always_inline]] inline PackMask first_lanes(int count) {
  return Pack([](auto lane) { return static_cast<double>(lane); }) < static_cast<double>(count);
}

// `at` must have `lanes` readable values, see Columns.
[[gnu::always_inline]] inline Pack load(const double* at) { return Pack(at, std::experimental::element_aligned); }

// Stores the first `count` lanes.
[[gnu::always_inline]] inline void store(double* at, const Pack& value, int count) {
  if (count >= lanes) {
    value.copy_to(at, std::experimental::element_aligned);
  } else {
    std::experimental::where(first_lanes(count), value).copy_to(at, std::experimental::element_aligned);
  }
}

// Stores the first `count` lanes, which hold whole numbers.
[[gnu::always_inline]] inline void store_as_integers(int* at, const Pack& value, int count) {
  using Integers = std::experimental::rebind_simd_t<int, Pack>;
  const auto whole = std::experimental::static_simd_cast<Integers>(value);
  if (count >= lanes) {
    whole.copy_to(at, std::experimental::element_aligned);
  } else {
    for (int k = 0; k < count; ++k) at[k] = whole[k];
  }
}

// The first `count` lanes, the others zero.
[[gnu::always_inline]] inline Pack kept(const Pack& value, int count) {
  if (count >= lanes) return value;
  Pack zero = 0.0;
  std::experimental::where(first_lanes(count), zero) = value;
  return zero;
}

[[gnu::always_inline]] inline double sum(const Pack& value) { return std::experimental::reduce(value); }

// Where `mask` holds `a`, else `b`.
[[gnu::always_inline]] inline Pack choose(const PackMask& mask, const Pack& a, Pack b) {
  std::experimental::where(mask, b) = a;
  return b;
}

// Calls visit(p, count) for packs of points first ... last-1; `count` lanes of each are points.
template <class Visit>
[[gnu::always_inline]] inline void for_packs(int first, int last, Visit&& visit) {
  for (int p = first; p < last; p += lanes) visit(p, last - p < lanes ? last - p : lanes);
}

// totals[k] = sum(packs[k]), four at a time in the order in which sum() adds: halves, then what is left.
template <int count>
[[gnu::always_inline]] inline void sum_lanes(const Pack (&packs)[count], double (&totals)[count]) {
  int k = 0;
#if defined(__AVX2__)
  const auto halves = [&](int i) __attribute__((always_inline)) {
    const auto a = static_cast<__m256d>(packs[i]), b = static_cast<__m256d>(packs[i + 1]);
    return _mm256_add_pd(_mm256_permute2f128_pd(a, b, 0x20), _mm256_permute2f128_pd(a, b, 0x31));
  };
  for (; lanes == 4 && k + 4 <= count; k += 4) {
    const __m256d mixed = _mm256_hadd_pd(halves(k), halves(k + 2));  // of packs k, k + 2, k + 1, k + 3
    _mm256_storeu_pd(totals + k, _mm256_permute4x64_pd(mixed, 0xd8));
  }
#endif
  for (; k < count; ++k) totals[k] = sum(packs[k]);
}

}  // namespace plumbline
