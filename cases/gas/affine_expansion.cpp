// A cylinder or sphere of gas that expands into a vacuum, every part of it in proportion.
#include "reference/affine_expansion.hpp"

#include <memory>
#include <optional>

#include "cases/gas/expansion_watch.hpp"
#include "cases/gas/fill_ball.hpp"
#include "cases/gas/gas_case.hpp"
#include "cases/harness/errors.hpp"
#include "cases/harness/restart_gate.hpp"

namespace plumbline {
namespace {

constexpr const char* sketch =
    R"svg(<svg viewBox="0 0 360 150" role="img" aria-label="A quarter of a gas cylinder, densest at the centre, expanding into a vacuum">
<g stroke="currentColor" stroke-width="1.5" fill="none"><path d="M110 10v125h200"/><path d="M110 45a90 90 0 0 1 90 90"/><path d="M110 25a110 110 0 0 1 110 110" stroke-dasharray="4 3"/><path d="M176 69l15 -15m-9 1l9 -1l-1 9"/></g>
<g fill="currentColor"><path d="M110 135v-90a90 90 0 0 1 90 90z" opacity=".08"/><path d="M110 135v-65a65 65 0 0 1 65 65z" opacity=".12"/><path d="M110 135v-40a40 40 0 0 1 40 40z" opacity=".2"/></g>
<g fill="currentColor" font-size="12"><text x="190" y="149">R₀</text><text x="214" y="149">R(t)</text><text x="250" y="60">vacuum</text></g></svg>)svg";

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
  Statement statement() const override {
    Statement s;
    s.name = "affine-expansion";
    s.title = "A gas that expands into a vacuum in proportion";
    s.source =
        "L. V. Ovsiannikov, Dokl. Akad. Nauk SSSR 111 (1956) 47; F. J. Dyson, J. Math. Mech. 18 (1968) 91; L. I. "
        "Sedov, Similarity and Dimensional Methods in Mechanics, 1959, chapter IV";
    s.claim = "Into a vacuum, too, the flow converges, and nothing that only expands is ever heated.";
    s.physics =
        "A cylinder or sphere of gas at rest, R₀ = 0.38 m, with ρ = p_c/… falling as (1 − ξ²)^(1/(γ−1)) and p as "
        "(1 − ξ²)^(γ/(γ−1)) from the centre (ρ = 1, p = 100) to nothing at its edge ξ = 1. Everywhere the same "
        "entropy, and a push that grows in proportion to the radius: the gas stays similar to itself, u = Ṙ ξ, while "
        "its edge goes as R(t): 0.402624 at t = 0.005 and 0.466320 at 0.01 for the cylinder.\n\n"
        "Near vacuum: density vanishes as (distance to the edge)^2.5 and internal energy in proportion to the "
        "distance. Within a kernel of the edge grid density is that of the kernel, not of the gas: an error of order "
        "one in a layer one cell thick that holds (h/R)^3.5 of the mass. Its push is wrong there by a share that does "
        "not fall with h; so the edge is never exact to better than its share of one cell, and volumes there weigh "
        "the error of the thinnest gas most.\n\n"
        "`energy_ratio` is the largest internal energy that any point ever has, over its own at the start; "
        "`energy_rise` is the same as a difference over the centre's; `entropy.L1` a mean over the mass.\n\n"
        "Points: of equal mass in shells and sectors whose spacing follows ρ^(−1/d), at least one a cell along each "
        "direction; of equal volume on a lattice, their masses following ρ.";
    s.equations = {"R̈ = 2γ/(γ − 1) · p_c/ρ_c · (R₀/R)^(d(γ−1)) / R", "ρ = ρ_c (R₀/R)^d (1 − ξ²)^(1/(γ−1)),  ξ = r/R",
                   "u = Ṙ ξ", "p = (γ − 1) ρ e,  p ρ^−γ the same everywhere and always"};
    s.sketch = sketch;
    s.cells_along = "a length of 1 m";
    s.reference_name = "affine-expansion";
    s.reference_text = "The ordinary differential equation of R, solved by quadrature; fields in closed form.";
    s.reference_bound = "Computed: quadrature and rounding.";
    s.theory_orders = {
        {"density.L1", 2,
         "smooth inside; the layer at the edge holds a share (h/R)^3.5 of the mass and even less of "
         "the density's error"},
        {"velocity.L1", 1, "wrong by a share of itself in a layer one cell thick at the edge"},
        {"energy.L1", 1, "as the velocity; the energy falls to zero there, so that it may do better"},
        {"energy_ratio", 0, "the coldest points are at the edge: a share of their own that does not fall with h"}};
    s.known_limits = {
        "At the edge a point's internal energy tends to zero, and so does what makes any heating of it small: "
        "`energy_ratio` is the strictest measure there can be."};
    return s;
  }

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
      for (CaseGate& gate : target_order(study, "density.L1", 1.0,
                                         "2 inside, but the layer at the edge is wrong by a share of itself")) {
        all.push_back(std::move(gate));
      }
      all.push_back(energy_gate(study));
    }
    all.push_back(no_heating_gate("default", 40));
    all.push_back(restart_gate("sphere", "axisymmetric runs"));
    return all;
  }
  GateCount gate_count() const override { return {17, 17}; }
};

PLUMBLINE_CASE(AffineExpansionCase);

}  // namespace
}  // namespace plumbline
