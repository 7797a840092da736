#include "kernel/curve_order.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>
#include <string>

namespace plumbline {
namespace {

constexpr int nobody = -1;
using Pair = std::array<int, 2>;

struct CurvePlaces {
  std::span<const double> x, y;

  int count() const { return static_cast<int>(x.size()); }
  std::array<double, 2> way(int from, int to) const {
    const auto a = static_cast<std::size_t>(from), b = static_cast<std::size_t>(to);
    return {x[b] - x[a], y[b] - y[a]};
  }
  // The nearest of the points that `taken` takes, the first of equals.
  template <class Taken>
  int nearest(int p, Taken&& taken) const {
    int found = nobody;
    double least = std::numeric_limits<double>::infinity();
    for (int other = 0; other < count(); ++other) {
      if (other == p) continue;
      const auto d = way(p, other);
      const double square = d[0] * d[0] + d[1] * d[1];
      if (!(square < least) || !taken(d)) continue;
      least = square;
      found = other;
    }
    if (least == 0) {
      throw std::invalid_argument("points " + std::to_string(p) + " and " + std::to_string(found) +
                                  " of a curve stand in one place");
    }
    return found;
  }
  Pair neighbours(int p) const {
    const int q = nearest(p, [](const auto&) { return true; });
    if (q == nobody)
      throw std::invalid_argument("the place of point " + std::to_string(p) + " of a curve is no number");
    const auto to = way(p, q);
    return {q, nearest(p, [&](const auto& d) { return d[0] * to[0] + d[1] * to[1] < 0; })};
  }
};

// What each point and another choose of each other. [Curve 1]
std::vector<Pair> joined(const CurvePlaces& places) {
  std::vector<Pair> chosen;
  for (int p = 0; p < places.count(); ++p) chosen.push_back(places.neighbours(p));
  std::vector<Pair> both = chosen;
  for (int p = 0; p < places.count(); ++p) {
    for (int& other : both[static_cast<std::size_t>(p)]) {
      if (other == nobody) continue;
      const Pair& back = chosen[static_cast<std::size_t>(other)];
      if (back[0] != p && back[1] != p) other = nobody;
    }
  }
  return both;
}

int ends(const Pair& of) { return static_cast<int>(of[0] == nobody) + static_cast<int>(of[1] == nobody); }

}  // namespace

CurveOrder order_along_curve(std::span<const double> x, std::span<const double> y) {
  const CurvePlaces places{x, y};
  if (x.size() != y.size() || x.size() < 2) {
    throw std::invalid_argument("a curve has two points at least, each with x and y; there are " +
                                std::to_string(x.size()) + " and " + std::to_string(y.size()));
  }
  const std::vector<Pair> all = joined(places);
  const auto end = std::find_if(all.begin(), all.end(), [](const Pair& of) { return ends(of) > 0; });
  CurveOrder order{{}, end == all.end()};
  int before = nobody, p = order.closed ? 0 : static_cast<int>(end - all.begin());
  int next = order.closed ? std::min(all[0][0], all[0][1]) : nobody;
  while (p != nobody && order.points.size() < all.size()) {
    order.points.push_back(p);
    const Pair& of = all[static_cast<std::size_t>(p)];
    if (next == nobody) next = of[0] != before && of[0] != nobody ? of[0] : of[1] != before ? of[1] : nobody;
    before = p;
    p = next;
    next = nobody;
    if (p == order.points.front()) break;
  }
  if (order.points.size() < all.size()) {
    throw std::invalid_argument("of " + std::to_string(all.size()) + " points " + std::to_string(order.points.size()) +
                                " follow each other, then none follows point " + std::to_string(order.points.back()) +
                                ": points of one curve must stand closer where it bends or nears itself");
  }
  return order;
}

}  // namespace plumbline
