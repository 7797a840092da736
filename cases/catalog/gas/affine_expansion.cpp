// A cylinder or sphere of gas that expands into a vacuum, every part of it in proportion.
#include <cmath>
#include <memory>
#include <optional>

#include "cases/catalog/gas/expansion_watch.hpp"
#include "cases/catalog/gas/fill_ball.hpp"
#include "cases/catalog/gas/gas_case.hpp"
#include "cases/harness/description/parameters.hpp"
#include "cases/harness/files/errors.hpp"
#include "cases/harness/verify/restart_gate.hpp"
#include "reference/affine_expansion.hpp"

namespace plumbline::affine_expansion {
namespace {

struct Expansion : Parameters {
  using Parameters::Parameters;
  std::string body = one_of("body", "cylinder", {"cylinder", "sphere"}, "what expands");
  std::string geometry = one_of("geometry", "plane", {"plane", "axisymmetric", "3d"},
                                "plane: a quarter of the cylinder; axisymmetric: a slice of the cylinder or a quarter "
                                "of the sphere's section; 3d: the sphere's octant");
  reference::AffineExpansionProblem gas{
      .dimension = body == "cylinder" ? 2 : 3,
      .gamma = number(
          {.name = "gamma", .value = 1.4, .low = 1.1, .high = 3, .description = "ratio of specific heats"})};
  double end_time = within("t_end", 0.01, "s", 0, 0.05, "end time");
};

RadialGeometry geometry_of(const Expansion& expansion) {
  for (const RadialGeometry& geometry : radial_geometries(expansion.gas.dimension)) {
    if (geometry.name == expansion.geometry) return geometry;
  }
  throw UsageError("geometry", expansion.geometry,
                   expansion.gas.dimension == 2 ? "axisymmetric, plane" : "axisymmetric, 3d", {},
                   "geometry=" + expansion.geometry + " cannot hold body=" + expansion.body);
}

// The exact gas, kept for the one time at which it is asked for again and again.
class ExactGas {
 public:
  explicit ExactGas(const reference::AffineExpansionProblem& problem) : gas_(problem) {}
  const reference::AffineExpansion& gas() const { return gas_; }
  reference::Sample sample(double r, double t) {
    if (!at_ || time_ != t) {
      at_ = gas_.at(t);
      time_ = t;
    }
    return at_->sample(r);
  }

 private:
  reference::AffineExpansion gas_;
  std::optional<reference::AffineGas> at_;
  double time_ = 0;
};

GasFlow affine_flow(const Settings& settings) {
  const Expansion expansion(settings);
  const RadialGeometry geometry = geometry_of(expansion);
  const reference::AffineExpansionProblem& problem = expansion.gas;
  const auto exact = std::make_shared<ExactGas>(problem);
  GasFlow flow;
  flow.end_time = expansion.end_time;
  flow.gamma = problem.gamma;
  const double h = cell_size(flow, settings), end = exact->gas().radius(flow.end_time).value;
  set_geometry(flow, geometry, end + 4 * h, settings);
  flow.initial = [exact](double r) {
    const reference::Sample at = exact->sample(r, 0);
    return reference::GasState{at.density.value, 0, at.pressure.value};
  };
  flow.exact = [exact](double r, double t) { return exact->sample(r, t); };
  flow.fill = [geometry, radius = problem.radius, initial = flow.initial](std::shared_ptr<const IdealGas> gas,
                                                                          const PointRule& rule, const GridSpec& grid) {
    return fill_ball(std::move(gas), {geometry, radius, initial, false}, rule, grid);
  };
  watch_expansion(flow, problem.pressure * std::pow(problem.density, -problem.gamma),
                  {"edge", [exact](double time) { return exact->gas().radius(time); }});
  return flow;
}

std::vector<StudyPlan> studies() {
  const std::string why = "Smooth but for the edge: 2 in the density, 1 in the velocity.";
  const std::vector<double> levels{40, 56, 80, 112, 160};
  return {study("default", "default, a quarter of the cylinder", why, levels),
          study("sphere", "default, the sphere by rings", why, levels)
              .with({{"body", "sphere"}, {"geometry", "axisymmetric"}})};
}

std::vector<CaseGate> gates() {
  const std::string edge = "2 inside, but the layer at the edge is wrong by a share of itself";
  return joined({required_order("default", "density.L1", 1.0, edge),
                 {energy_gate("default")},
                 required_order("sphere", "density.L1", 1.0, edge),
                 {energy_gate("sphere"), no_heating_gate("default", 40), restart_gate("sphere", "axisymmetric runs")}});
}

Case affine_expansion() {
  return {.name = "affine-expansion",
          .kind = Kind::gas,
          .keys = Expansion().keys(),
          .sets = {{"ppc", 9.0}, {"cells", 40.0}},
          .york1997 = {{"ppc", 3.0}, {"cells", 100.0}},
          .york_step = york_step,
          .problem = gas_run(affine_flow),
          .studies = studies(),
          .gates = gates(),
          .levels = {40, 56, 80, 112, 160}};
}
PLUMBLINE_CASE(affine_expansion);

}  // namespace
}  // namespace plumbline::affine_expansion
