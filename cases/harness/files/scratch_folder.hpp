// A folder for files that nobody else looks at.
#pragma once

#include <filesystem>
#include <string>

namespace plumbline {

// In the system's folder for temporary files, gone with the object. Throws FileError where it cannot be made.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  std::string operator/(const std::string& file) const { return (path_ / file).string(); }

 private:
  std::filesystem::path path_;
};

}  // namespace plumbline
