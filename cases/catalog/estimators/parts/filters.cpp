// What gates of transfers measure of filters that are known in closed form: what a pass leaves of a wave on two points a cell.
#include <cmath>
#include <numbers>

#include "cases/catalog/estimators/answers.hpp"
#include "cases/catalog/estimators/parts/reading.hpp"
#include "cases/harness/parts/transfer_gates.hpp"
#include "kernel/shapes/shape.hpp"
#include "kernel/transfers/transfer.hpp"

namespace plumbline {
namespace {

constexpr int wave_cells = 64, most_halves = 64, least_halves = 2;  // half waves between the walls
constexpr double kept_by_blend = 0.95;

// The weight of a point so many quarters of a cell from a node: 1, 3 or 5.
double weight_at(const std::string& shape, int quarters) {
  const int which = std::abs(quarters) / 2;
  if (which > 2) return 0;
  constexpr double linear[] = {0.75, 0.25, 0}, quadratic[] = {11.0 / 16, 9.0 / 32, 1.0 / 32};
  return shape == "linear" ? linear[which] : quadratic[which];
}

// What the map from points to nodes leaves of a wave, and the map back of one that the nodes have.
double of_one_map(const std::string& shape, double k) {
  double sum = 0;
  for (int quarters = 1; quarters <= 5; quarters += 2)
    sum += weight_at(shape, quarters) * std::cos(0.25 * quarters * k);
  return sum;
}

// What the way from the nodes to the points and back leaves of it.
double of_nodes(const std::string& shape, double k) {
  double sum = 0;
  for (int quarters = -5; quarters <= 5; quarters += 2) {
    for (int node = -3; node <= 3; ++node) {
      sum += 0.5 * weight_at(shape, quarters) * weight_at(shape, quarters - 4 * node) * std::cos(k * node);
    }
  }
  return sum;
}

// Of a wave of two cells nodes see nothing. xpic and fmpm, of order two, give back once more what a first way there and back took.
double left_of_wave(const std::string& transfer, const std::string& shape, int halves) {
  const double k = std::numbers::pi * halves / wave_cells, g = halves == wave_cells ? 0 : of_one_map(shape, k);
  if (transfer == "flip") return 1;
  if (transfer == "blend") return kept_by_blend + (1 - kept_by_blend) * g * g;
  return transfer == "pic" ? g * g : g * g * (2 - of_nodes(shape, k));
}

// The slope of the straight line through the logarithms of what is taken, by those of the number of half waves.
double order_of(const std::string& transfer, const std::string& shape) {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (const int halves : {8, 6, 5, 4, 3, 2}) {
    const double along = std::log(halves), taken = std::log(1 - left_of_wave(transfer, shape, halves));
    n += 1;
    x += along;
    y += taken;
    xx += along * along;
    xy += along * taken;
  }
  return (n * xy - x * y) / (n * xx - x * x);
}

}  // namespace

KnownAnswers filter_answers() {
  KnownAnswers all;
  for (const std::string shape : {"linear", "quadratic"}) {
    for (const std::string transfer : {"flip", "blend", "pic", "xpic", "fmpm"}) {
      const auto rows = transfer_filter_gates(transfer_named(transfer), shape_named(shape));
      double beyond = -1;
      for (int halves = least_halves; halves <= most_halves; halves += 2) {
        const double left = left_of_wave(transfer, shape, halves);
        beyond = std::max({beyond, left - 1, -left});
      }
      const std::string name = transfer + "_" + shape;
      all.push_back({name + ".beyond", reading(rows, "filter/range/line"), beyond});
      all.push_back({name + ".rows", static_cast<double>(rows.size()), transfer == "flip" ? 1.0 : 2.0});
      if (transfer != "flip")
        all.push_back({name + ".order", reading(rows, "filter/order/line"), order_of(transfer, shape)});
    }
  }
  return all;
}

}  // namespace plumbline
