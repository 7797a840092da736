// v_p = sum_i N_ip v~_i
#include "kernel/register_part.hpp"
#include "kernel/transfers/transfer.hpp"

namespace plumbline {
namespace {

const RegisterPart pic_entry(TransferEntry{
    {"pic", "points take the grid's velocity", "Harlow 1964", {Trait::returnable_loss}, {Trait::forward_steps}}, {}});

}  // namespace
}  // namespace plumbline
