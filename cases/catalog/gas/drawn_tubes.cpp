#include "cases/catalog/gas/drawn_tubes.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace plumbline {
namespace {

// In [0, 1): the upper 53 bits of the generator, whose output the standard prescribes; that of its distributions it does not.
double share(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }

double within(double low, double high, std::mt19937_64& random) { return low + (high - low) * share(random); }

// As probable as its inverse: either side is the larger one.
double ratio(std::mt19937_64& random) { return std::pow(100, within(-1, 1, random)); }

double speed_of_sound(const reference::GasState& gas, double gamma) {
  return std::sqrt(gamma * gas.pressure / gas.density);
}

// The mean of both speeds of sound measures the relative velocity: what velocities drive then compares with what
// pressures drive in each draw. In units of the smaller one both gases would be all but at rest where the two differ.
// A vacuum needs 4/(gamma - 1) of the mean (Toro, section 4.6), 5.97 at least.
DrawnTube drawn_tube(std::mt19937_64& random) {
  DrawnTube drawn;
  drawn.density_ratio = ratio(random);
  drawn.pressure_ratio = ratio(random);
  drawn.parting = within(-1, 1, random);
  auto& [left, right, gamma] = drawn.tube.states;
  gamma = within(1.2, 1.67, random);
  left = {1, 0, 1};
  right = {drawn.density_ratio, 0, drawn.pressure_ratio};
  const double mean = (speed_of_sound(left, gamma) + speed_of_sound(right, gamma)) / 2;
  left.velocity = -drawn.parting * mean / 2;
  right.velocity = -left.velocity;
  double fastest = 0;
  for (const double speed : reference::RiemannSolution(drawn.tube.states).jumps()) {
    fastest = std::max(fastest, std::abs(speed));
  }
  drawn.tube.end_time = travelled * (drawn.tube.high - drawn.tube.diaphragm) / fastest;
  return drawn;
}

}  // namespace

std::vector<DrawnTube> drawn_tubes(int count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<DrawnTube> all;
  for (int k = 0; k < count; ++k) all.push_back(drawn_tube(random));
  return all;
}

}  // namespace plumbline
