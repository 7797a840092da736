// v_p = sum_i N_ip w_i, w = sum_{j < m} (1 - P)^j v~                                          [FMPM 1]
// P: from the nodes to the points and back. For m = 1 it is pic.
#include "kernel/register_part.hpp"
#include "kernel/transfers/transfer.hpp"

namespace plumbline {
namespace {

const RegisterPart fmpm_entry(TransferEntry{
    {"fmpm",
     "points take the grid's velocity through m terms of the full mass matrix's inverse",
     "Nairn, Hammerquist 2021, doi 10.1016/j.cma.2021.113667",
     {},
     {Trait::forward_steps}},
    {.filters_end = true},
    true});

}  // namespace
}  // namespace plumbline
