// What the laboratory says of an elastic plate, against the waves' own matrices and against runs.
#include <cmath>
#include <utility>

#include "cases/catalog/stability/plate_waves.hpp"
#include "cases/catalog/stability/trial_case.hpp"
#include "cases/harness/judge/gates.hpp"
#include "cases/harness/laboratory/problem.hpp"

namespace plumbline::stability_plane {
namespace {

Findings against_waves(const std::string& integrator) {
  const StabilityProblem& plane = find_stability_problem("plane");
  struct Place {
    double x, y, nu;
  };
  Findings findings;
  double worst = 0;
  for (const Place& at : {Place{0.5, 0.5, 0}, Place{0.2, 0.3, 0.3}, Place{0.05, 0.4, -0.5}, Place{0.02, 0.02, 0.45}}) {
    const Settings settings = stability_settings(
        plane, "default", {{"integrator", integrator}, {"place_x", at.x}, {"place_y", at.y}, {"nu", at.nu}});
    worst = larger(worst, std::abs(plane.predicted(settings, 1e-6).limit() / plane.closed_form(settings)->limit - 1));
  }
  findings.measures.push_back(scalar_measure("limit.departure", worst, 0, 1e-9, "1"));
  return findings;
}

// One point beside the corner of its cell. The limit goes to 1/sqrt(2) with the first power of the distance.
Findings corner() {
  const StabilityProblem& plane = find_stability_problem("plane");
  constexpr double beside = 1e-4;
  Findings findings;
  double worst = 0;
  for (const double nu : {0.0, 0.3, 0.45}) {
    const Settings settings = stability_settings(plane, "default",
                                                 {{"place_x", beside}, {"place_y", beside}, {"nu", nu}});
    worst = larger(worst, std::abs(plane.predicted(settings, 1e-6).limit() * std::sqrt(2.0) - 1));
  }
  findings.measures.push_back(scalar_measure("corner.departure", worst, 0, 1e-15, "1"));
  return findings;
}

Findings tiled(const std::string& shape) {
  const StabilityProblem& plane = find_stability_problem("plane");
  const Settings settings = stability_settings(plane, "default", {{"shape", shape}, {"ppc", 2.0}});
  reference::MapScheme scheme;
  if (shape == "quadratic") scheme.shape = reference::GridShape::quadratic;
  const PlateLattice lattice{2, 0.5, 0.5};
  Findings findings;
  const double elastic = plane.predicted(settings, 1e-5).limit(), scalar = scalar_plate_limit(scheme, lattice);
  findings.measures = {scalar_measure("limit", elastic, plane.closed_form(settings)->limit, 1e-9, "h/c"),
                       finding("coupling", std::abs(elastic / scalar - 1)), finding("scalar", scalar, "h/c"),
                       finding("scalar_of_eight_cells", scalar_plate_limit(scheme, lattice, 8), "h/c")};
  return findings;
}

Findings runs() {
  const StabilityProblem& plane = find_stability_problem("plane");
  Findings findings;
  double worst = 0;
  for (const double place : {0.05, 0.5}) {  // the worst waves have two or four cells: eight hold them
    const Settings settings = stability_settings(plane, "default", {{"place_x", place}, {"place_y", place}});
    const double limit = plane.predicted(settings, 1e-6).limit();
    const Scan near{0.8 * limit, 1.25 * limit, 2};
    const auto seen = observe(experiment_of(plane, settings), near, plane.watch(settings), 3).brackets;
    worst = larger(worst, seen.empty() ? std::nan("") : std::abs(0.5 * (seen[0].low + seen[0].high) / limit - 1));
  }
  findings.measures.push_back(scalar_measure("observed.departure", worst, 0, 1e-15, "1"));
  return findings;
}

std::vector<Trial> trials() {
  const std::string waves = "Exact waves.";
  return {{"musl", "musl, one point a cell at four places", waves, [] { return against_waves("musl"); }},
          {"usl", "usl, the same", waves, [] { return against_waves("usl"); }, Tier::full},
          {"corner", "one point beside the corner of its cell", "First order in its distance.", corner},
          {"tiled-linear", "2 × 2 points a cell, linear", waves, [] { return tiled("linear"); }, Tier::full},
          {"tiled-quadratic", "2 × 2 points a cell, quadratic", waves, [] { return tiled("quadratic"); }, Tier::full},
          {"runs", "limits that runs show", "64 periods.", runs, Tier::full}};
}

std::vector<CaseGate> gates() {
  const Because sampled = theory("the waves' own matrices; waves are sampled, and bisected to 1e-6: 1e-3 at most");
  const Number relative = number_at("relative error of limit", "limit", trial_level,
                                    [](const RunResult&, const Measure& m) { return Measured::of(m.error / m.scale); });
  std::vector<CaseGate> all{gate("musl/limit", error_of("limit.departure"), at_most(1e-3), sampled),
                            gate("usl/limit", error_of("limit.departure"), at_most(1e-3), sampled).in(Tier::full),
                            gate("corner/limit", error_of("corner.departure"), at_most(1e-3),
                                 theory("1/√2, to ten times the distance from the corner"))};
  for (const auto& [study, eight] : {std::pair{std::string("tiled-linear"), 1.79}, {"tiled-quadratic", 2.45}}) {
    all.push_back(gate(study + "/coupling", value_of("coupling"), at_most(0.01),
                       requirement("pressure and shear waves together have the limit of a scalar wave, within 1 %, a "
                                   "tenth of the margin that cfl=auto leaves below a limit"))
                      .in(Tier::full));
    all.push_back(gate(study + "/limit", relative, at_most(1e-3), sampled).in(Tier::full));
    all.push_back(
        gate(study + "/eight-cells", value_of("scalar_of_eight_cells"), between(0.99 * eight, 1.01 * eight),
             requirement("the limit of a periodic patch of 8 × 8 cells, computed before this program was to "
                         "three digits, within 1 %, a tenth of the margin that cfl=auto leaves below a limit"))
            .in(Tier::full));
  }
  all.push_back(
      gate("runs/limit", error_of("observed.departure"), at_most(0.01), requirement(observed_limits)).in(Tier::full));
  return all;
}

Case stability_plane() { return trial_case("stability-plane", trials(), gates()); }
PLUMBLINE_CASE(stability_plane);

}  // namespace
}  // namespace plumbline::stability_plane
