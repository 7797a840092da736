// Natural logarithms of a pack of numbers side by side: the library's are taken one by one.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "kernel/pack.hpp"

namespace plumbline {

// Off by less than one unit in the last place; of zero, of what is negative or not finite, and of numbers below the smallest
// normal one it is std::log. With x = 2^k (1 + f), sqrt(1/2) <= 1 + f < sqrt(2), and s = f / (2 + f),
//   ln x = k ln 2 + ln(1 + s) - ln(1 - s) = k ln 2 + f - f^2/2 + s (f^2/2 + R(s^2)),
// with the polynomial R of e_log.c of fdlibm (Sun Microsystems 1993), which is off by 2^-58.45.
[[gnu::always_inline]] inline Pack logarithm(const Pack& x) {
  using Limits = std::numeric_limits<double>;
  using Bits = PackBits;
  static_assert(sizeof(Bits) == sizeof(Pack) && Limits::is_iec559);
  if (!all_of(x >= Limits::min() && x <= Limits::max())) {
    return Pack([&](auto lane) { return std::log(static_cast<double>(x[lane])); });
  }
  constexpr int mantissa = 52;
  constexpr std::uint64_t one = std::bit_cast<std::uint64_t>(1.0);
  constexpr std::uint64_t least = std::bit_cast<std::uint64_t>(0x1.6a09e667f3bcdp-1);  // of 1 + f
  constexpr double two_52 = 0x1p52, bias = 1023;
  const Bits scaled = std::bit_cast<Bits>(x) + (one - least);
  // A number between 2^52 and 2^53 holds a whole one in its last bits.
  const Pack k = std::bit_cast<Pack>((scaled >> mantissa) | std::bit_cast<std::uint64_t>(two_52)) - (two_52 + bias);
  const Pack f = std::bit_cast<Pack>((scaled & ((1ull << mantissa) - 1)) + least) - 1.0;
  const Pack s = f / (2.0 + f), z = s * s, w = z * z, half_square = 0.5 * f * f;
  const Pack even = w * (3.999999999940941908e-01 + w * (2.222219843214978396e-01 + w * 1.531383769920937332e-01));
  const Pack odd = z * (6.666666666666735130e-01 +
                        w * (2.857142874366239149e-01 + w * (1.818357216161805012e-01 + w * 1.479819860511658591e-01)));
  constexpr double ln2_high = 6.93147180369123816490e-01, ln2_low = 1.90821492927058770002e-10;
  return k * ln2_high - ((half_square - (s * (half_square + (even + odd)) + k * ln2_low)) - f);
}

}  // namespace plumbline
