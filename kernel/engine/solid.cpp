#include "kernel/engine/mechanics.hpp"

namespace plumbline {

template std::unique_ptr<Engine> make_engine_of<Solid>(Scene&, Ledger&, const EngineOptions&);

}  // namespace plumbline
