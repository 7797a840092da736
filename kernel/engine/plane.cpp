#include "kernel/engine/choice.hpp"

namespace plumbline {

std::unique_ptr<Engine> make_plane_engine(Scene& scene, Ledger& ledger, const EngineOptions& options) {
  return engine_of<Plane>(scene, ledger, options);
}

}  // namespace plumbline
