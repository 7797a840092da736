// v_p = sum_i N_ip v~_i, C_p = D^-1 sum_i N_ip v~_i (x_i - x_p)^T [EC-APIC 5]
#include "kernel/register_part.hpp"
#include "kernel/transfers/transfer.hpp"

namespace plumbline {
namespace {

const RegisterPart apic_entry(TransferEntry{{"apic",
                                             "points take the grid's velocity and its affine part",
                                             "Jiang et al. 2015, doi 10.1145/2766996",
                                             {Trait::returnable_loss},
                                             {Trait::forward_steps}},
                                            {.affine = true}});

}  // namespace
}  // namespace plumbline
