// v_p += dt sum_i N_ip a_i [York 3.22]
#include "kernel/register_part.hpp"
#include "kernel/transfers/transfer.hpp"

namespace plumbline {
namespace {

const RegisterPart flip_entry(TransferEntry{
    {"flip",
     "points take the grid's velocity change",
     "York 1997, (3.22); Brackbill, Ruppel 1986, doi 10.1016/0021-9991(86)90211-1",
     {Trait::unfiltered_velocities}},
    {.keep = 1}});

}  // namespace
}  // namespace plumbline
