// The start of a case, written for other programs.
#pragma once

#include <string>

#include "cases/harness/results/documents.hpp"

namespace plumbline {

// Writes `file` (HDF5) and, beside it, its description: the same name with the ending .json. Each is whole or not there;
// throws FileError. Returns the description.
Json write_initial_state(const Case& entry, const std::string& scheme, const Settings& settings,
                         const std::string& file, const Provenance& provenance);

// Name of the description beside a file: "a/F.h5" -> "a/F.json".
std::string description_beside(const std::string& file);

}  // namespace plumbline
