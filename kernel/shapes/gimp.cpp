#include "kernel/shapes/gimp.hpp"

#include "kernel/engine/loops/shape_entry.hpp"

namespace plumbline {
namespace {

ShapeEntry contiguous() {
  ShapeEntry entry = shape_entry<Gimp>("contiguous-gimp", "tents averaged over boxes that deform with the points",
                                       "Wallstedt, Guilkey 2008, doi 10.1016/j.jcp.2008.07.019");
  entry.boxes_deform = true;
  return entry;
}

const RegisterPart gimp_entry(shape_entry<Gimp>("gimp", "tents averaged over boxes that stay",
                                                "Bardenhagen, Kober 2004, doi 10.3970/cmes.2004.005.477"));
const RegisterPart contiguous_entry(contiguous());

}  // namespace
}  // namespace plumbline
