// A ring that breathes across an unaligned grid.
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "cases/catalog/solid/annulus_points.hpp"
#include "cases/catalog/solid/manufactured_case.hpp"
#include "cases/harness/description/parameters.hpp"
#include "cases/harness/files/whole.hpp"
#include "cases/harness/verify/restart_gate.hpp"

namespace plumbline {
namespace {

const std::vector<double> coarse{8, 10, 12, 16, 20, 24}, fine{16, 24, 32, 48, 64};

struct BreathingRing : Parameters {
  reference::RingProblem motion;
  double end_time = 0;
  AnnulusLayout layout = nullptr;

  explicit BreathingRing(Parameters given = {}) : Parameters(std::move(given)) {
    motion.amplitude = within("amplitude", motion.amplitude, "m", 0, 0.2,
                              "A, displacement of the outer edge at the start");
    motion.youngs_modulus = positive("youngs_modulus", motion.youngs_modulus, "Pa", "E");
    motion.density = positive("initial_density", motion.density, "kg/m^3", "initial density");
    end_time = positive("t_end", 0.026, "s", "end time");
    layout = annulus_layout(text(layout_key("cut")));
  }
};

std::unique_ptr<Problem> run(const Settings& settings) {
  const BreathingRing at(settings);
  const reference::RingProblem& ring = at.motion;
  ManufacturedSetup setup{.exact = reference::mms_ring(ring), .end_time = at.end_time};
  GridSpec& grid = setup.grid;
  grid.dim = 2;
  grid.h = ring.outer / settings.number("cells");
  const int cells = whole(std::ceil((ring.outer + ring.amplitude) / grid.h)) + 2;
  grid.cells = {cells, cells, 1};
  grid.walls[0] = grid.walls[1] = {Wall::symmetry, Wall::free};
  setup.body = at.layout("ring", material_of(*setup.exact), {ring.inner, ring.outer, {0, 0}, true}, ring.density,
                         settings.integer("ppc"), grid);
  return manufactured_problem(std::move(setup), settings);
}

std::vector<StudyPlan> studies() {
  return {
      study("default", "default", "Maps, forces and step are of second order while boxes tile the ring.", coarse),
      study("fine", "default, fine meshes", "Boxes that overlap by a share that does not fall with h: no order.", fine)
          .in(Tier::full),
      study("circles", "default, points on circles", "Edges exact; boxes gape and overlap.", fine)
          .with({{"layout", "circles"}})
          .in(Tier::full),
      study("lattice", "default, whole squares", "Edges are stairs of half a spacing: order 1.", fine)
          .with({{"layout", "lattice"}})
          .in(Tier::full),
      study("cubic", "cubic B-splines",
            "Kernels that do not depend on the points' shapes: order 2, with the larger error of a wider kernel.",
            coarse)
          .with({{"shape", "cubic"}})
          .in_full(fine)};
}

std::vector<CaseGate> gates() {
  const std::string curved = "second order; 0.2 for curved edges";
  const std::string boxes =
      "boxes along the axes overlap where F shears, by a share that does not fall with h; its force grows as 1/h";
  return joined({displacement_orders({"default"}, 1.8, curved),
                 {missed_order("fine", fine, 1.8, boxes, {0.80, 1.00}).in(Tier::full),
                  missed_order("circles", fine, 1.8, boxes, {0.05, 0.23}).in(Tier::full),
                  missed_order("lattice", fine, 1.8, "edges are stairs: first order", {0.85, 1.02}).in(Tier::full)},
                 displacement_orders({"cubic"}, 1.8, curved),
                 {restart_gate("default", "runs under loads")}});
}

Case mms_ring() {
  return {.name = "mms-ring",
          .kind = Kind::solid,
          .keys = BreathingRing().keys(),
          .sets = {{"cells", 32.0}},
          .york_step = courant_number(published_courant),
          .problem = run,
          .studies = studies(),
          .gates = gates(),
          .levels = coarse};
}
PLUMBLINE_CASE(mms_ring);

}  // namespace
}  // namespace plumbline
