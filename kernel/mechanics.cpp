#include "kernel/mechanics.hpp"

#include <stdexcept>

#include "kernel/geometry.hpp"

namespace plumbline {

// Defined beside the instantiations, one file a geometry.
template <class Geometry>
std::unique_ptr<Engine> make_engine_of(Scene& scene, Ledger& ledger, const EngineOptions& options);

std::unique_ptr<Engine> make_engine(Scene& scene, Ledger& ledger, const EngineOptions& options) {
  const GridSpec& grid = scene.grid;
  if (grid.axisymmetric && grid.dim != 2) throw std::invalid_argument("an axisymmetric grid has two dimensions");
  switch (grid.dim) {
    case 1:
      return make_engine_of<Line>(scene, ledger, options);
    case 2:
      return grid.axisymmetric ? make_engine_of<Axisymmetric>(scene, ledger, options)
                               : make_engine_of<Plane>(scene, ledger, options);
    case 3:
      return make_engine_of<Solid>(scene, ledger, options);
    default:
      throw std::invalid_argument("a grid has 1 to 3 dimensions, not " + std::to_string(grid.dim));
  }
}

}  // namespace plumbline
