// Toro's five tests of Riemann solvers. [Toro table 4.1, section 10.8]
#include "cases/gas/tube_case.hpp"

namespace plumbline {
namespace {

constexpr const char* toro =
    "E. F. Toro, Riemann Solvers and Numerical Methods for Fluid Dynamics, 3rd ed., sections 4.3.3 and 6.4";

constexpr const char* converges =
    "All fields converge at first order to the exact Riemann solution, with the same choices as every other gas case.";

const TubeCase toro_1{
    {.name = "toro-1",
     .title = "Toro's test 1: Sod's tube with a sonic rarefaction",
     .source = toro,
     .claim = converges,
     .physics = "Sod's states, the dense gas moving right at 0.75: a right shock, a contact, and a left "
                "rarefaction in which the flow passes the speed of sound.",
     .tube = {{{1, 0.75, 1}, {0.125, 0, 0.1}, 1.4}, 0, 1, 0.3, 0.2}}};

const TubeCase toro_2{
    {.name = "toro-2",
     .title = "Toro's test 2: two rarefactions that leave hardly any gas",
     .source = toro,
     .claim = "The density's error falls with refinement although the gas in the middle is near vacuum.",
     .physics = "Gas parts at 2 to either side. Two rarefactions leave a pressure of 0.00189 between them.",
     .near_vacuum =
         "In the middle the density falls to 0.0219, a forty-sixth of the initial one. Points that outgrow a cell are "
         "split there: without it they would stand several cells apart, and a cell without points has no gas. The "
         "internal energy p/(ρ(γ − 1)) is the ratio of two small numbers; its error falls slowest, as with every "
         "scheme.",
     .tube = {{{1, -2, 0.4}, {1, 2, 0.4}, 1.4}, 0, 1, 0.5, 0.15},
     .order = 0.5,
     .order_reason = "rarefactions allow 1; where they part in the middle gas is near vacuum, its entropy is set in "
                     "the first steps "
                     "from a few points, and half an order is what the plan asks"}};

const TubeCase toro_3{
    {.name = "toro-3",
     .title = "Toro's test 3: left half of the Woodward and Colella blast",
     .source = toro,
     .claim = converges,
     .physics = "A pressure ratio of 100 000 drives a shock of Mach 198 into gas at rest; between it and "
                "the contact stands a layer of dense gas a tenth of the tube wide at the end.",
     .tube = {{{1, 0, 1000}, {1, 0, 0.01}, 1.4}, 0, 1, 0.5, 0.012}}};

const TubeCase toro_4{
    {.name = "toro-4",
     .title = "Toro's test 4: three waves that run right",
     .source = toro,
     .claim = converges,
     .physics = "Two strong streams collide: two shocks and a contact, the left shock slow. What a scheme "
                "does at a shock that hardly moves shows behind it.",
     .tube = {{{5.99924, 19.5975, 460.894}, {5.99242, -6.19633, 46.0950}, 1.4}, 0, 1, 0.4, 0.035}}};

const TubeCase toro_5{
    {.name = "toro-5",
     .title = "Toro's test 5: a strong shock and a contact at rest",
     .source = toro,
     .claim = converges,
     .physics = "Test 3 seen from a frame that moves with its contact: rarefaction and shock run apart "
                "through gas that streams left, the contact stands.",
     .tube = {{{1, -19.59745, 1000}, {1, -19.59745, 0.01}, 1.4}, 0, 1, 0.8, 0.012}}};

}  // namespace
}  // namespace plumbline
