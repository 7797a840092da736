// Frames in a result file, as the report reads them.
#pragma once

#include "cases/harness/files/hdf5_file.hpp"
#include "cases/harness/run/frames.hpp"

namespace plumbline {

// /frames: `time` (s) and `start`, the place of each frame's first point and the end, in the columns `position` and
// `velocity` (rows of three), `pressure`, `stress`, `id` and `body` (its place in the list of `description`), which hold
// all frames one after another; single precision, compressed; what a body does not have is NaN. `description`: JSON with
// the bodies, the grid and the units. Nothing is written of a set without frames. No group VTKHDF: readers of ParaView up
// to 5.11 would take all frames for one (paraview_files.hpp writes what they read).
void write_frames(Hdf5Writer& file, const FrameSet& set);

}  // namespace plumbline
