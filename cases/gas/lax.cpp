// Lax's shock tube.
#include "cases/gas/tube_case.hpp"

namespace plumbline {
namespace {

const TubeCase lax{
    {.name = "lax",
     .title = "Lax's shock tube",
     .source = "P. D. Lax, Comm. Pure Appl. Math. 7 (1954) 159, doi 10.1002/cpa.3160070112; states and end time as in "
               "C.-W. Shu, S. Osher, J. Comput. Phys. 83 (1989) 32",
     .claim = "All fields converge at first order to the exact Riemann solution.",
     .physics = "Hot thin gas streams into denser gas at rest: a strong contact, which carries most of the density's "
                "error, behind a right shock, and a left rarefaction.",
     .tube = {{{0.445, 0.698, 3.528}, {0.5, 0, 0.571}, 1.4}, 0, 1, 0.5, 0.16}}};

}  // namespace
}  // namespace plumbline
