// A ring whose circles turn by different angles: shear and rotation, no change of volume.
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "cases/catalog/solid/annulus_points.hpp"
#include "cases/catalog/solid/manufactured_case.hpp"
#include "cases/harness/description/parameters.hpp"
#include "cases/harness/files/whole.hpp"

namespace plumbline {
namespace {

const std::vector<double> levels{16, 20, 24, 32, 40}, ends{16, 32};
const std::vector<double> roots_of_two{16, 23, 32, 45, 64};  // a factor of sqrt 2 apart

struct Vortex : Parameters {
  reference::VortexProblem motion;
  double end_time = 0;
  AnnulusLayout layout = nullptr;

  explicit Vortex(Parameters given = {}) : Parameters(std::move(given)) {
    motion.amplitude = within("amplitude", motion.amplitude, "rad", 0, 1.5, "A, largest angle");
    motion.youngs_modulus = positive("youngs_modulus", motion.youngs_modulus, "Pa", "E");
    motion.poisson = number(poisson_key(motion.poisson));
    motion.density = positive("initial_density", motion.density, "kg/m^3", "initial density");
    end_time = positive("t_end", 1, "s", "end time");
    layout = annulus_layout(text(layout_key("polar")));
  }
};

std::unique_ptr<Problem> run(const Settings& settings) {
  const Vortex at(settings);
  const reference::VortexProblem& ring = at.motion;
  ManufacturedSetup setup{.exact = reference::mms_vortex(ring), .end_time = at.end_time};
  GridSpec& grid = setup.grid;
  grid.dim = 2;
  grid.h = 1 / settings.number("cells");
  const int cells = whole(std::ceil(ring.outer / grid.h)) + 2;
  grid.cells = {2 * cells, 2 * cells, 1};
  grid.origin = {-cells * grid.h, -cells * grid.h, 0};
  setup.body = at.layout("ring", material_of(*setup.exact), {ring.inner, ring.outer}, ring.density,
                         settings.integer("ppc"), grid);
  return manufactured_problem(std::move(setup), settings);
}

std::vector<StudyPlan> studies() {
  return {study("default", "default", "Domains tile the ring as it turns and shears: second order.", ends)
              .in_full(roots_of_two),
          study("boxes", "boxes", "Second order as far as boxes tile: they do not where the shear is large.", {16})
              .with({{"shape", "contiguous-gimp"}, {"layout", "circles"}})
              .in_full(levels),
          study("cubic", "cubic B-splines", "Kernels that do not depend on the points' shapes.", levels)
              .with({{"shape", "cubic"}, {"layout", "circles"}})
              .in(Tier::full)};
}

std::vector<CaseGate> gates() {
  return joined(
      {displacement_orders({"default"}, 1.9, "second order; 0.1 for large shear on coarse meshes", Tier::full),
       {gate("default/worst-32", relative_error_at(32), at_most(2e-2),
             requirement("two per cent of the motion with 16 cells across the ring; four times what 64 must reach")),
        gate("default/worst-64", relative_error_at(64), at_most(5e-3),
             requirement("half a per cent of the motion, at a shear of 6 and with 32 cells across the ring"))
            .in(Tier::full)},
       displacement_orders({"boxes", "cubic"}, 1.8, "second order; 0.2 for large shear", Tier::full)});
}

Case mms_vortex() {
  return {.name = "mms-vortex",
          .kind = Kind::solid,
          .keys = Vortex().keys(),
          .sets = {{"cells", 32.0}, {"shape", "cpdi"}},
          .york1997 = {{"shape", "linear"}, {"layout", "circles"}},
          .york_step = courant_number(published_courant),
          .problem = run,
          .studies = studies(),
          .gates = gates(),
          .levels = roots_of_two};
}
PLUMBLINE_CASE(mms_vortex);

}  // namespace
}  // namespace plumbline
