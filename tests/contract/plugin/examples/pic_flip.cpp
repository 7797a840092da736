// A transfer outside the repository: points keep 95 % of their own velocity and the grid's change of it, and take the rest.
#include "kernel/register_part.hpp"
#include "kernel/transfers/transfer.hpp"

namespace {

using namespace plumbline;

const RegisterPart entry(TransferEntry{{"pic-flip",
                                        "points keep 0.95 of their velocity and its change, and take the rest",
                                        "Zhu, Bridson 2005, doi 10.1145/1073204.1073298",
                                        {},
                                        {Trait::forward_steps}},
                                       {.keep = 0.95}});

}  // namespace
