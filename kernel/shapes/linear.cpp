#include "kernel/shapes/linear.hpp"

#include "kernel/engine/loops/shape_entry.hpp"

namespace plumbline {
namespace {

const RegisterPart linear_entry(shape_entry<Linear>("linear", "tent functions", "York 1997, A.3.1"));

}  // namespace
}  // namespace plumbline
