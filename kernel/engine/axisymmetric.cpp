#include "kernel/engine/choice.hpp"

namespace plumbline {

std::unique_ptr<Engine> make_axisymmetric_engine(Scene& scene, Ledger& ledger, const EngineOptions& options) {
  return engine_of<Axisymmetric>(scene, ledger, options);
}

}  // namespace plumbline
