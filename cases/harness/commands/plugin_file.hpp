// What can be known of a plug-in's file without running anything of it.
#pragma once

#include <string>

namespace plumbline {

// Throws FileError unless the file is a whole shared library for this kind of machine all of whose objects that register integrators
// or other parts have the stamp of this program's kernel (kernel/plugin_stamp.hpp). `path`: with a slash; `file`: as it was given.
void check_plugin_file(const std::string& path, const std::string& file);

}  // namespace plumbline
