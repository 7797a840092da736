// A damped oscillation, read from its zeros and its extremes.
#pragma once

#include <optional>
#include <span>

namespace plumbline {

struct DampedWave {
  double omega = 0;    // sqrt(omega_d^2 + delta^2), rad/s: that without damping
  double damping = 0;  // delta/omega: of e^(-delta t) cos(omega_d t + phi)
};

// omega_d comes from the period between crossings (crossings.hpp), delta from the sizes of the first and the last
// extreme (extremes.hpp). Empty without two crossings of one direction or two extremes. Throws std::invalid_argument
// for different lengths.
std::optional<DampedWave> damped_wave(std::span<const double> times, std::span<const double> values);

}  // namespace plumbline
