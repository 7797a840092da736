// Sod's shock tube in space.
#include "cases/catalog/gas/gas_case.hpp"
#include "cases/catalog/gas/sod_tube.hpp"
#include "cases/harness/verify/restart_gate.hpp"

namespace plumbline::sod_3d {
namespace {

std::vector<StudyPlan> studies() {
  const std::string why = "Shock and contact are jumps: order 1, in any number of dimensions.";
  const std::vector<double> few{50, 100}, levels{50, 70, 100, 140, 200};
  return {study("default", "default, in space", why, few).in_full(levels),
          study("line", "default, on a line", why, few).with({{"dimension", 1.0}}).in_full(levels),
          study("equal-volume", "default with points of equal volume, in space", why, {50})
              .with({{"points", "equal-volume"}, {"ppc", 3.0}}),
          study("equal-volume-line", "default with points of equal volume, on a line", why, {50})
              .with({{"dimension", 1.0}, {"points", "equal-volume"}, {"ppc", 3.0}})};
}

std::vector<CaseGate> gates() {
  return {same_numbers_gate("default", "line", 50),
          same_numbers_gate("default", "line", 100),
          same_numbers_gate("equal-volume", "equal-volume-line", 50),
          energy_gate("default"),
          coverage_gate("default", 100),
          gate("default/density-order", fitted_order_of("density.L1"), at_least(0.8),
               theory("shock and contact allow 1; 0.8 as of the other shock tubes"))
              .in(Tier::full),
          restart_gate("default", "runs in space")};
}

Case sod_3d() {
  ShockTube tube = sod_tube;
  tube.dimension = 3;
  return {.name = "sod-3d",
          .kind = Kind::gas,
          .keys = TubeParameters(tube).keys(),
          .york1997 = york_points,
          .york_step = york_step,
          .problem = tube_run(tube),
          .studies = studies(),
          .gates = gates(),
          .levels = {50, 70, 100, 140, 200}};
}
PLUMBLINE_CASE(sod_3d);

}  // namespace
}  // namespace plumbline::sod_3d
