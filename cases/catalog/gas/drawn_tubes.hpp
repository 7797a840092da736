// Riemann problems drawn at random, the same ones with any compiler and standard library.
#pragma once

#include <cstdint>
#include <vector>

#include "cases/catalog/gas/shock_tube.hpp"

namespace plumbline {

// A tube of 1 m with its diaphragm in the middle, and what it was drawn by.
struct DrawnTube {
  double density_ratio = 1,
         pressure_ratio = 1;  // right over left, 1/100 ... 100; left of the diaphragm 1 kg/m^3 and 1 Pa
  double parting = 0;  // velocity of the right gas from the left one over the mean of both speeds of sound, -1 ... 1
  ShockTube tube;
};

// The share of a half of the tube that the fastest wave has travelled at the end: a tenth of the tube stays undisturbed
// at either end, ten of a hundred cells, so that a wave spread over some cells does not reach it.
inline constexpr double travelled = 0.8;

// `seed`: of the 64-bit Mersenne twister.
std::vector<DrawnTube> drawn_tubes(int count, std::uint64_t seed);

}  // namespace plumbline
