#include "cases/harness/exchange/foreign_reader.hpp"

#include <fmt/format.h>
#include <hdf5.h>

#include <algorithm>

#include "cases/harness/files/errors.hpp"
#include "cases/harness/files/hdf5_handle.hpp"
#include "cases/harness/files/input_file.hpp"

namespace plumbline {
namespace {

constexpr hsize_t most_values = hsize_t{1} << 27;
constexpr std::size_t longest_text = 4096;
constexpr double most_compressed = 1032;

bool is_number(hid_t type) {
  const H5T_class_t kind = H5Tget_class(type);
  return kind == H5T_INTEGER || kind == H5T_FLOAT;
}

}  // namespace

ForeignReader::ForeignReader(std::string path) : path_(std::move(path)) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  require_regular_file(path_);
  file_ = H5Fopen(path_.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  if (file_ < 0) refuse("cannot be opened as HDF5");
}

ForeignReader::~ForeignReader() { H5Fclose(file_); }

void ForeignReader::refuse(const std::string& why) const { throw FileError(path_, path_ + ": " + why); }

bool ForeignReader::has(const std::string& object) const {
  // Each step of the way is asked for: H5Lexists fails where a group on the way is missing.
  for (std::size_t end = object.find('/', 1);; end = object.find('/', end + 1)) {
    if (H5Lexists(file_, object.substr(0, end).c_str(), H5P_DEFAULT) <= 0) return false;
    if (end == std::string::npos) return H5Oexists_by_name(file_, object.c_str(), H5P_DEFAULT) > 0;
  }
}

std::vector<std::string> ForeignReader::members(const std::string& group) const {
  std::vector<std::string> names;
  if (!has(group)) return names;
  const Hdf5Handle opened(H5Gopen2(file_, group.c_str(), H5P_DEFAULT), H5Gclose);
  H5G_info_t info;
  if (opened < 0 || H5Gget_info(opened, &info) < 0) return names;
  for (hsize_t k = 0; k < info.nlinks; ++k) {
    char name[256];
    if (H5Lget_name_by_idx(opened, ".", H5_INDEX_NAME, H5_ITER_INC, k, name, sizeof name, H5P_DEFAULT) >= 0) {
      names.emplace_back(name);
    }
  }
  return names;
}

std::optional<std::string> ForeignReader::text_attribute(const std::string& name) const {
  if (H5Aexists(file_, name.c_str()) <= 0) return std::nullopt;
  const Hdf5Handle attribute(H5Aopen(file_, name.c_str(), H5P_DEFAULT), H5Aclose);
  const Hdf5Handle type(H5Aget_type(attribute), H5Tclose), space(H5Aget_space(attribute), H5Sclose);
  if (H5Tget_class(type) != H5T_STRING || H5Sget_simple_extent_npoints(space) != 1) {
    refuse("the attribute " + name + " is not one text");
  }
  if (H5Tis_variable_str(type) > 0) {
    char* text = nullptr;
    const Hdf5Handle memory(H5Tcopy(H5T_C_S1), H5Tclose);
    H5Tset_size(memory, H5T_VARIABLE);
    H5Tset_cset(memory, H5Tget_cset(type));
    if (H5Aread(attribute, memory, &text) < 0 || !text) refuse("the attribute " + name + " cannot be read");
    std::string result(text);
    H5Dvlen_reclaim(memory, space, H5P_DEFAULT, &text);
    return result;
  }
  const std::size_t size = H5Tget_size(type);
  if (size > longest_text) refuse("the attribute " + name + " is too long");
  std::string result(size, '\0');
  if (H5Aread(attribute, type, result.data()) < 0) refuse("the attribute " + name + " cannot be read");
  return result.substr(0, std::min(result.find('\0'), result.size()));
}

std::optional<double> ForeignReader::number_attribute(const std::string& name) const {
  if (H5Aexists(file_, name.c_str()) <= 0) return std::nullopt;
  const Hdf5Handle attribute(H5Aopen(file_, name.c_str(), H5P_DEFAULT), H5Aclose);
  const Hdf5Handle type(H5Aget_type(attribute), H5Tclose), space(H5Aget_space(attribute), H5Sclose);
  double value = 0;
  if (!is_number(type) || H5Sget_simple_extent_npoints(space) != 1 ||
      H5Aread(attribute, H5T_NATIVE_DOUBLE, &value) < 0) {
    refuse("the attribute " + name + " is not one number");
  }
  return value;
}

NumberTable ForeignReader::numbers(const std::string& dataset) const {
  const Hdf5Handle data(H5Dopen2(file_, dataset.c_str(), H5P_DEFAULT), H5Dclose);
  if (data < 0) refuse(dataset + " is not a dataset");
  const Hdf5Handle type(H5Dget_type(data), H5Tclose), space(H5Dget_space(data), H5Sclose);
  const int rank = H5Sget_simple_extent_ndims(space);
  if (!is_number(type)) refuse(dataset + " does not hold numbers");
  if (rank < 1 || rank > 2) refuse(fmt::format("{} has {} dimensions; one or two are wanted", dataset, rank));
  hsize_t extent[2] = {0, 1};
  H5Sget_simple_extent_dims(space, extent, nullptr);
  if (extent[0] > most_values || extent[1] > most_values || extent[0] * extent[1] > most_values) {
    refuse(fmt::format("{} has {} x {} values; at most {} are read", dataset, extent[0], extent[1], most_values));
  }
  // What deflate makes of zeros; more is a size without content.
  const double bytes = static_cast<double>(extent[0] * extent[1]) * static_cast<double>(H5Tget_size(type));
  if (bytes > most_compressed * static_cast<double>(H5Dget_storage_size(data))) {
    refuse(fmt::format("{} says that it has {} x {} values, more than what is stored of it can hold", dataset,
                       extent[0], extent[1]));
  }
  NumberTable table;
  for (int d = 0; d < rank; ++d) table.shape.push_back(static_cast<std::size_t>(extent[d]));
  table.values.resize(static_cast<std::size_t>(extent[0] * extent[1]));
  if (!table.values.empty() &&
      H5Dread(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, table.values.data()) < 0) {
    refuse(dataset + " cannot be read");
  }
  return table;
}

}  // namespace plumbline
