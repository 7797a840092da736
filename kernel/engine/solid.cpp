#include "kernel/engine/choice.hpp"

namespace plumbline {

std::unique_ptr<Engine> make_solid_engine(Scene& scene, Ledger& ledger, const EngineOptions& options) {
  return engine_of<Solid>(scene, ledger, options);
}

}  // namespace plumbline
