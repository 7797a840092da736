// What runs are foreseen to take before their scenes are made: powers of cells and of points a cell.
#include <cmath>
#include <limits>
#include <memory>

#include "cases/catalog/estimators/answers.hpp"
#include "cases/harness/run/budget.hpp"
#include "kernel/materials/ideal_gas.hpp"

namespace plumbline {
namespace {

// So many points: a power of the cells along an axis times one of the points a cell, in twice as many cells as a square has.
class SizedProblem final : public Problem {
 public:
  SizedProblem(const Settings& settings, double of_cells, double of_ppc)
      : cells_(static_cast<int>(settings.number("cells"))),
        points_(static_cast<int>(std::pow(cells_, of_cells) * std::pow(settings.number("ppc"), of_ppc))) {}
  double end_time() const override { return 1; }
  Profile profile(const Simulation&) const override { return {}; }
  std::vector<Measure> measures(const Simulation&) const override { return {}; }
  Scene scene() const override {
    Scene all;
    all.grid.dim = 2;
    all.grid.cells = {cells_, 2 * cells_, 1};
    for (const char* name : {"one", "other"}) {
      all.bodies.push_back(make_body(name, std::make_shared<IdealGas>(), points_ / 2, 2));
    }
    return all;
  }

 private:
  int cells_, points_;
};

SceneSize foreseen_of(double of_cells, double of_ppc, double cells, double ppc) {
  Case entry = find_case("sod");
  entry.problem = [=](const Settings& settings) { return std::make_unique<SizedProblem>(settings, of_cells, of_ppc); };
  return foreseen_size(entry, entry.settings("default", {{"cells", cells}, {"ppc", ppc}}));
}

}  // namespace

KnownAnswers size_answers() {
  KnownAnswers all;
  const auto row = [&](const std::string& name, double found, double exact) {
    all.push_back({name, found, exact, std::max(1.0, exact)});
  };
  row("size.bytes", SceneSize{.points = 10, .cells = 20, .dim = 2}.bytes(), 10 * 625 + 20 * 300);
  row("size.bytes_in_space", SceneSize{.points = 10, .cells = 20, .dim = 3}.bytes(), 10 * 875 + 20 * 450);
  const SceneSize small = foreseen_of(2, 2, 256, 32), wide = foreseen_of(2, 2, 512, 4),
                  dense = foreseen_of(2, 2, 8, 64), both = foreseen_of(2, 1, 1024, 64),
                  line = foreseen_of(1, 1, 4096, 2), steep = foreseen_of(4, 2, 512, 2);
  row("small.points", small.points, 0);  // is not asked for
  row("wide.points", wide.points, 512.0 * 512 * 4 * 4);
  row("wide.cells", wide.cells, 2.0 * 512 * 512);
  row("wide.dim", wide.dim, 2);
  row("dense.points", dense.points, 8.0 * 8 * 64 * 64);
  row("dense.cells", dense.cells, 2.0 * 8 * 8);
  row("both.points", both.points, 1024.0 * 1024 * 64);
  row("line.points", line.points, 4096.0 * 2);
  // Nothing grows faster than space is filled: from 16 cells on as their cube.
  row("steep.points", steep.points, std::pow(16.0, 4) * 4 * std::pow(512.0 / 16, 3));

  const double steps = budget().steps;
  const Settings settings = find_case("sod").settings("default", {});
  all.push_back(no("steps.allowed", throws<UsageError>([&] { require_steps(2, 2.01 / steps, settings); })));
  all.push_back(yes("steps.refused", throws<UsageError>([&] { require_steps(2, 1.99 / steps, settings); })));
  all.push_back(no("end.finite", throws<UsageError>([] { require_end(1e300); })));
  all.push_back(yes("end.infinite", throws<UsageError>([] { require_end(std::numeric_limits<double>::infinity()); })));
  const double most = budget().memory / (125 + 250);
  all.push_back(
      no("memory.allowed", throws<UsageError>([&] { require_memory({.points = 0.99 * most, .cells = 0}, settings); })));
  all.push_back(yes("memory.refused",
                    throws<UsageError>([&] { require_memory({.points = 1.01 * most, .cells = 0}, settings); })));
  return all;
}

}  // namespace plumbline
