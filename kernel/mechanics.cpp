#include "kernel/mechanics.hpp"

#include <stdexcept>

namespace plumbline {

// Defined beside the instantiations, one file a geometry.
std::unique_ptr<Engine> make_line_engine(Scene& scene, Ledger& ledger, const EngineOptions& options);
std::unique_ptr<Engine> make_plane_engine(Scene& scene, Ledger& ledger, const EngineOptions& options);
std::unique_ptr<Engine> make_axisymmetric_engine(Scene& scene, Ledger& ledger, const EngineOptions& options);
std::unique_ptr<Engine> make_solid_engine(Scene& scene, Ledger& ledger, const EngineOptions& options);

std::unique_ptr<Engine> make_engine(Scene& scene, Ledger& ledger, const EngineOptions& options) {
  const GridSpec& grid = scene.grid;
  if (grid.axisymmetric && grid.dim != 2) throw std::invalid_argument("an axisymmetric grid has two dimensions");
  std::unique_ptr<Engine> engine;
  if (grid.dim == 1) engine = make_line_engine(scene, ledger, options);
  if (grid.dim == 2 && !grid.axisymmetric) engine = make_plane_engine(scene, ledger, options);
  if (grid.dim == 2 && grid.axisymmetric) engine = make_axisymmetric_engine(scene, ledger, options);
  if (grid.dim == 3) engine = make_solid_engine(scene, ledger, options);
  if (!engine) {
    throw std::invalid_argument("no engine for dimension " + std::to_string(grid.dim) + ", shape " + scene.shape +
                                " and transfer " + scene.transfer);
  }
  return engine;
}

}  // namespace plumbline
