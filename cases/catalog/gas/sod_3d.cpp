// Sod's shock tube in space.
#include "cases/catalog/gas/gas_case.hpp"
#include "cases/catalog/gas/sod_tube.hpp"
#include "cases/harness/verify/restart_gate.hpp"

namespace plumbline::sod_3d {
namespace {

std::vector<StudyPlan> studies() {
  const std::string why = "Shock and contact are jumps: order 1, in any number of dimensions.";
  const std::vector<double> few{50, 100}, levels{50, 70, 100, 140, 200};
  const std::string alike = why + " What corrects sums over points is none on a line: left away, the two are one.";
  return {study("default", "default, in space", why, few).in_full(levels),
          study("uncorrected", "default with sums over points as they are, in space", alike, few)
              .with({{"quadrature", 0.0}}),
          study("line", "default, on a line", why, few).with({{"dimension", 1.0}}).in_full(levels),
          study("equal-volume", "default with points of equal volume and sums as they are, in space", alike, {50})
              .with({{"points", "equal-volume"}, {"ppc", 3.0}, {"quadrature", 0.0}}),
          study("equal-volume-line", "default with points of equal volume, on a line", why, {50})
              .with({{"dimension", 1.0}, {"points", "equal-volume"}, {"ppc", 3.0}})};
}

std::vector<CaseGate> gates() {
  const Because as_good = requirement(
      "what corrects sums over points is there for flows that shear; a tube, which does not, "
      "may not lose a twentieth of its accuracy");
  return {same_numbers_gate("uncorrected", "line", 50),
          same_numbers_gate("uncorrected", "line", 100),
          gate("default/density-as-uncorrected", error_over("density.L1", "uncorrected", "sums as they are", 100),
               at_most(1.05), as_good),
          gate("default/velocity-as-uncorrected", error_over("velocity.L1", "uncorrected", "sums as they are", 100),
               at_most(1.05), as_good),
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
