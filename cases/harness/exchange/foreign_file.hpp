// Reads files that other programs wrote: nothing of them is taken on trust. Throws FileError.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace plumbline {

class ForeignFile {
 public:
  explicit ForeignFile(std::string path);
  ~ForeignFile();
  ForeignFile(const ForeignFile&) = delete;
  ForeignFile& operator=(const ForeignFile&) = delete;

  const std::string& path() const;
  bool has(const std::string& object) const;
  // Names of what a group holds, in the order of their names; empty if there is no such group.
  std::vector<std::string> members(const std::string& group) const;

  // Attributes of `/`; nothing where there is none, FileError where it is of another kind. Text of fixed or variable
  // length; numbers of any type.
  std::optional<std::string> text_attribute(const std::string& name) const;
  std::optional<double> number_attribute(const std::string& name) const;

  // A dataset of numbers of any type as doubles, row after row: one or two dimensions, at most 2^27 values.
  struct Table {
    std::vector<std::size_t> shape;
    std::vector<double> values;
  };
  Table numbers(const std::string& dataset) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace plumbline
