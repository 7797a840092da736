#include "kernel/engine/choice.hpp"

namespace plumbline {

std::unique_ptr<Engine> make_line_engine(Scene& scene, Ledger& ledger, const EngineOptions& options) {
  return engine_of<Line>(scene, ledger, options);
}

}  // namespace plumbline
