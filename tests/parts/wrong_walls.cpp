#include "tests/parts/around_quadratic.hpp"

namespace plumbline::wrong::wrong_walls {
namespace {

template <class Geometry>
class AtWalls final : public AroundQuadratic<Geometry> {
 public:
  using Base = AroundQuadratic<Geometry>;
  AtWalls(const GridSpec& grid, const Transfer& transfer) : Base(grid, transfer), grid_(grid) {}
  MotionSums gather_motion(Body& body, const typename Base::At& at, const Chunk& chunk,
                           const typename Base::Field& field, const typename Base::Motion& motion) const override {
    const MotionSums sums = Base::gather_motion(body, at, chunk, field, motion);
    for (int p = chunk.first; p < chunk.last; ++p) {
      if (!at_wall(body.points, p)) continue;
      for (int d = 0; d < Geometry::dim; ++d) body.points(column::velocity, d)[p] *= 1 - 1e-6;
    }
    return sums;
  }

 private:
  bool at_wall(const Columns& points, int p) const {
    for (int d = 0; d < Geometry::dim; ++d) {
      const auto k = static_cast<std::size_t>(d);
      const double x = (points(column::position, d)[p] - grid_.origin[k]) / grid_.h;
      if (grid_.walls[k][0] != Wall::free && x < 0.5) return true;
      if (grid_.walls[k][1] != Wall::free && x > grid_.cells[k] - 0.5) return true;
    }
    return false;
  }

  GridSpec grid_;
};
const RegisterPart entry(shape_around<AtWalls>(
    "wrong-walls", "points within half a cell of a wall lose a millionth of the velocity that they take"));

}  // namespace
}  // namespace plumbline::wrong::wrong_walls
