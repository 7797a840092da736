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

namespace plumbline::mms_ring {
namespace {

const std::vector<double> coarse{8, 10, 12, 16, 20, 24}, fine{16, 24, 32, 48, 64};
const std::vector<double> octave{16, 32}, roots_of_two{16, 23, 32, 45, 64};  // a factor of sqrt 2 apart

Key load_key() {
  return {.name = "load",
          .value = std::string("manufactured"),
          .choices = {"manufactured", "none"},
          .description = "the body force of the manufactured motion, or none: the ring is let go"};
}

struct BreathingRing : Parameters {
  reference::RingProblem motion;
  double end_time = 0;
  AnnulusLayout layout = nullptr;
  bool loaded = true;

  explicit BreathingRing(Parameters given = {}) : Parameters(std::move(given)) {
    motion.amplitude = within("amplitude", motion.amplitude, "m", 0, 0.2,
                              "A, displacement of the outer edge at the start");
    motion.youngs_modulus = positive("youngs_modulus", motion.youngs_modulus, "Pa", "E");
    motion.density = positive("initial_density", motion.density, "kg/m^3", "initial density");
    end_time = positive("t_end", 0.026, "s", "end time");
    layout = annulus_layout(text(layout_key("polar")));
    loaded = text(load_key()) == "manufactured";
  }
};

std::unique_ptr<Problem> run(const Settings& settings) {
  const BreathingRing at(settings);
  const reference::RingProblem& ring = at.motion;
  ManufacturedSetup setup{.exact = reference::mms_ring(ring), .end_time = at.end_time, .loaded = at.loaded};
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

const std::vector<Override> boxes{{"shape", "contiguous-gimp"}, {"layout", "cut"}};

std::vector<StudyPlan> studies() {
  return {study("default", "default", "Domains tile the ring as it deforms; maps, forces and step are of second order.",
                octave)
              .in_full(roots_of_two),
          study("released", "default, let go", "No load: energy falls by what the maps take, and never rises.", {32})
              .with({{"load", "none"}}),
          study("boxes", "boxes on cut squares", "Of second order while what boxes overlap by is small.", coarse)
              .with(boxes),
          study("fine", "boxes on cut squares, fine meshes",
                "They overlap by a share that does not fall with h: no order.", fine)
              .with(boxes)
              .in(Tier::full),
          study("circles", "boxes on circles", "Edges exact; boxes gape and overlap.", fine)
              .with({{"shape", "contiguous-gimp"}, {"layout", "circles"}})
              .in(Tier::full),
          study("lattice", "boxes on whole squares", "Edges are stairs of half a spacing: order 1.", fine)
              .with({{"shape", "contiguous-gimp"}, {"layout", "lattice"}})
              .in(Tier::full),
          study("squares", "domains on cut squares", "Squares deform as the ring does, but do not tile its edge.", fine)
              .with({{"layout", "cut"}})
              .in(Tier::full),
          study("cubic", "cubic B-splines",
                "Kernels that do not depend on the points' shapes: order 2, with the larger error of a wider kernel.",
                coarse)
              .with({{"shape", "cubic"}, {"layout", "cut"}})
              .in_full(fine)};
}

std::vector<CaseGate> gates() {
  const std::string curved = "second order; 0.2 for curved edges";
  const std::string overlap =
      "boxes along the axes overlap where F shears, by a share that does not fall with h; its force grows as 1/h";
  return joined(
      {displacement_orders({"default"}, 1.95,
                           "second order, as with points that stay in their cells; 0.05 for coarse meshes", Tier::full),
       {gate("default/worst-32", error_at("displacement.worst", 32), at_most(1.2e-4),
             requirement("four times what 64 must reach: second order")),
        gate("default/worst-64", error_at("displacement.worst", 64), at_most(3e-5),
             requirement("a third of a thousandth of the motion, whose norm is 0.09; of the full ring twice both"))
            .in(Tier::full),
        gate(
            "released/energy-lost", value_at("energy_lost", 32), at_most(2e-3),
            requirement("in 1.3 periods the amplitude, as the root of the energy, falls by a thousandth: less than the "
                        "width of a line in a plot")),
        gate("released/energy-rise", value_at("energy_rise", 32), at_most(1e-13),
             requirement("a ring that is let go gains no energy in any step; 1e-13 for the rounding of sums"))},
       displacement_orders({"boxes"}, 1.8, curved),
       {missed_order("fine", fine, 1.8, overlap, {0.80, 1.00}).in(Tier::full),
        missed_order("circles", fine, 1.8, overlap, {0.05, 0.23}).in(Tier::full),
        missed_order("lattice", fine, 1.8, "edges are stairs: first order", {0.85, 1.02}).in(Tier::full),
        missed_order("squares", fine, 1.8, "squares of the cut pieces' moments do not tile the edge", {0.58, 0.77})
            .in(Tier::full)},
       displacement_orders({"cubic"}, 1.8, curved),
       {restart_gate("default", "runs under loads")}});
}

Case mms_ring() {
  return {.name = "mms-ring",
          .kind = Kind::solid,
          .keys = BreathingRing().keys(),
          .sets = {{"cells", 32.0}, {"shape", "cpdi"}},
          .york1997 = {{"shape", "linear"}, {"layout", "cut"}},
          .york_step = courant_number(published_courant),
          .problem = run,
          .studies = studies(),
          .gates = gates(),
          .levels = roots_of_two};
}
PLUMBLINE_CASE(mms_ring);

}  // namespace
}  // namespace plumbline::mms_ring
