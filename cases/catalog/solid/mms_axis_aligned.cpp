// A square and a cube whose planes move as sin(pi X_i), each along its own axis.
#include "cases/catalog/solid/fill_solid.hpp"
#include "cases/catalog/solid/manufactured_case.hpp"

namespace plumbline {
namespace {

class MmsAxisAligned final : public ManufacturedCase {
 public:
  std::string name() const override { return "mms-axis-aligned"; }

  std::vector<Key> keys() const override {
    const reference::AxisAlignedProblem square = reference::mms_square_problem();
    return {{.name = "dimension", .value = 2.0, .low = 2, .high = 3, .integer = true, .description = "square or cube"},
            {.name = "amplitude",
             .value = square.amplitude,
             .unit = "m",
             .low = 0,
             .high = 0.3,
             .low_open = true,
             .description = "A, largest displacement"},
            positive_key("youngs_modulus", square.youngs_modulus, "Pa", "E"),
            poisson_key(square.poisson),
            positive_key("initial_density", square.density, "kg/m^3", "initial density"),
            positive_key("t_end", 0.006, "s", "end time")};
  }

  std::vector<double> default_levels() const override { return {6, 8, 11, 16, 22}; }

  std::vector<StudyPlan> studies() const override {
    const std::string why = "Boxes tile the body throughout: order 2.";
    return {{.id = "plane",
             .title = "default, square",
             .why = why,
             .values = {6, 8, 11, 16, 22},
             .full_values = {8, 12, 16, 24, 32, 48, 64}},
            {.id = "space",
             .title = "default, cube",
             .why = why,
             .overrides = {{"dimension", 3.0}},
             .values = {5, 6, 8, 9, 11},
             .full_values = {6, 8, 11, 16, 22}}};
  }

  std::vector<CaseGate> gates() const override {
    std::vector<CaseGate> all = displacement_order("plane", 1.8, "second order; 0.2 for coarse meshes");
    for (CaseGate& gate : displacement_order("space", 1.8, "second order; 0.2 for coarse meshes")) {
      all.push_back(std::move(gate));
    }
    return all;
  }

 protected:
  ManufacturedSetup setup(const Settings& settings) const override {
    const int dim = settings.integer("dimension");
    const double amplitude = settings.number("amplitude");
    reference::AxisAlignedProblem problem = dim == 2 ? reference::mms_square_problem(amplitude)
                                                     : reference::mms_cube_problem(amplitude);
    problem.youngs_modulus = settings.number("youngs_modulus");
    problem.poisson = settings.number("poissons_ratio");
    problem.density = settings.number("initial_density");
    ManufacturedSetup setup;
    setup.exact = reference::mms_axis_aligned(problem);
    setup.grid.dim = dim;
    setup.grid.h = problem.length / settings.number("cells");
    SolidShape cube;
    for (std::size_t d = 0; d < static_cast<std::size_t>(dim); ++d) {
      setup.grid.cells[d] = settings.integer("cells");
      setup.grid.walls[d] = {Wall::symmetry, Wall::symmetry};
      cube.high[d] = problem.length;
    }
    setup.body = lattice_body(cube, setup.exact, settings.integer("ppc"), setup.grid);
    return setup;
  }
};

PLUMBLINE_CASE(MmsAxisAligned);

}  // namespace
}  // namespace plumbline
