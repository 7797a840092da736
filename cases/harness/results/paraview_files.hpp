// Frames as files that ParaView and VTK open: one a frame, and a list of them with their times.
#pragma once

#include <string>

#include "cases/harness/run/frames.hpp"

namespace plumbline {

// Writes `folder`/`name`-0000.hdf and so on, each a group /VTKHDF of version 1.0 that holds an UnstructuredGrid
// (docs.vtk.org, "VTKHDF format specification"), and `folder`/`name`.hdf.series, the list to open, with the times in s.
// Later versions of the format put all steps in one file, but ParaView up to 5.11 reads those as one step, without a word.
//
// Points: single precision, m, three components, unused ones 0. Cells: a vertex for each point, a polyline for each
// chain. Point data `id`, `body` (its place in set.bodies), `velocity`, `pressure`, `stress` as in Frame; what a body does
// not have is NaN. Makes the folder. The list goes first and comes last, so that one that is there tells of whole files;
// frames of an earlier and longer list of this name are removed. Returns the path of the list; writes nothing and returns
// "" for a set without frames. Throws FileError.
std::string write_paraview_files(const std::string& folder, const std::string& name, const FrameSet& set);

}  // namespace plumbline
