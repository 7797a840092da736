#include "cases/harness/files/hdf5_file.hpp"

#include <fmt/format.h>
#include <hdf5.h>

#include <algorithm>

#include "cases/harness/files/errors.hpp"
#include "cases/harness/files/hdf5_handle.hpp"
#include "cases/harness/files/seal.hpp"
#include "cases/harness/files/text_file.hpp"

namespace plumbline {
namespace {

// Types of a number in a file and in memory.
template <class Number>
struct Type;
template <>
struct Type<double> {
  static hid_t stored() { return H5T_IEEE_F64LE; }
  static hid_t in_memory() { return H5T_NATIVE_DOUBLE; }
};
template <>
struct Type<float> {
  static hid_t stored() { return H5T_IEEE_F32LE; }
  static hid_t in_memory() { return H5T_NATIVE_FLOAT; }
};
template <>
struct Type<std::int64_t> {
  static hid_t stored() { return H5T_STD_I64LE; }
  static hid_t in_memory() { return H5T_NATIVE_INT64; }
};
template <>
struct Type<std::int32_t> {
  static hid_t stored() { return H5T_STD_I32LE; }
  static hid_t in_memory() { return H5T_NATIVE_INT32; }
};
template <>
struct Type<std::uint8_t> {
  static hid_t stored() { return H5T_STD_U8LE; }
  static hid_t in_memory() { return H5T_NATIVE_UINT8; }
};

void silence_hdf5() { H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); }

}  // namespace

struct Hdf5Writer::Impl {
  std::string path;
  hid_t file = -1;

  void require(bool good, const std::string& what) const {
    if (!good) throw FileError(path, fmt::format("{}: cannot write {}", path, what));
  }
};

Hdf5Writer::Hdf5Writer(std::string path) : impl_(std::make_unique<Impl>()) {
  silence_hdf5();
  impl_->path = std::move(path);
  // In memory: HDF5 cannot get over a disk that fills up, and ends in a crash.
  const Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, impl_->path, "make a property list");
  const Hdf5Handle creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose, impl_->path, "make a property list");
  H5Pset_fapl_core(access, 1 << 20, false);
  H5Pset_userblock(creation, seal_size);
  impl_->file = H5Fcreate(impl_->path.c_str(), H5F_ACC_TRUNC, creation, access);
  if (impl_->file < 0) throw FileError(impl_->path, fmt::format("{}: cannot be written", impl_->path));
}

Hdf5Writer::~Hdf5Writer() {
  if (impl_->file >= 0) H5Fclose(impl_->file);
}

void Hdf5Writer::attribute(const std::string& object, const std::string& name, const std::string& text) {
  const Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose, impl_->path, "make a string type");
  H5Tset_size(type, text.size() + 1);
  H5Tset_cset(type, H5T_CSET_UTF8);
  const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose, impl_->path, "make a space");
  const Hdf5Handle attribute(
      H5Acreate_by_name(impl_->file, object.c_str(), name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
      H5Aclose, impl_->path, "write attribute " + name);
  impl_->require(H5Awrite(attribute, type, text.c_str()) >= 0, name);
}

void Hdf5Writer::attribute(const std::string& object, const std::string& name, std::int64_t number) {
  const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose, impl_->path, "make a space");
  const Hdf5Handle attribute(H5Acreate_by_name(impl_->file, object.c_str(), name.c_str(), H5T_STD_I64LE, space,
                                               H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                             H5Aclose, impl_->path, "write attribute " + name);
  impl_->require(H5Awrite(attribute, H5T_NATIVE_INT64, &number) >= 0, name);
}

void Hdf5Writer::real_attribute(const std::string& object, const std::string& name, double number) {
  const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose, impl_->path, "make a space");
  const Hdf5Handle attribute(H5Acreate_by_name(impl_->file, object.c_str(), name.c_str(), H5T_IEEE_F64LE, space,
                                               H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                             H5Aclose, impl_->path, "write attribute " + name);
  impl_->require(H5Awrite(attribute, H5T_NATIVE_DOUBLE, &number) >= 0, name);
}

void Hdf5Writer::ascii_attribute(const std::string& object, const std::string& name, const std::string& text) {
  const Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose, impl_->path, "make a string type");
  H5Tset_size(type, text.size());
  H5Tset_strpad(type, H5T_STR_NULLPAD);
  const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose, impl_->path, "make a space");
  const Hdf5Handle attribute(
      H5Acreate_by_name(impl_->file, object.c_str(), name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
      H5Aclose, impl_->path, "write attribute " + name);
  impl_->require(H5Awrite(attribute, type, text.c_str()) >= 0, name);
}

