#include "cases/catalog/gas/fill.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "cases/harness/files/whole.hpp"

namespace plumbline {
namespace {

using Line = std::function<double(double)>;  // a function of the place along the axis

// The middles of the equal strips across one direction, and the strip's width; with weight r: centres of mass.
struct Strip {
  double place, measure;  // m; m, or r dr
};

std::vector<Strip> strips(double low, double high, double h, int lines, bool radial) {
  const int count = std::max(1, whole(std::round((high - low) / h * lines)));
  const double width = (high - low) / count;
  std::vector<Strip> all;
  for (int k = 0; k < count; ++k) {
    const double middle = low + (k + 0.5) * width;
    // The centre of mass of a ring of uniform gas: (2/3)(b^3 - a^3)/(b^2 - a^2).
    all.push_back(radial ? Strip{middle + width * width / (12 * middle), middle * width} : Strip{middle, width});
  }
  return all;
}

void check(const GasBox& box, const GridSpec& grid) {
  for (std::size_t d = 0; d < static_cast<std::size_t>(grid.dim); ++d) {
    if (!(box.high[d] > box.low[d])) throw std::invalid_argument("a box of gas without extent");
  }
  if (grid.axisymmetric && box.low[0] < 0) throw std::invalid_argument("gas at a radius below zero");
}

// One line of points along the axis through `through`; `across` is the measure of its cross-section.
class Filler {
 public:
  Filler(const IdealGas& gas, const GasBox& box, const GridSpec& grid, std::vector<Interval> intervals)
      : gas_(gas),
        box_(box),
        axis_(static_cast<std::size_t>(box.axis)),
        dim_(grid.dim),
        radial_(grid.axisymmetric && box.axis == 0),
        intervals_(std::move(intervals)) {}

  void line(Body& body, int first, Position through, double across) const {
    const auto at = [&](double s) {
      Position x = through;
      x[axis_] = s;
      return box_.state(x);
    };
    const Line weight = [&](double s) { return radial_ ? s : 1.0; };
    const Line density = [&](double s) { return at(s).density; };
    const Line mass = [&](double s) { return at(s).density * weight(s); };
    const Line heat = [&](double s) { return at(s).pressure / ((gas_.gamma - 1) * at(s).density); };  // [York 4.4]
    Columns& points = body.points;
    int p = first;
    for (const Interval& over : intervals_) {
      // The integral of the weight, exactly: 1 or s is its own Gauss rule.
      const double volume = weight(over.middle()) * over.length() * across;
      const double rho = weighted_mean(density, weight, over);
      for (std::size_t d = 0; d < static_cast<std::size_t>(dim_); ++d) {
        const Line velocity = [&](double s) { return at(s).velocity[d]; };
        points(column::velocity, static_cast<int>(d))[p] = weighted_mean(velocity, mass, over);
        points(column::position, static_cast<int>(d))[p] = d == axis_
                                                               ? weighted_mean([](double s) { return s; }, mass, over)
                                                               : through[d];
      }
      points(column::volume)[p] = volume;
      points(column::mass)[p] = rho * volume;
      points(column::density)[p] = rho;
      points(column::energy)[p] = weighted_mean(heat, mass, over);
      points(column::pressure)[p] = (gas_.gamma - 1) * rho * points(column::energy)[p];  // [York 4.4]
      ++p;
    }
  }

 private:
  const IdealGas& gas_;
  const GasBox& box_;
  std::size_t axis_;
  int dim_;
  bool radial_;
  std::vector<Interval> intervals_;
};

}  // namespace

std::vector<Interval> point_intervals(const GasBox& box, const PointRule& rule, double h) {
  const auto axis = static_cast<std::size_t>(box.axis);
  const auto density = [&](double s) {
    Position x = box.low;
    x[axis] = s;
    return box.state(x).density;
  };
  const std::vector<Interval> between = layers(box.low[axis], box.high[axis], box.jumps);
  const double densest = rule.equal_mass ? largest(density, between) : 0;
  const auto measure = [&](double s) {
    if (!rule.equal_mass) return rule.ppc / h;
    return std::max(rule.ppc * density(s) / densest, rule.least) / h;
  };
  std::vector<Interval> all;
  for (const Interval& layer : between) {
    const auto shares = equal_shares(layer, measure);
    all.insert(all.end(), shares.begin(), shares.end());
  }
  return all;
}

Body fill_gas(std::shared_ptr<const IdealGas> gas, const GasBox& box, const PointRule& rule, const GridSpec& grid) {
  check(box, grid);
  const std::vector<Interval> intervals = point_intervals(box, rule, grid.h);
  const int on_line = static_cast<int>(intervals.size());
  std::array<std::vector<Strip>, 3> across;
  int lines = 1;
  for (std::size_t d = 0; d < 3; ++d) {
    const bool spread = static_cast<int>(d) < grid.dim && static_cast<int>(d) != box.axis;
    across[d] = spread ? strips(box.low[d], box.high[d], grid.h, rule.lines, grid.axisymmetric && d == 0)
                       : std::vector<Strip>{{box.low[d], 1.0}};
    lines *= static_cast<int>(across[d].size());
  }
  Body body = make_body("gas", gas, lines * on_line, grid.dim, grid.axisymmetric);
  const Filler filler(*gas, box, grid, intervals);
  int first = 0;
  for (const Strip& z : across[2]) {
    for (const Strip& y : across[1]) {
      for (const Strip& x : across[0]) {
        filler.line(body, first, {x.place, y.place, z.place}, x.measure * y.measure * z.measure);
        first += on_line;
      }
    }
  }
  return body;
}

}  // namespace plumbline
