#include "kernel/engine/mechanics.hpp"

namespace plumbline {

template std::unique_ptr<Engine> make_engine_of<Axisymmetric>(Scene&, Ledger&, const EngineOptions&);

}  // namespace plumbline
