// A ring that breathes across an unaligned grid.
#include <cmath>

#include "cases/catalog/solid/annulus_points.hpp"
#include "cases/catalog/solid/manufactured_case.hpp"
#include "cases/harness/files/whole.hpp"
#include "cases/harness/verify/restart_gate.hpp"

namespace plumbline {
namespace {

const std::vector<double> fine{16, 24, 32, 48, 64};

class MmsRing final : public ManufacturedCase {
 public:
  std::string name() const override { return "mms-ring"; }

  std::vector<Key> keys() const override {
    const reference::RingProblem ring;
    return {{.name = "amplitude",
             .value = ring.amplitude,
             .unit = "m",
             .low = 0,
             .high = 0.2,
             .low_open = true,
             .description = "A, displacement of the outer edge at the start"},
            positive_key("youngs_modulus", ring.youngs_modulus, "Pa", "E"),
            positive_key("initial_density", ring.density, "kg/m^3", "initial density"),
            positive_key("t_end", 0.026, "s", "end time"),
            {.name = "layout",
             .value = "cut",
             .choices = {"cut", "circles", "lattice"},
             .description = "the lattice with cut squares, points on circles, or whole squares"}};
  }

  std::vector<double> default_levels() const override { return {8, 10, 12, 16, 20, 24}; }

  std::vector<StudyPlan> studies() const override {
    const std::vector<double> coarse{8, 10, 12, 16, 20, 24};
    return {
        {.id = "default",
         .title = "default",
         .why = "Maps, forces and step are of second order while boxes tile the ring.",
         .values = coarse},
        {.id = "fine",
         .title = "default, fine meshes",
         .why = "Boxes that overlap by a share that does not fall with h: no order.",
         .values = fine,
         .tier = Tier::full},
        {.id = "circles",
         .title = "default, points on circles",
         .why = "Edges exact; boxes gape and overlap.",
         .overrides = {{"layout", "circles"}},
         .values = fine,
         .tier = Tier::full},
        {.id = "lattice",
         .title = "default, whole squares",
         .why = "Edges are stairs of half a spacing: order 1.",
         .overrides = {{"layout", "lattice"}},
         .values = fine,
         .tier = Tier::full},
        {.id = "cubic",
         .title = "cubic B-splines",
         .why = "Kernels that do not depend on the points' shapes: order 2, with the larger error of a wider kernel.",
         .overrides = {{"shape", "cubic"}},
         .values = coarse,
         .full_values = fine}};
  }

  std::vector<CaseGate> gates() const override {
    std::vector<CaseGate> all = displacement_order("default", 1.8, "second order; 0.2 for curved edges");
    const std::string boxes =
        "boxes along the axes overlap where F shears, by a share that does not fall with h; its force grows as 1/h";
    all.push_back(missed_order("fine", fine, 1.8, boxes, {0.80, 1.00}));
    all.push_back(missed_order("circles", fine, 1.8, boxes, {0.05, 0.23}));
    all.push_back(missed_order("lattice", fine, 1.8, "edges are stairs: first order", {0.85, 1.02}));
    for (std::size_t k = 2; k < 5; ++k) all[k].tier = Tier::full;
    for (CaseGate& gate : displacement_order("cubic", 1.8, "second order; 0.2 for curved edges")) {
      all.push_back(std::move(gate));
    }
    all.push_back(restart_gate("default", "runs under loads"));
    return all;
  }

 protected:
  ManufacturedSetup setup(const Settings& settings) const override {
    reference::RingProblem problem;
    problem.amplitude = settings.number("amplitude");
    problem.youngs_modulus = settings.number("youngs_modulus");
    problem.density = settings.number("initial_density");
    ManufacturedSetup setup;
    setup.exact = reference::mms_ring(problem);
    setup.grid.dim = 2;
    setup.grid.h = problem.outer / settings.number("cells");
    const int cells = whole(std::ceil((problem.outer + problem.amplitude) / setup.grid.h)) + 2;
    setup.grid.cells = {cells, cells, 1};
    for (std::size_t d = 0; d < 2; ++d) setup.grid.walls[d] = {Wall::symmetry, Wall::free};
    const Annulus quarter{problem.inner, problem.outer, {0, 0}, true};
    const auto fill = annulus_layout(settings.text("layout"));
    setup.body = [=, grid = setup.grid, ppc = settings.integer("ppc")](std::shared_ptr<const Material> material) {
      return fill("ring", std::move(material), quarter, problem.density, ppc, grid);
    };
    return setup;
  }
};

PLUMBLINE_CASE(MmsRing);

}  // namespace
}  // namespace plumbline
