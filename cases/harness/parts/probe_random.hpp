// Random numbers of gates: fixed by a seed, the same with every standard library.
#pragma once

#include <random>

namespace plumbline {

// Uniform.
class ProbeRandom {
 public:
  explicit ProbeRandom(unsigned long seed) : engine_(seed) {}
  double operator()(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace plumbline
