#include "kernel/register_part.hpp"
#include "kernel/transfers/transfer.hpp"
#include "tests/parts/wrong_source.hpp"

namespace plumbline::wrong::wrong_taken {
namespace {

const RegisterPart entry(TransferEntry{{"wrong-taken",
                                        "points keep their velocity and say that they take that of the grid",
                                        here,
                                        {Trait::returnable_loss},
                                        {Trait::forward_steps}},
                                       {.keep = 1}});

}  // namespace
}  // namespace plumbline::wrong::wrong_taken
