#include "reference/interlacing.hpp"

#include "reference/root.hpp"

namespace plumbline::reference {
namespace {

std::vector<double> merge(double first, double second, int count, double factor) {
  std::vector<double> all;
  all.reserve(static_cast<std::size_t>(count));
  for (int i = 1, j = 1; i + j <= count + 1;) {
    const bool from_first = i * first <= j * second;
    all.push_back((from_first ? i++ * first : j++ * second) * factor);
  }
  return all;
}

}  // namespace

// A trial x below the upper pole where f is certainly negative lies below the root, even if it lies below the lower pole
// as well; the same holds above. So enclose_root certifies, as long as its guess is between the poles.
Bounded root_between(const std::function<Bounded(double)>& f, const std::function<double(double)>& slope, Bounded below,
                     Bounded above) {
  const double low = highest(below) * rounding::inflate, high = lowest(above) / rounding::inflate;
  const double least = lowest(below), greatest = highest(above);
  if (!(low < high)) {
    const double middle = 0.5 * (least + greatest), half = 0.5 * (greatest - least);
    return {middle, half * rounding::inflate + 2 * rounding::unit * std::abs(middle)};
  }
  auto value = [&f](double x) { return f(x).value; };
  // Within rounding the root may fall on a pole; the enclosure still finds its bound.
  const double x = value(low) >= 0 ? low : value(high) <= 0 ? high : brent_root(value, low, high);
  return enclose_root(f, x, slope(x), least, greatest);
}

std::vector<Bounded> merged_multiples(Bounded first, Bounded second, int count) {
  const bool one = std::isinf(second.value);
  const double infinity = rounding::infinity;
  // The n-th smallest number never decreases when any of them grows: lower and upper ends may be merged apart.
  const std::vector<double> low = merge(lowest(first), one ? infinity : lowest(second), count, 1 / rounding::inflate);
  const std::vector<double> high = merge(highest(first), one ? infinity : highest(second), count, rounding::inflate);
  std::vector<Bounded> poles;
  poles.reserve(low.size());
  for (std::size_t n = 0; n < low.size(); ++n) {
    const double middle = 0.5 * (low[n] + high[n]);
    poles.emplace_back(middle, 0.5 * (high[n] - low[n]) * rounding::inflate + rounding::unit * middle);
  }
  return poles;
}

}  // namespace plumbline::reference
