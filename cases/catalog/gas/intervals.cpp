#include "cases/catalog/gas/intervals.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "cases/harness/files/whole.hpp"

namespace plumbline {
namespace {

// Solves integral of `measure` from `in.from` to s = wanted, by Newton's method kept inside the interval.
double invert(const std::function<double(double)>& measure, const Interval& in, double whole, double wanted) {
  double low = in.from, high = in.to, s = in.from + in.length() * wanted / whole;
  for (int round = 0; round < 60; ++round) {
    const double error = integral(measure, {in.from, s}) - wanted;
    (error > 0 ? high : low) = s;
    const double next = s - error / measure(s);
    const double kept = next > low && next < high ? next : 0.5 * (low + high);
    if (std::abs(error) <= 4e-16 * whole || kept == s) break;
    s = kept;
  }
  return s;
}

}  // namespace

double integral(const std::function<double(double)>& f, const Interval& over) {
  double mean = 0;
  for (const GaussPoint& at : gauss_points) mean += at.weight * f(over.middle() + at.place * over.length());
  return mean * over.length();
}

double weighted_mean(const std::function<double(double)>& f, const std::function<double(double)>& w,
                     const Interval& over) {
  const double middle = f(over.middle());
  double above = 0, total = 0;
  for (const GaussPoint& at : gauss_points) {
    const double s = over.middle() + at.place * over.length(), weight = at.weight * w(s);
    above += weight * (f(s) - middle);
    total += weight;
  }
  return middle + above / total;
}

std::vector<Interval> layers(double low, double high, const std::vector<double>& jumps) {
  std::vector<double> edges{low};
  for (const double jump : jumps) {
    if (jump > edges.back() && jump < high) edges.push_back(jump);
  }
  edges.push_back(high);
  std::vector<Interval> all;
  for (std::size_t k = 0; k + 1 < edges.size(); ++k) all.push_back({edges[k], edges[k + 1]});
  return all;
}

double largest(const std::function<double(double)>& f, const std::vector<Interval>& layers) {
  constexpr int parts = 64;
  double value = -HUGE_VAL;
  for (const Interval& layer : layers) {
    // A thousandth of a part off the jumps.
    for (int k = 0; k <= parts; ++k) {
      const double share = std::clamp(static_cast<double>(k), 1e-3, parts - 1e-3) / parts;
      value = std::max(value, f(layer.from + share * layer.length()));
    }
  }
  return value;
}

std::vector<Interval> equal_shares(const Interval& layer, const std::function<double(double)>& measure) {
  // The cumulative measure over parts short enough for the quadrature; at least 64, about one an interval.
  const double estimate = integral(measure, layer);
  const int parts = static_cast<int>(std::clamp(estimate, 64.0, 1e7));
  const auto edge = [&](int k) { return k == parts ? layer.to : layer.from + layer.length() * k / parts; };
  std::vector<double> cumulative{0};
  for (int k = 0; k < parts; ++k) cumulative.push_back(cumulative.back() + integral(measure, {edge(k), edge(k + 1)}));
  const double total = cumulative.back();
  // A share above 1 by rounding alone needs no further interval.
  const int count = std::max(1, whole(std::ceil(total * (1 - 1e-12))));
  std::vector<Interval> all;
  double from = layer.from;
  for (int k = 1; k <= count; ++k) {
    double to = layer.to;
    if (k < count) {
      const double wanted = total * k / count;
      const auto above = std::upper_bound(cumulative.begin() + 1, cumulative.end() - 1, wanted);
      const int part = static_cast<int>(above - cumulative.begin()) - 1;
      const double before = cumulative[static_cast<std::size_t>(part)];
      to = invert(measure, {edge(part), edge(part + 1)}, *above - before, wanted - before);
    }
    all.push_back({from, to});
    from = to;
  }
  return all;
}

}  // namespace plumbline
