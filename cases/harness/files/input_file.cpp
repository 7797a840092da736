#include "cases/harness/files/input_file.hpp"

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <fstream>

#include "cases/harness/files/errors.hpp"

namespace plumbline {

bool is_there(const std::string& path) {
  std::error_code none;
  return std::filesystem::exists(path, none);
}

void require_regular_file(const std::string& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) {
    const std::string why = error ? error.message() : "no such file";
    throw FileError(path, fmt::format("{}: cannot be opened: {}", path, why));
  }
  if (!std::filesystem::is_regular_file(status))
    throw FileError(path,
                    fmt::format("{}: cannot be read: {}", path,
                                std::filesystem::is_directory(status) ? "a folder" : "a device or a pipe, not a file"));
}

std::string read_text(std::istream& in, const std::string& name) {
  std::string text;
  std::array<char, 65536> block;
  while (in.read(block.data(), block.size()), in.gcount() > 0) {
    text.append(block.data(), static_cast<std::size_t>(in.gcount()));
    if (text.size() > largest_text)
      throw FileError(name, fmt::format("{}: more than {} bytes: not what is read here", name, largest_text));
  }
  if (in.bad()) throw FileError(name, name + ": cannot be read");
  return text;
}

std::string read_text_file(const std::string& path) {
  require_regular_file(path);
  std::ifstream in(path, std::ios::binary);
  if (!in) throw FileError(path, path + ": cannot be opened");
  return read_text(in, path);
}

}  // namespace plumbline
