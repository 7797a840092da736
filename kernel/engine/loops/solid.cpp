#include "kernel/engine/loops/choice.hpp"

namespace plumbline {

template std::unique_ptr<PointLoops<Solid>> make_point_loops(const Scene&, const TransferChoice&);

}  // namespace plumbline
