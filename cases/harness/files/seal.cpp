#include "cases/harness/files/seal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/crc.hpp>
#include <cinttypes>
#include <cstdio>
#include <fstream>

#include "cases/harness/files/errors.hpp"
#include "cases/harness/files/input_file.hpp"

namespace plumbline {
namespace {

struct Content {
  std::uint64_t bytes = 0;
  std::uint32_t checksum = 0;
};

std::uint32_t checksum_of(std::span<const char> bytes) {
  boost::crc_32_type crc;
  crc.process_bytes(bytes.data(), bytes.size());
  return crc.checksum();
}

// From the stream's place to its end.
Content content_of(std::istream& file) {
  boost::crc_32_type crc;
  Content content;
  std::array<char, 65536> block;
  while (file.read(block.data(), block.size()), file.gcount() > 0) {
    crc.process_bytes(block.data(), static_cast<std::size_t>(file.gcount()));
    content.bytes += static_cast<std::uint64_t>(file.gcount());
  }
  content.checksum = crc.checksum();
  return content;
}

std::string seal_of(const Content& content) {
  return fmt::format("plumbline: {} bytes follow byte {}, CRC-32 {:08x}\n", content.bytes, seal_size, content.checksum);
}

bool is_plain_hdf5(const std::string& start) { return start.compare(0, 8, "\x89HDF\r\n\x1a\n") == 0; }

}  // namespace

void seal(std::span<char> file) {
  const std::span<const char> content = file.subspan(seal_size);
  const std::string line = seal_of({content.size(), checksum_of(content)});
  std::ranges::fill(file.first(seal_size), '\0');
  std::ranges::copy(line, file.begin());
}

void check_seal(const std::string& path) {
  require_regular_file(path);
  std::ifstream file(path, std::ios::binary);
  if (!file) throw FileError(path, path + ": cannot be opened");
  std::string start(seal_size, '\0');
  file.read(start.data(), seal_size);
  if (is_plain_hdf5(start)) return;
  Content sealed;
  if (std::sscanf(start.c_str(), "plumbline: %" SCNu64 " bytes follow byte 512, CRC-32 %" SCNx32, &sealed.bytes,
                  &sealed.checksum) != 2) {
    throw FileError(path, path + ": damaged: neither HDF5 nor a result file of Plumbline");
  }
  const Content found = content_of(file);
  if (found.bytes < sealed.bytes)
    throw FileError(path, fmt::format("{}: damaged: truncated, {} of {} bytes are there", path, found.bytes + seal_size,
                                      sealed.bytes + seal_size));
  if (found.bytes != sealed.bytes || found.checksum != sealed.checksum)
    throw FileError(path, path + ": damaged: its content is not what was written");
}

}  // namespace plumbline
