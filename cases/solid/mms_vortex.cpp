// A ring whose circles turn by different angles: shear and rotation, no change of volume.
#include <cmath>

#include "cases/harness/whole.hpp"
#include "cases/solid/annulus_points.hpp"
#include "cases/solid/manufactured_case.hpp"

namespace plumbline {
namespace {

constexpr const char* sketch =
    R"svg(<svg viewBox="0 0 360 170" role="img" aria-label="A ring; its middle circle turns to and fro, its edges rest">
<g stroke="currentColor" stroke-width="1.5" fill="none"><circle cx="140" cy="85" r="75"/><circle cx="140" cy="85" r="45"/><circle cx="140" cy="85" r="60" stroke-dasharray="4 3"/><path d="M140 40q22-8 38-2q-4-14 7-12M140 10v30" /><path d="M198 70a60 60 0 0 0-14-25m-1 9l1-9l8 3"/></g>
<g fill="currentColor" font-size="12"><text x="226" y="60">0.75 ≤ R ≤ 1.25</text><text x="226" y="80">α = A sin(πt/T) h(R)</text><text x="226" y="100">both edges rest</text></g></svg>)svg";

class MmsVortex final : public ManufacturedCase {
 public:
  Statement statement() const override {
    Statement s = begin_statement();
    s.name = "mms-vortex";
    s.title = "Manufactured solution: generalised vortex";
    s.source =
        "K. Kamojjala, R. Brannon, A. Sadeghirad, J. Guilkey, Eng. Comput. 31 (2015) 207, doi "
        "10.1007/s00366-013-0342-x";
    s.claim = "Rotation and large shear, the hardest of the manufactured solutions.";
    s.physics =
        "Each circle of a ring, 0.75 <= R <= 1.25, turns by α = A sin(πt/T) (1 − 4s²)², s = (R − 1)/0.5, with A = 1 "
        "radian, T = 1 s; E = 1000, ν = 0.3, ρ₀ = 1000, plane strain. At t = T/2 the shear R dα/dR exceeds 6; volumes "
        "do not change. Both edges rest and are free of traction, but the shear grows from them inwards by 128 a "
        "metre: at 16 "
        "cells a metre the points next to an edge are sheared by 2.\n\n"
        "Points stand on circles (`layout=circles`): what sticks out of a stair at an edge (`lattice`, `cut`) is torn "
        "off by the body force.";
    s.sketch = sketch;
    s.cells_along = "a length of 1 m";
    s.known_limits = {
        "Boxes along the axes follow the second moments of the deformed box, not its shape; at large shear they grow "
        "beyond half a cell, where they are cut."};
    return s;
  }

  std::vector<Key> keys() const override {
    const reference::VortexProblem vortex;
    return {{.name = "amplitude",
             .value = vortex.amplitude,
             .unit = "rad",
             .low = 0,
             .high = 1.5,
             .low_open = true,
             .description = "A, largest angle"},
            positive_key("youngs_modulus", vortex.youngs_modulus, "Pa", "E"),
            poisson_key(vortex.poisson),
            positive_key("initial_density", vortex.density, "kg/m^3", "initial density"),
            positive_key("t_end", 1, "s", "end time"),
            {.name = "layout",
             .value = "circles",
             .choices = {"cut", "circles", "lattice"},
             .description = "the lattice with cut squares, points on circles, or whole squares"}};
  }

  std::vector<double> default_levels() const override { return {16, 20, 24, 32, 40}; }

  std::vector<StudyPlan> studies() const override {
    const std::vector<double> levels{16, 20, 24, 32, 40};
    return {{.id = "default",
             .title = "default",
             .why = "Second order as far as boxes tile: they do not where the shear is large.",
             .values = {16},
             .full_values = levels},
            {.id = "cubic",
             .title = "cubic B-splines",
             .why = "Kernels that do not depend on the points' shapes.",
             .overrides = {{"shape", "cubic"}},
             .values = levels,
             .tier = Tier::full}};
  }

  std::vector<CaseGate> gates() const override {
    std::vector<CaseGate> all;
    for (const char* study : {"default", "cubic"}) {
      for (CaseGate& gate : displacement_order(study, 1.8, "second order; 0.2 for large shear", Tier::full)) {
        all.push_back(std::move(gate));
      }
    }
    return all;
  }

  GateCount gate_count() const override { return {5, 14}; }

 protected:
  ManufacturedSetup setup(const Settings& settings) const override {
    reference::VortexProblem problem;
    problem.amplitude = settings.number("amplitude");
    problem.youngs_modulus = settings.number("youngs_modulus");
    problem.poisson = settings.number("poissons_ratio");
    problem.density = settings.number("initial_density");
    ManufacturedSetup setup;
    setup.exact = reference::mms_vortex(problem);
    setup.grid.dim = 2;
    setup.grid.h = 1 / settings.number("cells");
    const int cells = whole(std::ceil(problem.outer / setup.grid.h)) + 2;
    setup.grid.cells = {2 * cells, 2 * cells, 1};
    setup.grid.origin = {-cells * setup.grid.h, -cells * setup.grid.h, 0};
    const Annulus ring{problem.inner, problem.outer};
    const auto fill = annulus_layout(settings.text("layout"));
    setup.body = [=, grid = setup.grid, ppc = settings.integer("ppc")](std::shared_ptr<const Material> material) {
      return fill("ring", std::move(material), ring, problem.density, ppc, grid);
    };
    return setup;
  }
};

PLUMBLINE_CASE(MmsVortex);

}  // namespace
}  // namespace plumbline
