// Toro's five tests of Riemann solvers. [Toro table 4.1, section 10.8]
#include "cases/catalog/gas/tube_case.hpp"

namespace plumbline::toro {
namespace {

std::vector<Case> toro() {
  return {tube_case({.name = "toro-1", .tube = {{{1, 0.75, 1}, {0.125, 0, 0.1}, 1.4}, 0, 1, 0.3, 0.2}}),
          tube_case(
              {.name = "toro-2",
               .tube = {{{1, -2, 0.4}, {1, 2, 0.4}, 1.4}, 0, 1, 0.5, 0.15},
               .order = 0.5,
               // Errors of the coarsest meshes scatter by points more or less in the middle: six levels for the fit.
               .levels = {100, 200, 400, 800, 1600, 3200},
               .order_reason = "rarefactions allow 1; where they part in the middle gas is near vacuum, its entropy is "
                               "set in the first steps from a few points, and half an order is what can be relied on"}),
          tube_case({.name = "toro-3", .tube = {{{1, 0, 1000}, {1, 0, 0.01}, 1.4}, 0, 1, 0.5, 0.012}}),
          tube_case({.name = "toro-4",
                     .tube = {{{5.99924, 19.5975, 460.894}, {5.99242, -6.19633, 46.0950}, 1.4}, 0, 1, 0.4, 0.035}}),
          tube_case({.name = "toro-5", .tube = {{{1, -19.59745, 1000}, {1, -19.59745, 0.01}, 1.4}, 0, 1, 0.8, 0.012}})};
}
PLUMBLINE_CASE(toro);

}  // namespace
}  // namespace plumbline::toro
