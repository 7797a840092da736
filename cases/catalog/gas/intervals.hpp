// Where points stand along one coordinate: intervals that share a measure equally.
#pragma once

#include <array>
#include <functional>
#include <vector>

namespace plumbline {

struct Interval {
  double from, to;
  double middle() const { return 0.5 * (from + to); }
  double length() const { return to - from; }
};

struct GaussPoint {
  double place, weight;  // on [-1/2, 1/2], weights sum to 1
};
// sqrt(5 -+ 2 sqrt(10/7))/6 and (322 +- 13 sqrt 70)/1800: Legendre's polynomial of degree five.
inline constexpr std::array<GaussPoint, 5> gauss_points{{{-0.45308992296933199640, 0.11846344252809454376},
                                                         {-0.26923465505284154552, 0.23931433524968323402},
                                                         {0.0, 0.28444444444444444444},
                                                         {0.26923465505284154552, 0.23931433524968323402},
                                                         {0.45308992296933199640, 0.11846344252809454376}}};

// The integral of f over the interval, by five Gauss points: exact for polynomials of degree nine.
double integral(const std::function<double(double)>& f, const Interval& over);

// The mean of f under a weight w > 0 over the interval; exactly c where f = c everywhere.
double weighted_mean(const std::function<double(double)>& f, const std::function<double(double)>& w,
                     const Interval& over);

// [low, high] without its jumps: the layers between them. Jumps outside (low, high) part nothing.
std::vector<Interval> layers(double low, double high, const std::vector<double>& jumps);

// The largest value of f in the layers, at the ends of 64 equal parts of each; values at jumps are not asked for.
double largest(const std::function<double(double)>& f, const std::vector<Interval>& layers);

// Cuts a layer into the least number n >= 1 of intervals that hold equal shares, of at most 1, of `measure` (> 0, per
// m; continuous within the layer). Found by inverting the cumulative measure, so intervals of a smooth measure are
// smooth in their number and sums over them of second order.
std::vector<Interval> equal_shares(const Interval& layer, const std::function<double(double)>& measure);

}  // namespace plumbline
