// A square and a cube whose planes move as sin(pi X_i), each along its own axis.
#include "cases/solid/fill_solid.hpp"
#include "cases/solid/manufactured_case.hpp"

namespace plumbline {
namespace {

constexpr const char* sketch =
    R"svg(<svg viewBox="0 0 470 160" role="img" aria-label="A square between four walls; lines of points along x and y move apart and together">
<g stroke="currentColor" stroke-width="1.5" fill="none"><path d="M115 15h130v130h-130z"/><path d="M115 80h40m-8-5l8 5l-8 5M245 80h-40m8-5l-8 5l8 5M180 15v40m-5-8l5 8l5-8M180 145v-40m-5 8l5-8l5 8"/></g>
<g stroke="currentColor" stroke-width=".6" opacity=".6"><path d="M125 15v130M140 15v130M160 15v130M200 15v130M220 15v130M235 15v130M115 25h130M115 40h130M115 60h130M115 100h130M115 120h130M115 135h130"/></g>
<g fill="currentColor" font-size="12"><text x="255" y="84">u_i = A sin πX_i sin(πct + φ_i)</text><text x="20" y="84">no friction</text></g></svg>)svg";

class MmsAxisAligned final : public ManufacturedCase {
 public:
  Statement statement() const override {
    Statement s = begin_statement();
    s.name = "mms-axis-aligned";
    s.title = "Manufactured solution: square and cube";
    s.source =
        "P. C. Wallstedt, J. E. Guilkey, J. Comput. Phys. 227 (2008) 9628, doi 10.1016/j.jcp.2008.07.019, section 5.1; "
        "phases in space: the verification suite of Uintah";
    s.claim = "In the plane and in space, too, the displacement is of second order while points cross cells.";
    s.physics =
        "A unit square (plane strain) or cube moves along each axis as u_i = A sin πX_i sin(πct + φ_i), E = 1e4, "
        "ν = 0.3, ρ₀ = 1, c = 100, A = 0.1, for 0.3 of the period of 0.02 s, where nothing is as it was at the start; "
        "strains reach 31 %. φ = (0, π) in the plane, "
        "(0, 2π/3, 4π/3) in space. Faces stay in their planes and free of shear: walls without friction hold them.\n\n"
        "F stays diagonal: boxes along the axes follow it exactly and go on tiling the body.";
    s.sketch = sketch;
    s.cells_along = "the edge of 1 m";
    s.known_limits = {"Nothing turns or shears: see mms-vortex for that."};
    return s;
  }

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

  GateCount gate_count() const override { return {14, 14}; }

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
