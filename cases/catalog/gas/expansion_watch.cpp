#include "cases/catalog/gas/expansion_watch.hpp"

#include <algorithm>
#include <cmath>

#include "cases/harness/description/archive.hpp"
#include "cases/harness/judge/gates.hpp"

namespace plumbline {

void ExpansionWatch::start(const Body& body) {
  start_.assign(body.id.size(), 0.0);
  for (int p = 0; p < body.points.points(); ++p) {
    const double e = body.points(column::energy)[p];
    start_[static_cast<std::size_t>(body.id[static_cast<std::size_t>(p)])] = e;
    hottest_ = std::max(hottest_, e);
  }
}

void ExpansionWatch::observe(const Simulation& simulation) {
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

void ExpansionWatch::history(Archive& archive) {
  archive("start", start_);
  archive("hottest", hottest_);
  archive("ratio", ratio_);
  archive("rise", rise_);
}

std::vector<Measure> ExpansionWatch::measures() const {
  return {scalar_measure("energy_ratio", ratio_, 1.0, 0.0, "1"), scalar_measure("energy_rise", rise_, 0.0, 0.0, "1")};
}

std::shared_ptr<ExpansionWatch> watch_expansion(GasFlow& flow) {
  auto watch = std::make_shared<ExpansionWatch>();
  flow.fill = [watch, fill = flow.fill](std::shared_ptr<const IdealGas> gas, const PointRule& rule,
                                        const GridSpec& grid) {
    Body body = fill(std::move(gas), rule, grid);
    watch->start(body);
    return body;
  };
  flow.observe = [watch](const Simulation& simulation) { watch->observe(simulation); };
  flow.history = [watch](Archive& archive) { watch->history(archive); };
  for (const Measure& m : watch->measures()) flow.seen_on_the_way.push_back(m.name);
  return watch;
}

Measure entropy_error(const std::vector<GasSample>& points, double gamma, double constant) {
  double mass = 0, off = 0;
  for (const GasSample& p : points) {
    mass += p.volume * p.density;
    off += p.volume * p.density * std::abs(p.pressure * std::pow(p.density, -gamma) / constant - 1);
  }
  return {"entropy.L1", off / mass, 1.0, {}, {}, 0, "1"};
}

CaseGate no_heating_gate(const std::string& study, double level, Tier tier) {
  return value_gate(study, "energy_ratio", level,
                    declare(study + "/no-heating-" + to_text(level), {{}, 1 + 1e-12}, Origin::theory,
                            "gas that only expands only cools: no point's internal energy above its initial value, "
                            "after any step, but for rounding"),
                    tier);
}

}  // namespace plumbline