void Hdf5Writer::integers_attribute(const std::string& object, const std::string& name,
                                    const std::vector<std::int64_t>& values) {
  const hsize_t size = values.size();
  const Hdf5Handle space(H5Screate_simple(1, &size, nullptr), H5Sclose, impl_->path, "make a space");
  const Hdf5Handle attribute(H5Acreate_by_name(impl_->file, object.c_str(), name.c_str(), H5T_STD_I64LE, space,
                                               H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                             H5Aclose, impl_->path, "write attribute " + name);
  impl_->require(H5Awrite(attribute, H5T_NATIVE_INT64, values.data()) >= 0, name);
}

void Hdf5Writer::group(const std::string& path) {
  const Hdf5Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose, impl_->path, "make a property list");
  H5Pset_create_intermediate_group(links, 1);
  const Hdf5Handle group(H5Gcreate2(impl_->file, path.c_str(), links, H5P_DEFAULT, H5P_DEFAULT), H5Gclose, impl_->path,
                         "write group " + path);
}

void Hdf5Writer::text(const std::string& path, const std::string& text) {
  const Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose, impl_->path, "make a string type");
  H5Tset_size(type, text.size() + 1);
  H5Tset_cset(type, H5T_CSET_UTF8);
  const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose, impl_->path, "make a space");
  const Hdf5Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, impl_->path, "make a property list");
  H5Pset_obj_track_times(creation, false);  // the same content gives the same bytes
  const Hdf5Handle data(H5Dcreate2(impl_->file, path.c_str(), type, space, H5P_DEFAULT, creation, H5P_DEFAULT),
                        H5Dclose, impl_->path, "write " + path);
  impl_->require(H5Dwrite(data, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.c_str()) >= 0, path);
}

void Hdf5Writer::numbers(const std::string& path, std::span<const double> values) {
  const hsize_t size = values.size();
  const Hdf5Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose, impl_->path, "make a property list");
  H5Pset_create_intermediate_group(links, 1);
  const Hdf5Handle space(H5Screate_simple(1, &size, nullptr), H5Sclose, impl_->path, "make a space");
  const Hdf5Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, impl_->path, "make a property list");
  H5Pset_obj_track_times(creation, false);
  const Hdf5Handle data(H5Dcreate2(impl_->file, path.c_str(), H5T_IEEE_F64LE, space, links, creation, H5P_DEFAULT),
                        H5Dclose, impl_->path, "write " + path);
  if (size > 0) {
    impl_->require(H5Dwrite(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) >= 0, path);
  }
}

template <class Number>
void Hdf5Writer::array(const std::string& path, std::span<const Number> values, std::size_t columns) {
  const hsize_t width = columns == 0 ? 1 : columns, size[] = {values.size() / width, width};
  const int rank = columns == 0 ? 1 : 2;
  const Hdf5Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose, impl_->path, "make a property list");
  H5Pset_create_intermediate_group(links, 1);
  const Hdf5Handle space(H5Screate_simple(rank, size, nullptr), H5Sclose, impl_->path, "make a space");
  const Hdf5Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, impl_->path, "make a property list");
  H5Pset_obj_track_times(creation, false);
  if (values.size() > 64) {  // below, a chunk's own bytes outweigh what compression saves
    const hsize_t chunk[] = {std::min<hsize_t>(size[0], 16384), width};
    H5Pset_chunk(creation, rank, chunk);
    H5Pset_shuffle(creation);
    H5Pset_deflate(creation, 6);
  }
  const Hdf5Handle data(
      H5Dcreate2(impl_->file, path.c_str(), Type<Number>::stored(), space, links, creation, H5P_DEFAULT), H5Dclose,
      impl_->path, "write " + path);
  if (values.empty()) return;
  impl_->require(H5Dwrite(data, Type<Number>::in_memory(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) >= 0, path);
}
template void Hdf5Writer::array(const std::string&, std::span<const double>, std::size_t);
template void Hdf5Writer::array(const std::string&, std::span<const float>, std::size_t);
template void Hdf5Writer::array(const std::string&, std::span<const std::int64_t>, std::size_t);
template void Hdf5Writer::array(const std::string&, std::span<const std::int32_t>, std::size_t);
template void Hdf5Writer::array(const std::string&, std::span<const std::uint8_t>, std::size_t);

void Hdf5Writer::commit(Flush flush) {
  impl_->require(H5Fflush(impl_->file, H5F_SCOPE_LOCAL) >= 0, "its end");
  const ::ssize_t size = H5Fget_file_image(impl_->file, nullptr, 0);  // without the user block
  impl_->require(size > 0, "its end");
  std::string file(seal_size + static_cast<std::size_t>(size), '\0');
  impl_->require(H5Fget_file_image(impl_->file, file.data() + seal_size, file.size() - seal_size) == size, "its end");
  H5Fclose(impl_->file);
  impl_->file = -1;
  seal(file);
  write_sealed_file(impl_->path, file, flush == Flush::to_disk);
}

