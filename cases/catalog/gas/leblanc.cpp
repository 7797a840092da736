// LeBlanc's shock tube: a thousand to one in density, a thousand million to one in pressure.
#include "cases/catalog/gas/tube_case.hpp"

namespace plumbline::leblanc {
namespace {

Case leblanc() {
  Case made = tube_case(
      {.name = "leblanc",
       .tube = {{{1, 0, 0.2 / 3}, {1e-3, 0, 2e-10 / 3}, 5.0 / 3}, 0, 9, 3, 6},
       .order = 0.5,
       .cold = true,
       .order_reason = "1 in the limit; the shock's place converges late, because the layer that drives it is a few "
                       "hundredths of the tube"});
  for (CaseGate& gate : made.gates) {
    if (gate.gate.id != "default/coverage-100") continue;
    gate = std::move(gate).fails(
        "the thin gas has a point a cell, and what the filter leaves of their own velocities spaces them unevenly: "
        "0.993 where all of it is taken in each step",
        {0.987, 0.99}, "2026-11-25 dbede7c");
  }
  return made;
}
PLUMBLINE_CASE(leblanc);

}  // namespace
}  // namespace plumbline::leblanc
