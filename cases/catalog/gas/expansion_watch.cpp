#include "cases/catalog/gas/expansion_watch.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "cases/harness/description/archive.hpp"
#include "cases/harness/judge/gates.hpp"

namespace plumbline {
namespace {

class ExpansionWatch {
 public:
  // Remembers e_p(0) by the points' numbers.
  void start(const Body& body) {
    start_.assign(body.id.size(), 0.0);
    for (int p = 0; p < body.points.points(); ++p) {
      const double e = body.points(column::energy)[p];
      start_[static_cast<std::size_t>(body.id[static_cast<std::size_t>(p)])] = e;
      hottest_ = std::max(hottest_, e);
    }
  }

  void observe(const Simulation& simulation) {
    const Body& body = simulation.scene().bodies.front();
    const std::size_t made = body.id.size() - body.split_from.size();
    while (start_.size() < body.id.size()) {
      start_.push_back(start_[static_cast<std::size_t>(body.split_from[start_.size() - made])]);
    }
    const double* energy = body.points(column::energy);
    for (int p = 0; p < body.points.points(); ++p) {
      const double e = start_[static_cast<std::size_t>(body.id[static_cast<std::size_t>(p)])];
      ratio_ = larger(ratio_, energy[p] / e);
      rise_ = larger(rise_, (energy[p] - e) / hottest_);
    }
  }

  void history(Archive& archive) {
    archive("start", start_);
    archive("hottest", hottest_);
    archive("ratio", ratio_);
    archive("rise", rise_);
  }

  std::vector<Measure> measures() const {
    return {scalar_measure("energy_ratio", ratio_, 1.0, 0.0, "1"), scalar_measure("energy_rise", rise_, 0.0, 0.0, "1")};
  }

 private:
  std::vector<double> start_;
  double hottest_ = 0;
  double ratio_ = 0, rise_ = -HUGE_VAL;
};

Measure entropy_error(const std::vector<GasSample>& points, double gamma, double entropy) {
  double mass = 0, off = 0;
  for (const GasSample& p : points) {
    mass += p.volume * p.density;
    off += p.volume * p.density * std::abs(p.pressure * std::pow(p.density, -gamma) / entropy - 1);
  }
  return {"entropy.L1", off / mass, 1.0, {}, {}, 0, "1"};
}

Measure edge_error(const std::vector<GasSample>& points, const GasEdge& edge, double time) {
  double outermost = 0;
  for (const GasSample& p : points) outermost = larger(outermost, p.coordinate);
  const reference::Bounded exact = edge.at(time);
  return scalar_measure(edge.name, outermost, exact.value, exact.bound, "m");
}

}  // namespace

void watch_expansion(GasFlow& flow, double entropy, const GasEdge& edge) {
  const auto watch = std::make_shared<ExpansionWatch>();
  flow.fill = [watch, fill = flow.fill](std::shared_ptr<const IdealGas> gas, const PointRule& rule,
                                        const GridSpec& grid) {
    Body body = fill(std::move(gas), rule, grid);
    watch->start(body);
    return body;
  };
  flow.observe = [watch](const Simulation& simulation) { watch->observe(simulation); };
  flow.history = [watch](Archive& archive) { watch->history(archive); };
  for (const Measure& m : watch->measures()) flow.seen_on_the_way.push_back(m.name);
  flow.further = [=, gamma = flow.gamma](const std::vector<GasSample>& points, double time) {
    std::vector<Measure> all = watch->measures();
    all.push_back(entropy_error(points, gamma, entropy));
    all.push_back(edge_error(points, edge, time));
    return all;
  };
}

CaseGate no_heating_gate(const std::string& study, double level) {
  return gate(study + "/no-heating-" + to_text(level), value_at("energy_ratio", level), at_most(1 + 1e-12),
              theory("gas that only expands only cools: no point's internal energy above its initial value, after any "
                     "step, but for rounding"));
}

}  // namespace plumbline
