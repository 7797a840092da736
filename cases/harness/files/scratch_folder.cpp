#include "cases/harness/files/scratch_folder.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <system_error>

#include "cases/harness/files/errors.hpp"

namespace plumbline {

ScratchFolder::ScratchFolder() {
  static std::atomic<int> count = 0;
  std::error_code none;
  const auto folder = std::filesystem::temp_directory_path(none);
  if (none) throw FileError("TMPDIR", "there is no folder for temporary files: " + none.message());
  path_ = folder / fmt::format("plumbline-{}-{}", ::getpid(), count++);
  std::filesystem::create_directory(path_, none);
  if (none) throw FileError(path_.string(), path_.string() + ": cannot be made: " + none.message());
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace plumbline
