// Files that are there whole or not at all.
#pragma once

#include <string>

namespace plumbline {

// Writes `text` under a temporary name beside `path` and renames it when all of it is on disk, so that a process that is
// killed, or a disk that is full, leaves the file that was there before. A path that is no regular file (a pipe, a
// device) is written to as it is. Throws FileError with the system's reason.
void write_text_file(const std::string& path, const std::string& text);

// Before work of which the file is to tell: throws FileError where it could not be written, by what the system says of folders
// and permissions. Writes nothing.
void require_writable(const std::string& path);

// The same as write_text_file for a sealed file. Of those a sweep writes thousands, which need not be on disk when this
// returns (`flush` false): should the power fail before they are, the seal tells. A pipe, whose reader may never come, is
// replaced.
void write_sealed_file(const std::string& path, const std::string& content, bool flush);

// The name under which this process writes `path` until it is whole: `path`.HOST-PROCESS.part.
std::string temporary_name(const std::string& path);

// Removes from a folder the files under such names of this machine's processes that are no more: killed ones could not.
void remove_abandoned(const std::string& folder);

}  // namespace plumbline
