#include "cases/catalog/coupled/damped_wave.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include "cases/catalog/coupled/crossings.hpp"
#include "cases/harness/run/extremes.hpp"

namespace plumbline {

std::optional<DampedWave> damped_wave(std::span<const double> times, std::span<const double> values) {
  const std::optional<double> period = crossing_period(times, values);
  const std::vector<Extreme> turns = find_extremes(times, values);
  if (!period || turns.size() < 2) return {};
  const Extreme &first = turns.front(), &last = turns.back();
  const double delta = std::log(std::abs(first.value / last.value)) / (last.time - first.time);
  DampedWave wave;
  wave.omega = std::hypot(2 * std::numbers::pi / *period, delta);
  wave.damping = delta / wave.omega;
  return wave;
}

}  // namespace plumbline
