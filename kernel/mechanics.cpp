#include "kernel/mechanics.hpp"

#include <stdexcept>

namespace plumbline {

// Defined beside the instantiations, one file a geometry.
std::unique_ptr<Engine> make_line_engine(Scene& scene, Ledger& ledger, bool keep_loss);
std::unique_ptr<Engine> make_plane_engine(Scene& scene, Ledger& ledger, bool keep_loss);

std::unique_ptr<Engine> make_engine(Scene& scene, Ledger& ledger, bool keep_loss) {
  auto engine = scene.grid.dim == 1   ? make_line_engine(scene, ledger, keep_loss)
                : scene.grid.dim == 2 ? make_plane_engine(scene, ledger, keep_loss)
                                      : nullptr;
  if (!engine) {
    throw std::invalid_argument("no engine for dimension " + std::to_string(scene.grid.dim) + ", shape " + scene.shape +
                                " and transfer " + scene.transfer);
  }
  return engine;
}

}  // namespace plumbline
