// The little of HDF5 that result files need, with handles that close themselves. Throws FileError.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace plumbline {

// Makes a file in memory. `commit` seals it (seal.hpp) and puts it in its place, whole or not at all; without, there is none.
// While it commits it holds the file twice, compressed as it will stand on the disk.
class Hdf5Writer {
 public:
  explicit Hdf5Writer(std::string path);
  ~Hdf5Writer();
  Hdf5Writer(const Hdf5Writer&) = delete;
  Hdf5Writer& operator=(const Hdf5Writer&) = delete;

  void attribute(const std::string& object, const std::string& name, const std::string& text);
  void attribute(const std::string& object, const std::string& name, std::int64_t number);
  void real_attribute(const std::string& object, const std::string& name, double number);
  // As VTK writes them: a fixed string of ASCII letters without an end mark, and a list of integers.
  void ascii_attribute(const std::string& object, const std::string& name, const std::string& text);
  void integers_attribute(const std::string& object, const std::string& name, const std::vector<std::int64_t>& values);
  void group(const std::string& path);
  void text(const std::string& path, const std::string& text);            // scalar UTF-8 string
  void numbers(const std::string& path, std::span<const double> values);  // 1-D float64, groups made as needed
  // Number: double, float, std::int64_t, std::int32_t or std::uint8_t, stored as such and compressed; groups made as needed. One
  // dimension where `columns` is 0, else rows of as many values.
  template <class Number>
  void array(const std::string& path, std::span<const Number> values, std::size_t columns = 0);
  template <class Number>
  void array(const std::string& path, const std::vector<Number>& values, std::size_t columns = 0) {
    array(path, std::span<const Number>(values), columns);
  }
  // to_disk: the file is on the disk when this returns, should the power fail. Not so: text_file.hpp, write_sealed_file.
  enum class Flush { none, to_disk };
  void commit(Flush flush = Flush::none);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

// Reads a file whose seal holds. Throws FileError, also for a part that is missing or of another type.
class Hdf5Reader {
 public:
  explicit Hdf5Reader(std::string path);
  ~Hdf5Reader();
  Hdf5Reader(const Hdf5Reader&) = delete;
  Hdf5Reader& operator=(const Hdf5Reader&) = delete;

  const std::string& name() const { return path_; }
  bool has(const std::string& path) const;  // whose groups above must be there
  std::int64_t attribute(const std::string& object, const std::string& name) const;
  std::string text(const std::string& path) const;
  std::vector<double> numbers(const std::string& path) const;
  std::vector<std::uint8_t> bytes(const std::string& path) const;

 private:
  std::string path_;
  std::int64_t file_ = -1;
};

// Reads one scalar string of a file, and one scalar integer attribute of one of its objects.
std::string read_hdf5_text(const std::string& file, const std::string& path);
std::int64_t read_hdf5_integer(const std::string& file, const std::string& object, const std::string& attribute);

}  // namespace plumbline
