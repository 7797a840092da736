// Tells whether a result file is what was written, before HDF5 looks at it: HDF5 runs in circles in some damaged files, dies
// of others, and gives wrong numbers from most.
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace plumbline {

// The length of a seal, bytes. It is the file's user block, which HDF5 and all that reads HDF5 pass over.
inline constexpr std::size_t seal_size = 512;

// Writes the seal into the first `seal_size` bytes of a file that is whole but for it: a line that says how many bytes follow
// and their checksum (CRC-32 as in zlib), then zeros. The rest, which is HDF5, stays as it is.
void seal(std::span<char> file);

// Throws FileError, which says what is wrong, if the file is not what was sealed. HDF5 files without a seal pass: those of
// other programs and of earlier versions.
void check_seal(const std::string& path);

}  // namespace plumbline
