// LeBlanc's shock tube: a thousand to one in density, a thousand million to one in pressure.
#include "cases/gas/tube_case.hpp"

namespace plumbline {
namespace {

const TubeCase leblanc{
    {.name = "leblanc",
     .title = "LeBlanc's shock tube",
     .source = "D. J. Benson, Comput. Methods Appl. Mech. Eng. 99 (1992) 235, doi 10.1016/0045-7825(92)90042-I; R. "
               "Loubère, M. J. Shashkov, J. Comput. Phys. 209 (2005) 105, doi 10.1016/j.jcp.2005.03.019",
     .claim = "The shock runs at its exact speed in the limit, with the same choices as every other gas case.",
     .physics =
         "Energies of 0.1 and 1e-7 J/kg, γ = 5/3. A rarefaction over three orders of density ends in a contact, a "
         "shock "
         "of nearly infinite strength runs ahead of it. What internal energy a scheme gives the layer between contact "
         "and shock decides where the shock stands: it is commonly too far ahead on coarse meshes.",
     .near_vacuum =
         "The thin gas has a thousandth of the density. Points of the dense gas's mass would stand 125 cells apart in "
         "it at 8 a cell; it has one a cell instead, lighter by that factor, so that no cell is without gas. In the "
         "rarefaction the dense gas expands nineteenfold, and points that outgrow a cell are split.",
     .tube = {{{1, 0, 0.2 / 3}, {1e-3, 0, 2e-10 / 3}, 5.0 / 3}, 0, 9, 3, 6},
     .order = 0.5,
     .cold = true,
     .order_reason = "1 in the limit; the shock's place converges late, because the layer that drives it is a few "
                     "hundredths of the tube"}};

}  // namespace
}  // namespace plumbline
