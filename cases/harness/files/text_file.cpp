#include "cases/harness/files/text_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <system_error>

#include "cases/harness/files/errors.hpp"
#include "cases/harness/files/signals.hpp"

namespace plumbline {
namespace {

[[noreturn]] void fail(const std::string& path, int error) {
  throw FileError(path, fmt::format("{}: cannot be written: {}", path, std::generic_category().message(error)));
}

// All of the text to an open file; the error number, 0 if there is none.
int write_all(int file, const std::string& text) {
  for (std::size_t done = 0; done < text.size();) {
    const ::ssize_t count = ::write(file, text.data() + done, text.size() - done);
    if (count < 0 && errno != EINTR) return errno;
    if (count > 0) done += static_cast<std::size_t>(count);
  }
  return 0;
}

// `flush`: to the disk, where a failing one is noticed at the latest.
int write_new(const std::string& path, const std::string& text, int flags, bool flush) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CLOEXEC | flags, 0666);
  if (file < 0) return errno;
  int error = write_all(file, text);
  if (error == 0 && flush && ::fsync(file) != 0) error = errno;
  if (::close(file) != 0 && error == 0) error = errno;  // where a network's disk tells that it is full
  return error;
}

void write_whole(const std::string& path, const std::string& content, bool flush, bool replaces_pipes) {
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  const bool replaced = std::filesystem::is_regular_file(status) ||
                        (replaces_pipes && status.type() == std::filesystem::file_type::fifo);
  if (std::filesystem::exists(status) && !replaced) {
    if (const int error = write_new(path, content, 0, false); error != 0) fail(path, error);
    return;
  }
  const std::string temporary = temporary_name(path);
  being_written(temporary.c_str());
  int error = write_new(temporary, content, O_CREAT | O_TRUNC, flush);
  if (error == 0 && ::rename(temporary.c_str(), path.c_str()) != 0) error = errno;
  being_written("");
  if (error == 0) return;
  std::filesystem::remove(temporary, ignored);
  fail(path, error);
}

std::string host() {
  std::array<char, 256> name{};
  if (::gethostname(name.data(), name.size() - 1) != 0) name = {'h'};
  return name.data();
}

}  // namespace

void require_writable(const std::string& path) {
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  if (std::filesystem::is_directory(status)) fail(path, EISDIR);
  const bool as_it_is = std::filesystem::exists(status) && !std::filesystem::is_regular_file(status);
  const std::string folder = std::filesystem::path(path).parent_path();
  const std::string written = as_it_is ? path : folder.empty() ? "." : folder;
  if (::access(written.c_str(), W_OK) != 0) fail(path, errno);
}

std::string temporary_name(const std::string& path) { return fmt::format("{}.{}-{}.part", path, host(), ::getpid()); }

void remove_abandoned(const std::string& folder) {
  const std::string mark = "." + host() + "-";
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
    const std::string name = entry.path().filename();
    const std::size_t at = name.rfind(mark);
    if (entry.path().extension() != ".part" || at == std::string::npos) continue;
    const long process = std::strtol(name.c_str() + at + mark.size(), nullptr, 10);
    const bool gone = process > 0 && ::kill(static_cast<pid_t>(process), 0) != 0 && errno == ESRCH;
    if (gone) std::filesystem::remove(entry.path(), ignored);
  }
}

void write_text_file(const std::string& path, const std::string& text) { write_whole(path, text, true, false); }

void write_sealed_file(const std::string& path, const std::string& content, bool flush) {
  write_whole(path, content, flush, true);
}

}  // namespace plumbline
