#include "cases/catalog/gas/flip_beside.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>

#include "cases/harness/description/archive.hpp"
#include "reference/flip_gas.hpp"

namespace plumbline {
namespace {

using reference::FlipPoint;

class FlipWatch {
 public:
  void start(const Body& body) {
    start_.assign(body.id.size(), {});
    for (int p = 0; p < body.points.points(); ++p) {
      FlipPoint& point = start_[static_cast<std::size_t>(body.id[static_cast<std::size_t>(p)])];
      for (std::size_t d = 0; d < 2; ++d) point.place[d] = body.points(column::position, static_cast<int>(d))[p];
      point.mass = body.points(column::mass)[p];
      point.energy = body.points(column::energy)[p];
    }
    now_.assign(start_.size(), {});
  }

  void observe(const Simulation& simulation) {
    const Body& body = simulation.scene().bodies.front();
    const std::size_t made = start_.size();
    now_.assign(made, {});
    for (int p = 0; p < body.points.points(); ++p) {
      auto id = static_cast<std::size_t>(body.id[static_cast<std::size_t>(p)]);
      while (id >= made) id = static_cast<std::size_t>(body.split_from[id - made]);
      const double mass = body.points(column::mass)[p];
      const std::array<double, 4> of{body.points(column::position)[p], body.points(column::position, 1)[p],
                                     body.points(column::energy)[p], body.points(column::pressure)[p]};
      for (std::size_t k = 0; k < of.size(); ++k) now_[id][k] += of[k] * mass / start_[id].mass;
    }
  }

  void history(Archive& archive) { archive("now", now_); }

  // `across_a_cell`: of pressure and specific internal energy.
  std::vector<Measure> measures(reference::FlipGas gas, double digit,
                                const std::array<double, 2>& across_a_cell) const {
    const double step = gas.step;
    double from_implicit = 0, from_explicit = HUGE_VAL, scatter_of_explicit = HUGE_VAL;
    reference::FlipState implicit;
    for (const double share : {1 - digit, 1 + digit, 1.0}) {  // the step itself last: its state is kept
      gas.step = share * step;
      gas.implicit = false;
      const reference::FlipState forward = reference::flip_gas(gas, start_);
      gas.implicit = true;
      implicit = reference::flip_gas(gas, start_);
      from_implicit = larger(from_implicit, apart(implicit.points));
      from_explicit = smaller(from_explicit, apart(forward.points));
      std::vector<Place> theirs;
      for (const FlipPoint& point : forward.points) theirs.push_back(point.place);
      scatter_of_explicit = smaller(scatter_of_explicit, scatter(theirs));
    }
    std::vector<Place> ours;
    for (const auto& now : now_) ours.push_back({now[0], now[1]});
    const auto scalar = [](const char* name, double value, const char* unit) {
      return scalar_measure(name, value, 0, 0, unit);
    };
    return {scalar("from_implicit_flip", from_implicit, "m"),
            scalar("from_explicit_flip", from_explicit, "m"),
            scalar("scatter", scatter(ours), "m"),
            scalar("explicit_flip_scatter", scatter_of_explicit, "m"),
            scalar("implicit_flip_pressure", pressure_apart(implicit, gas) / across_a_cell[0], "1"),
            scalar("implicit_flip_energy", energy_apart(implicit) / across_a_cell[1], "1"),
            scalar("implicit_flip_hottest", hottest(implicit), "1")};
  }

 private:
  using Place = std::array<double, 2>;

  // The mass-weighted mean of a number of each point.
  template <class Of>
  double mean(Of&& of) const {
    double sum = 0, mass = 0;
    for (std::size_t p = 0; p < start_.size(); ++p) {
      sum += start_[p].mass * of(p);
      mass += start_[p].mass;
    }
    return sum / mass;
  }

  double apart(const std::vector<FlipPoint>& points) const {
    return std::sqrt(mean([&](std::size_t p) {
      const double x = points[p].place[0] - now_[p][0], y = points[p].place[1] - now_[p][1];
      return x * x + y * y;
    }));
  }

  double scatter(const std::vector<Place>& places) const {
    return std::sqrt(mean([&](std::size_t p) {
      const Place& from = start_[p].place;
      const double off = (from[0] * places[p][1] - from[1] * places[p][0]) / std::hypot(from[0], from[1]);
      return off * off;
    }));
  }

  double pressure_apart(const reference::FlipState& state, const reference::FlipGas& gas) const {
    const auto cell = [&gas](double x) { return std::clamp(static_cast<int>(x / gas.h), 0, gas.cells - 1); };
    return mean([&](std::size_t p) {
      const int at = cell(now_[p][1]) * gas.cells + cell(now_[p][0]);
      return std::abs(now_[p][3] - state.pressure[static_cast<std::size_t>(at)]);
    });
  }

  double energy_apart(const reference::FlipState& state) const {
    return mean([&](std::size_t p) { return std::abs(now_[p][2] - state.points[p].energy); });
  }

  double hottest(const reference::FlipState& state) const {
    double most = 0;
    for (std::size_t p = 0; p < start_.size(); ++p) {
      most = larger(most, state.points[p].energy / start_[p].energy);
    }
    return most;
  }

  std::vector<FlipPoint> start_;
  std::vector<std::array<double, 4>> now_;  // x, y, specific internal energy, pressure of what was made as one point
};

// The mass-weighted means of the exact differences of pressure and specific internal energy across a cell.
std::array<double, 2> differences_across(const GasFlow& flow, double h, const std::vector<GasSample>& points,
                                         double time) {
  std::array<double, 2> sum{};
  double mass = 0;
  for (const GasSample& p : points) {
    const double m = p.density * p.volume;
    const reference::Sample in = flow.exact(std::abs(p.coordinate - h / 2), time),
                            out = flow.exact(p.coordinate + h / 2, time);
    sum[0] += m * std::abs(in.pressure.value - out.pressure.value);
    sum[1] += m * std::abs(in.energy.value - out.energy.value);
    mass += m;
  }
  return {sum[0] / mass, sum[1] / mass};
}

}  // namespace

void compare_with_flip(GasFlow& flow, int cells, double h, double step, double digit) {
  const auto watch = std::make_shared<FlipWatch>();
  flow.fill = [watch, fill = flow.fill](std::shared_ptr<const IdealGas> gas, const PointRule& rule,
                                        const GridSpec& grid) {
    Body body = fill(std::move(gas), rule, grid);
    watch->start(body);
    return body;
  };
  flow.observe = [watch, before = flow.observe](const Simulation& simulation) {
    before(simulation);
    watch->observe(simulation);
  };
  flow.history = [watch, before = flow.history](Archive& archive) {
    before(archive);
    watch->history(archive);
  };
  for (const char* name : {"from_implicit_flip", "from_explicit_flip", "scatter", "explicit_flip_scatter",
                           "implicit_flip_pressure", "implicit_flip_energy", "implicit_flip_hottest"}) {
    flow.seen_on_the_way.push_back(name);
  }
  const reference::FlipGas gas{
      .cells = cells, .h = h, .gamma = flow.gamma, .step = step, .end_time = flow.end_time, .implicit = false};
  const GasFlow exact = flow;
  flow.further = [=, before = flow.further](const std::vector<GasSample>& points, double time) {
    std::vector<Measure> all = before(points, time);
    for (Measure& m : watch->measures(gas, digit, differences_across(exact, h, points, time))) {
      all.push_back(std::move(m));
    }
    return all;
  };
}

}  // namespace plumbline
