#include "cases/catalog/gas/tube_case.hpp"

#include "cases/catalog/gas/gas_case.hpp"

namespace plumbline {

Case tube_case(const Tube& about) {
  Case made{.name = about.name,
            .kind = Kind::gas,
            .keys = TubeParameters(about.tube).keys(),
            .york1997 = york_points,
            .york_step = york_step,
            .problem = tube_run(about.tube),
            .levels = about.levels,
            .comparators = beside_finite_volumes(about.tube)};
  made.studies = {study("default", "default: points of equal mass",
                        "Shock and contact are jumps: a scheme of any order spreads them over a number of cells, so L1 "
                        "errors fall at most with h.",
                        {100, 140, 200, 280, 400})
                      .in_full(about.levels)};
  made.gates = required_order("default", "density.L1", about.order, about.order_reason);
  made.gates.push_back(energy_gate("default"));
  made.gates.push_back(coverage_gate("default", 100));
  if (about.cold) made.needs = {Trait::returned_loss};
  return made;
}

}  // namespace plumbline
