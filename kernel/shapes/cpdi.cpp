#include "kernel/shapes/cpdi.hpp"

#include "kernel/engine/loops/corner_to_nodes.hpp"
#include "kernel/engine/loops/corner_to_points.hpp"
#include "kernel/engine/loops/list_entry.hpp"

namespace plumbline {

template class Cpdi<1>;
template class Cpdi<2>;
template class Cpdi<3>;

namespace {

template <class Geometry>
std::unique_ptr<PointLoops<Geometry>> make_corner_loops(const GridSpec& grid, const Transfer& transfer) {
  return std::make_unique<CornerLoops<Geometry>>(
      grid, transfer,
      +[](const Grid<2>& on) -> std::unique_ptr<const ListedShape<2>> { return std::make_unique<Cpdi<2>>(on); });
}

ShapeEntry cpdi() {
  ShapeEntry entry = list_entry<Cpdi>("cpdi", "tents at the corners of domains that deform with the points",
                                      "Sadeghirad, Brannon, Burghardt 2011, doi 10.1002/nme.3110",
                                      {Trait::smooth_gradients});
  std::get<MakeLoops<Plane>>(entry.loops) = make_corner_loops<Plane>;
  std::get<MakeLoops<Axisymmetric>>(entry.loops) = make_corner_loops<Axisymmetric>;
  entry.boxes = entry.domain_gradients = true;
  return entry;
}

const RegisterPart cpdi_entry(cpdi());

}  // namespace
}  // namespace plumbline
