#include "cases/catalog/coupled/crossings.hpp"

#include <stdexcept>

namespace plumbline {

std::optional<double> crossing_period(std::span<const double> times, std::span<const double> values) {
  if (times.size() != values.size()) throw std::invalid_argument("times and values differ in number");
  struct Direction {
    double first = 0, last = 0;
    int crossings = 0;
  } up, down;
  for (std::size_t k = 1; k < times.size(); ++k) {
    const double a = values[k - 1], b = values[k];
    if ((a >= 0) == (b >= 0)) continue;
    Direction& way = b >= 0 ? up : down;
    way.last = times[k - 1] + (times[k] - times[k - 1]) * a / (a - b);
    if (way.crossings++ == 0) way.first = way.last;
  }
  double time = 0;
  int periods = 0;
  for (const Direction& way : {up, down}) {
    if (way.crossings < 2) continue;
    time += way.last - way.first;
    periods += way.crossings - 1;
  }
  if (periods == 0) return {};
  return time / periods;
}

}  // namespace plumbline
