#include "tests/parts/around_quadratic.hpp"

namespace plumbline::wrong::wrong_sides {
namespace {

template <class Geometry>
struct Sides final : AroundQuadratic<Geometry> {
  using Base = AroundQuadratic<Geometry>;
  using Base::Base;
  bool find_lowest(const Columns& points, PointRange range, int* lowest) const override {
    Base::find_lowest(points, range, lowest);
    return true;
  }
};
const RegisterPart entry(shape_around<Sides>("wrong-sides",
                                             "quadratic B-splines that take points beyond a side to be on the grid"));

}  // namespace
}  // namespace plumbline::wrong::wrong_sides
