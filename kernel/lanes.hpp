// Numbers side by side in one register, and which of them a condition holds for. Vectors of the compiler: what the header
// <experimental/simd> of the library makes of them takes the compiler longer, and with it the loops of the shapes.
#pragma once

#if defined(__AVX__)
#include <immintrin.h>
#endif

#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace plumbline {

#if defined(__AVX512F__)
inline constexpr int lanes = 8;
#elif defined(__AVX__)
inline constexpr int lanes = 4;
#else
inline constexpr int lanes = 2;
#endif

// As whole numbers, for what is made of the bits of a pack.
using PackBits [[gnu::vector_size(lanes * sizeof(double))]] = std::uint64_t;

// A condition, lane by lane.
class PackMask {
 public:
  using Lanes [[gnu::vector_size(lanes * sizeof(double))]] = std::int64_t;  // all bits set where it holds, else none

  PackMask() = default;
  explicit PackMask(Lanes lanes_held) : held_(lanes_held) {}

  Lanes held() const { return held_; }
  bool operator[](std::size_t lane) const { return held_[lane] != 0; }

  friend PackMask operator&&(const PackMask& a, const PackMask& b) { return PackMask(a.held_ & b.held_); }
  friend PackMask operator||(const PackMask& a, const PackMask& b) { return PackMask(a.held_ | b.held_); }
  friend PackMask operator!(const PackMask& a) { return PackMask(~a.held_); }

 private:
  Lanes held_;
};

class Pack {
 public:
  using Lanes [[gnu::vector_size(lanes * sizeof(double))]] = double;

  Pack() = default;
  Pack(double all) : lanes_(all - Lanes{}) {}
  explicit Pack(Lanes values) : lanes_(values) {}
  // of(lane) for each.
  template <std::invocable<std::size_t> Of>
  explicit Pack(Of&& of) {
    for (std::size_t lane = 0; lane < lanes; ++lane) lanes_[lane] = of(lane);
  }

  Lanes values() const { return lanes_; }
  double operator[](std::size_t lane) const { return lanes_[lane]; }

  Pack operator-() const { return Pack(-lanes_); }
  Pack& operator+=(const Pack& o) { return *this = *this + o; }
  Pack& operator-=(const Pack& o) { return *this = *this - o; }
  Pack& operator*=(const Pack& o) { return *this = *this * o; }
  Pack& operator/=(const Pack& o) { return *this = *this / o; }

  friend Pack operator+(const Pack& a, const Pack& b) { return Pack(a.lanes_ + b.lanes_); }
  friend Pack operator-(const Pack& a, const Pack& b) { return Pack(a.lanes_ - b.lanes_); }
  friend Pack operator*(const Pack& a, const Pack& b) { return Pack(a.lanes_ * b.lanes_); }
  friend Pack operator/(const Pack& a, const Pack& b) { return Pack(a.lanes_ / b.lanes_); }

  friend PackMask operator<(const Pack& a, const Pack& b) { return mask(a.lanes_ < b.lanes_); }
  friend PackMask operator>(const Pack& a, const Pack& b) { return mask(a.lanes_ > b.lanes_); }
  friend PackMask operator<=(const Pack& a, const Pack& b) { return mask(a.lanes_ <= b.lanes_); }
  friend PackMask operator>=(const Pack& a, const Pack& b) { return mask(a.lanes_ >= b.lanes_); }
  friend PackMask operator==(const Pack& a, const Pack& b) { return mask(a.lanes_ == b.lanes_); }
  friend PackMask operator!=(const Pack& a, const Pack& b) { return mask(a.lanes_ != b.lanes_); }
  friend PackMask isnan(const Pack& a) { return a != a; }

 private:
  template <class Held>
  static PackMask mask(const Held& held) {
    return PackMask((PackMask::Lanes)held);
  }

  Lanes lanes_;
};

// Where `mask` holds `a`, else `b`; the same of one number.
inline double choose(bool held, double a, double b) { return held ? a : b; }
inline Pack choose(const PackMask& mask, const Pack& a, const Pack& b) {
  return Pack(mask.held() ? a.values() : b.values());
}

inline bool any_of(const PackMask& mask) {
#if defined(__AVX__) && !defined(__AVX512F__)
  return _mm256_movemask_pd((__m256d)mask.held()) != 0;
#else
  std::int64_t any = 0;
  for (std::size_t lane = 0; lane < lanes; ++lane) any |= mask.held()[lane];
  return any != 0;
#endif
}
inline bool none_of(const PackMask& mask) { return !any_of(mask); }
inline bool all_of(const PackMask& mask) { return !any_of(!mask); }

// The first lane that a condition holds for; there is one.
inline int find_first_set(const PackMask& mask) {
  int lane = 0;
  while (!mask[static_cast<std::size_t>(lane)]) ++lane;
  return lane;
}

// Of numbers of which none is a NaN; of others the second, as the instructions have it.
inline Pack min(const Pack& a, const Pack& b) {
#if defined(__AVX__) && !defined(__AVX512F__)
  return Pack(_mm256_min_pd(a.values(), b.values()));
#else
  return choose(a < b, a, b);
#endif
}
inline Pack max(const Pack& a, const Pack& b) {
#if defined(__AVX__) && !defined(__AVX512F__)
  return Pack(_mm256_max_pd(a.values(), b.values()));
#else
  return choose(a > b, a, b);
#endif
}
// The smallest and the largest lane.
inline double hmin(const Pack& a) {
  double least = a[0];
  for (std::size_t lane = 1; lane < lanes; ++lane) least = a[lane] < least ? a[lane] : least;
  return least;
}
inline double hmax(const Pack& a) {
  double most = a[0];
  for (std::size_t lane = 1; lane < lanes; ++lane) most = a[lane] > most ? a[lane] : most;
  return most;
}

inline Pack sqrt(const Pack& a) {
#if defined(__AVX__) && !defined(__AVX512F__)
  return Pack(_mm256_sqrt_pd(a.values()));
#else
  return Pack([&](std::size_t lane) { return std::sqrt(a[lane]); });
#endif
}
inline Pack floor(const Pack& a) {
#if defined(__AVX__) && !defined(__AVX512F__)
  return Pack(_mm256_floor_pd(a.values()));
#else
  return Pack([&](std::size_t lane) { return std::floor(a[lane]); });
#endif
}
inline Pack abs(const Pack& a) {
  return Pack((Pack::Lanes)((PackBits)a.values() & std::numeric_limits<std::int64_t>::max()));
}

}  // namespace plumbline
