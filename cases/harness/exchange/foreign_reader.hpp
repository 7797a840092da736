// Reads HDF5 files that anybody may have written, in this process: see ForeignFile.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cases/harness/exchange/foreign_file.hpp"

namespace plumbline {

// Throws FileError for what it does not read.
class ForeignReader {
 public:
  explicit ForeignReader(std::string path);
  ~ForeignReader();
  ForeignReader(const ForeignReader&) = delete;
  ForeignReader& operator=(const ForeignReader&) = delete;

  // As those of ForeignFile.
  bool has(const std::string& object) const;
  std::vector<std::string> members(const std::string& group) const;
  std::optional<std::string> text_attribute(const std::string& name) const;
  std::optional<double> number_attribute(const std::string& name) const;
  NumberTable numbers(const std::string& dataset) const;

 private:
  [[noreturn]] void refuse(const std::string& why) const;

  std::string path_;
  std::int64_t file_ = -1;
};

}  // namespace plumbline
