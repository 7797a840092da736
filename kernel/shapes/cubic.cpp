#include "kernel/shapes/cubic.hpp"

#include "kernel/engine/loops/shape_entry.hpp"

namespace plumbline {
namespace {

const RegisterPart cubic_entry(shape_entry<Cubic>("cubic", "cubic B-splines on the nodes",
                                                  "Steffen et al. 2008, doi 10.1002/nme.2360"));

}  // namespace
}  // namespace plumbline
