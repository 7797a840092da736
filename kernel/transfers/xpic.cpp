// v_p = sum_i N_ip (w_i + dt a_i), w = sum_{j < m} (1 - P)^j v                                [XPIC 1]
// P: from the nodes to the points and back. For m = 1 it is pic, for large m it keeps what flip keeps but null-space modes of P.
#include "kernel/register_part.hpp"
#include "kernel/transfers/transfer.hpp"

namespace plumbline {
namespace {

const RegisterPart xpic_entry(TransferEntry{
    {"xpic",
     "points take the grid's acceleration and lose only what m passes to the grid and back do not restore",
     "Hammerquist, Nairn 2017, doi 10.1016/j.cma.2017.01.035",
     {},
     {Trait::forward_steps}},
    {},
    true});

}  // namespace
}  // namespace plumbline
