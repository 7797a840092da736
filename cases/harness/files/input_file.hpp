// Files to be read that anybody may have written, or put something else in the place of.
#pragma once

#include <cstddef>
#include <istream>
#include <string>

namespace plumbline {

// Bytes of a text at most: a plan of as many runs as are allowed takes a tenth.
inline constexpr std::size_t largest_text = std::size_t{1} << 28;

// Whether the path leads to anything. Links that lead nowhere or in a circle do not, and are no error.
bool is_there(const std::string& path);

// Throws FileError unless the path leads to a regular file. A folder has no content, a device no end, and a pipe that nobody
// writes to would be waited for.
void require_regular_file(const std::string& path);

// The bytes of a regular file. Throws FileError, also where there are more than `largest_text`.
std::string read_text_file(const std::string& path);

// What is left of a stream, under the same limit; `name`: for the error.
std::string read_text(std::istream& in, const std::string& name);

}  // namespace plumbline
