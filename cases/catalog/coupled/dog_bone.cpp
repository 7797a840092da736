#include "cases/catalog/coupled/dog_bone.hpp"

#include <cmath>
#include <numbers>

namespace plumbline {
namespace {

constexpr double rounding = 0.06;  // m
constexpr int arc_pieces = 60;

// The corner b between a and c by an arc, from its start to `share` of its turn.
void round_corner(Curve& curve, std::array<double, 2> a, std::array<double, 2> b, std::array<double, 2> c,
                  double share) {
  const auto direction = [&](const std::array<double, 2>& to) {
    const double dx = to[0] - b[0], dy = to[1] - b[1], l = std::hypot(dx, dy);
    return std::array<double, 2>{dx / l, dy / l};
  };
  const auto u = direction(a), v = direction(c);
  const double half = std::acos(u[0] * v[0] + u[1] * v[1]) / 2, cut = rounding / std::tan(half);
  const double mx = u[0] + v[0], my = u[1] + v[1], m = std::hypot(mx, my), out = rounding / std::sin(half);
  const double x = b[0] + mx / m * out, y = b[1] + my / m * out;
  const double from = std::atan2(b[1] + cut * u[1] - y, b[0] + cut * u[0] - x);
  const double turn = std::remainder(std::atan2(b[1] + cut * v[1] - y, b[0] + cut * v[0] - x) - from,
                                     2 * std::numbers::pi);
  for (int k = 0; k <= arc_pieces; ++k) {
    const double angle = from + share * turn * k / arc_pieces;
    curve.push_back({x + rounding * std::cos(angle), y + rounding * std::sin(angle)});
  }
}

Curve outline_with_lobe(double lobe) {
  const Curve corners{{0.5, 0}, {0.5, 0.585}, {lobe, 0.585}, {lobe, 0.79}, {0.45, 0.955}, {0, 1}, {-0.45, 0.955}};
  Curve curve{corners.front()};
  for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
    const bool on_axis = k + 2 == corners.size();
    round_corner(curve, corners[k - 1], corners[k], corners[k + 1], on_axis ? 0.5 : 1.0);
  }
  curve.back()[0] = 0;
  return curve;
}

}  // namespace

Curve dog_bone_gas() { return {{0, 0}, {0.426, 0}, {0.426, 0.65}, {0.9, 0.65}, {0.9, 0.74}, {0.426, 0.9}, {0, 0.95}}; }

Curve dog_bone_outline(int segments) {
  double low = 0.9, high = 1.2;
  for (int k = 0; k < 60; ++k) {
    const double lobe = 0.5 * (low + high);
    (length(outline_with_lobe(lobe)) < dog_bone_length ? low : high) = lobe;
  }
  return evenly(outline_with_lobe(low), segments);
}

}  // namespace plumbline
