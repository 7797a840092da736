// Frames in a result file: /VTKHDF as ParaView reads it, /frames for what that format has no place for.
#pragma once

#include "cases/harness/frames.hpp"
#include "cases/harness/hdf5_file.hpp"

namespace plumbline {

// /VTKHDF: an UnstructuredGrid over time, version 2.0 of the format (docs.vtk.org, "VTKHDF format specification"): each
// point a vertex, each chain one polyline; single precision, compressed. Point data `id`, `body` (its place in the list of
// /frames), `velocity`, `pressure`, `stress`; what a body does not have is NaN. /frames: JSON with the bodies, the grid and
// the units. Nothing is written of a set without frames.
void write_frames(Hdf5Writer& file, const FrameSet& set);

}  // namespace plumbline
