// What this machine can do at best, measured: the limits that the speed of a step is compared with.
#pragma once

#include <cstddef>
#include <optional>

namespace plumbline {

// Bytes read and written per second by copying arrays, `bytes` in all (both ends, all threads), on `threads` threads at
// once. Arrays that fit a cache show that cache's speed. bytes >= 1024, threads >= 1.
double copy_rate(std::size_t bytes, int threads);

// Floating-point operations per second of independent products with a sum, in packs as wide as the build's instruction set
// allows, on `threads` threads at once; fused where the machine can, and then counted as two. threads >= 1.
double fma_rate(int threads);

// Bytes that the program has allocated and not given back; nothing where the C library does not tell.
std::optional<double> allocated_bytes();

}  // namespace plumbline
