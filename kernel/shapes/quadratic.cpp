#include "kernel/shapes/quadratic.hpp"

#include "kernel/engine/loops/shape_entry.hpp"

namespace plumbline {
namespace {

const RegisterPart quadratic_entry(shape_entry<Quadratic>(
    "quadratic", "quadratic B-splines on the nodes", "York 1997, A.3.2; Steffen et al. 2008, doi 10.1002/nme.2360"));

}  // namespace
}  // namespace plumbline
