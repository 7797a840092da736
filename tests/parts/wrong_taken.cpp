#include "kernel/transfers/transfer.hpp"
#include "tests/parts/wrong_source.hpp"

namespace plumbline::wrong {
namespace {

const RegisterTransfer entry{{{"wrong-taken",
                               "points keep their velocity and say that they take that of the grid",
                               here,
                               {Trait::returnable_loss},
                               {Trait::forward_steps}},
                              {.increments = true}}};

}  // namespace
}  // namespace plumbline::wrong
