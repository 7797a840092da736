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
        "the density falls thirteenfold at the contact, and thin gas within a cell of it reads a mean with the dense "
        "gas: nine tenths of a cell are missing there, with four points a cell in the thin gas as with one",
        {0.987, 0.99}, "2026-11-25 dbede7c");
  }
  return made;
}
PLUMBLINE_CASE(leblanc);

}  // namespace
}  // namespace plumbline::leblanc
