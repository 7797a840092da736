#include "kernel/register_part.hpp"
#include "kernel/transfers/transfer.hpp"
#include "tests/parts/wrong_source.hpp"

namespace plumbline::wrong::wrong_unfiltered {
namespace {

const RegisterPart entry(TransferEntry{{"wrong-unfiltered",
                                        "points take the velocity of the grid and say that they keep their own",
                                        here,
                                        {Trait::unfiltered_velocities},
                                        {Trait::forward_steps}},
                                       {}});

}  // namespace
}  // namespace plumbline::wrong::wrong_unfiltered
