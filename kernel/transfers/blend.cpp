// v_p <- alpha (v_p + sum_i N_ip dv_i) + (1 - alpha) sum_i N_ip v~_i with alpha = 0.95 [Blend 1]. Of what FLIP keeps and PIC does
// not, a step takes a twentieth: the more steps, the more is taken.
#include "kernel/register_part.hpp"
#include "kernel/transfers/transfer.hpp"

namespace plumbline {
namespace {

const RegisterPart blend_entry(TransferEntry{{"blend",
                                              "0.95 of what flip gives points and 0.05 of what pic does",
                                              "Stomakhin et al. 2013, doi 10.1145/2461912.2461948",
                                              {},
                                              {Trait::forward_steps}},
                                             {.keep = 0.95}});

}  // namespace
}  // namespace plumbline
