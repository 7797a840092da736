// A ring whose circles turn by different angles: shear and rotation, no change of volume.
#include <cmath>

#include "cases/catalog/solid/annulus_points.hpp"
#include "cases/catalog/solid/manufactured_case.hpp"
#include "cases/harness/files/whole.hpp"

namespace plumbline {
namespace {

class MmsVortex final : public ManufacturedCase {
 public:
  std::string name() const override { return "mms-vortex"; }

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
