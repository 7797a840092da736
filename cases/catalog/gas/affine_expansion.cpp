// A cylinder or sphere of gas that expands into a vacuum, every part of it in proportion.
#include "reference/affine_expansion.hpp"

#include <memory>
#include <optional>

#include "cases/catalog/gas/expansion_watch.hpp"
#include "cases/catalog/gas/fill_ball.hpp"
#include "cases/catalog/gas/gas_case.hpp"
#include "cases/harness/files/errors.hpp"
#include "cases/harness/verify/restart_gate.hpp"

namespace plumbline {
namespace {

RadialGeometry geometry_of(const Settings& settings) {
  const int dimension = settings.text("body") == "cylinder" ? 2 : 3;
  const std::string& name = settings.text("geometry");
  for (const RadialGeometry& geometry : radial_geometries(dimension)) {
    if (geometry.name == name) return geometry;
  }
  throw UsageError("geometry", name, dimension == 2 ? "axisymmetric, plane" : "axisymmetric, 3d", {},
                   "geometry=" + name + " cannot hold body=" + settings.text("body"));
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
  const RadialGeometry geometry = geometry_of(settings);
  reference::AffineExpansionProblem problem;
  problem.dimension = geometry.dimension;
  problem.gamma = settings.number("gamma");
  const auto exact = std::make_shared<ExactGas>(problem);
  GasFlow flow;
  flow.end_time = settings.number("t_end");
  flow.gamma = problem.gamma;
  const double h = cell_size(flow, settings), end = exact->gas().radius(flow.end_time).value;
  set_geometry(flow, geometry, end + 4 * h, settings);
  flow.initial = [exact](double r) {
    const reference::Sample at = exact->sample(r, 0);
    return reference::GasState{at.density.value, 0, at.pressure.value};
  };
  flow.exact = [exact](double r, double t) { return exact->sample(r, t); };
  flow.fill = [geometry, problem, initial = flow.initial](std::shared_ptr<const IdealGas> gas, const PointRule& rule,
                                                          const GridSpec& grid) {
    return fill_ball(std::move(gas), {geometry, problem.radius, initial, false}, rule, grid);
  };
  const auto watch = watch_expansion(flow);
  // Of one entropy everywhere.
  const double entropy = problem.pressure * std::pow(problem.density, -problem.gamma);
  flow.further = [watch, entropy, exact, gamma = problem.gamma](const std::vector<GasSample>& points, double time) {
    std::vector<Measure> all = watch->measures();
    all.push_back(entropy_error(points, gamma, entropy));
    double edge = 0;
    for (const GasSample& p : points) edge = larger(edge, p.coordinate);
    const reference::Bounded radius = exact->gas().radius(time);
    all.push_back(scalar_measure("edge", edge, radius.value, radius.bound, "m"));
    return all;
  };
  return flow;
}

class AffineExpansionCase final : public Case {
 public:
  std::string name() const override { return "affine-expansion"; }

  Kind kind() const override { return Kind::gas; }

  std::vector<Key> keys() const override {
    return {{.name = "body", .value = "cylinder", .choices = {"cylinder", "sphere"}, .description = "what expands"},
            {.name = "geometry",
             .value = "plane",
             .choices = {"plane", "axisymmetric", "3d"},
             .description = "plane: a quarter of the cylinder; axisymmetric: a slice of the cylinder or a quarter of "
                            "the sphere's section; 3d: the sphere's octant"},
            {.name = "gamma", .value = 1.4, .low = 1.1, .high = 3, .description = "ratio of specific heats"},
            {.name = "t_end",
             .value = 0.01,
             .unit = "s",
             .low = 0,
             .high = 0.05,
             .low_open = true,
             .description = "end time"}};
  }

  std::vector<Override> points_and_end(const std::string& scheme) const override {
    if (scheme == "york1997") return york_points(scheme);
    return {{"ppc", 4.0}, {"cells", 40.0}};
  }
  void derive(Settings& settings, const std::string& scheme) const override { york_step(settings, scheme); }
  std::unique_ptr<Problem> problem(const Settings& settings) const override {
    return gas_problem(affine_flow(settings), settings);
  }
  std::vector<double> default_levels() const override { return {40, 56, 80, 112, 160}; }
  std::vector<StudyPlan> studies() const override {
    StudyPlan cylinder{.id = "default",
                       .title = "default, a quarter of the cylinder",
                       .why = "Smooth but for the edge: 2 in the density, 1 in the velocity.",
                       .values = {40, 56, 80, 112, 160}};
    StudyPlan sphere = cylinder;
    sphere.id = "sphere";
    sphere.title = "default, the sphere by rings";
    sphere.overrides = {{"body", std::string("sphere")}, {"geometry", std::string("axisymmetric")}};
    return {cylinder, sphere};
  }
  std::vector<CaseGate> gates() const override {
    std::vector<CaseGate> all;
    for (const char* study : {"default", "sphere"}) {
      for (CaseGate& gate : required_order(study, "density.L1", 1.0,
                                           "2 inside, but the layer at the edge is wrong by a share of itself")) {
        all.push_back(std::move(gate));
      }
      all.push_back(energy_gate(study));
    }
    all.push_back(no_heating_gate("default", 40));
    all.push_back(restart_gate("sphere", "axisymmetric runs"));
    return all;
  }
};

PLUMBLINE_CASE(AffineExpansionCase);

}  // namespace
}  // namespace plumbline
