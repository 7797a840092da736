#include "kernel/engine/loops/choice.hpp"

namespace plumbline {

template std::unique_ptr<PointLoops<Plane>> make_point_loops(const Scene&, const TransferChoice&);

}  // namespace plumbline
