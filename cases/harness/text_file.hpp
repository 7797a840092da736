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

// The same for a sealed file, of which a sweep writes thousands: it need not be on disk when this returns. Should the power
// fail before it is, its seal tells.
void write_sealed_file(const std::string& path, const std::string& content);

// The name under which this process writes `path` until it is whole: `path`.HOST-PROCESS.part.
std::string temporary_name(const std::string& path);

// Removes from a folder the files under such names of this machine's processes that are no more: killed ones could not.
void remove_abandoned(const std::string& folder);

}  // namespace plumbline