namespace {

// A data set that is open, with its own type and number of elements.
struct OpenData {
  OpenData(hid_t handle, const std::string& file, const std::string& path)
      : data(H5Dopen2(handle, path.c_str(), H5P_DEFAULT), H5Dclose, file, "find " + path),
        type(H5Dget_type(data), H5Tclose, file, "read the type of " + path),
        space(H5Dget_space(data), H5Sclose, file, "read the size of " + path) {
    const hssize_t count = H5Sget_simple_extent_npoints(space);
    const double bytes = static_cast<double>(count) * static_cast<double>(H5Tget_size(type));
    if (count < 0 || bytes > most_compressed * static_cast<double>(H5Dget_storage_size(data)))
      throw FileError(file, fmt::format("{}: {} says that it is larger than what is stored of it", file, path));
  }

  static constexpr double most_compressed = 1032;  // what deflate makes of zeros
  Hdf5Handle data, type, space;
};

template <class Number>
std::vector<Number> read_numbers(hid_t handle, const std::string& file, const std::string& path, H5T_class_t wanted,
                                 hid_t in_memory) {
  const OpenData open(handle, file, path);
  const hssize_t count = H5Sget_simple_extent_npoints(open.space);
  if (count < 0 || H5Tget_class(open.type) != wanted) throw FileError(file, file + ": no numbers are " + path);
  std::vector<Number> values(static_cast<std::size_t>(count));
  if (count > 0 && H5Dread(open.data, in_memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0)
    throw FileError(file, file + ": cannot read " + path);
  return values;
}

}  // namespace

Hdf5Reader::Hdf5Reader(std::string path) : path_(std::move(path)) {
  silence_hdf5();
  check_seal(path_);
  file_ = H5Fopen(path_.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  if (file_ < 0) throw FileError(path_, fmt::format("{}: cannot be opened as HDF5", path_));
}

Hdf5Reader::~Hdf5Reader() { H5Fclose(file_); }

bool Hdf5Reader::has(const std::string& path) const { return H5Lexists(file_, path.c_str(), H5P_DEFAULT) > 0; }

std::int64_t Hdf5Reader::attribute(const std::string& object, const std::string& name) const {
  const Hdf5Handle attribute(H5Aopen_by_name(file_, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                             path_, "find attribute " + name);
  const Hdf5Handle space(H5Aget_space(attribute), H5Sclose, path_, "find the shape of attribute " + name);
  // What is read is as long as the file says.
  if (H5Sget_simple_extent_npoints(space) != 1) throw FileError(path_, path_ + ": not one number is " + name);
  std::int64_t number = 0;
  if (H5Aread(attribute, H5T_NATIVE_INT64, &number) < 0) throw FileError(path_, path_ + ": cannot read " + name);
  return number;
}

std::string Hdf5Reader::text(const std::string& path) const {
  const OpenData open(file_, path_, path);
  const bool is_text = H5Tget_class(open.type) == H5T_STRING && H5Sget_simple_extent_npoints(open.space) == 1;
  if (!is_text) throw FileError(path_, path_ + ": no text is " + path);
  if (H5Tis_variable_str(open.type) > 0) {  // as h5py writes text
    char* stored = nullptr;
    if (H5Dread(open.data, open.type, H5S_ALL, H5S_ALL, H5P_DEFAULT, &stored) < 0 || !stored)
      throw FileError(path_, path_ + ": cannot read " + path);
    const std::string text(stored);
    H5free_memory(stored);
    return text;
  }
  std::string text(H5Tget_size(open.type), '\0');
  if (H5Dread(open.data, open.type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()) < 0)
    throw FileError(path_, path_ + ": cannot read " + path);
  text.resize(text.find('\0') == std::string::npos ? text.size() : text.find('\0'));
  return text;
}

std::vector<double> Hdf5Reader::numbers(const std::string& path) const {
  return read_numbers<double>(file_, path_, path, H5T_FLOAT, H5T_NATIVE_DOUBLE);
}

std::vector<std::uint8_t> Hdf5Reader::bytes(const std::string& path) const {
  return read_numbers<std::uint8_t>(file_, path_, path, H5T_INTEGER, H5T_NATIVE_UINT8);
}

std::string read_hdf5_text(const std::string& file, const std::string& path) { return Hdf5Reader(file).text(path); }

std::int64_t read_hdf5_integer(const std::string& file, const std::string& object, const std::string& attribute) {
  return Hdf5Reader(file).attribute(object, attribute);
}

}  // namespace plumbline
