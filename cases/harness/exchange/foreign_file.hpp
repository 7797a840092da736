// Reads files that other programs wrote: nothing of them is taken on trust. HDF5 does not come back from some damaged files, so
// a process of its own reads them and answers through a socket. Throws FileError, also where that process dies or is not done in
// time.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace plumbline {

inline constexpr double default_patience = 600;  // s

// A dataset of numbers, row after row.
struct NumberTable {
  std::vector<std::size_t> shape;
  std::vector<double> values;
};

class ForeignFile {
 public:
  // patience: s that an answer may take, > 0.
  explicit ForeignFile(std::string path, double patience = default_patience);
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

  // A dataset of numbers of any type as doubles: one or two dimensions, at most 2^27 values.
  NumberTable numbers(const std::string& dataset) const;

 private:
  class Reading;
  std::unique_ptr<Reading> reading_;
};

}  // namespace plumbline
