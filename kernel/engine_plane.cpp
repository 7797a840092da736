#include "kernel/engine_choice.hpp"

namespace plumbline {

std::unique_ptr<Engine> make_plane_engine(Scene& scene, Ledger& ledger, bool keep_loss) {
  return engine_of<Plane>(scene, ledger, keep_loss);
}

}  // namespace plumbline
