// A final state of another program, spoilt in up to four places: refused, or points that the case can measure. The input says what is
// done to a right file: HDF5 itself, which reads whatever bytes it is given, is not what is tried.
#include <fuzzer/FuzzedDataProvider.h>
#include <hdf5.h>

#include <string_view>

#include "cases/harness/exchange/result_file.hpp"
#include "cases/harness/files/errors.hpp"
#include "kernel/pack.hpp"
#include "tests/hostile/fuzz/memory_file.hpp"

namespace {

using namespace plumbline;

constexpr int points = 6;

// What a data set is made of: its type, shape and values.
struct Written {
  hid_t type = H5T_NATIVE_DOUBLE;
  std::vector<hsize_t> shape;
  std::vector<double> values;
  bool hollow = false;  // chunked, and never written
};

struct FileContent {
  std::vector<std::pair<std::string, double>> numbers{{"exchange_format", 1}, {"time", 0.143}, {"cells", 4}};
  std::vector<std::pair<std::string, std::string>> texts{
      {"kind", "final-state"}, {"case", "sod"}, {"start", "0"}, {"program", "p"}, {"version", "1"}};
  std::vector<std::pair<std::string, Written>> columns;
};

FileContent right() {
  FileContent state;
  for (const char* name : {"position", "velocity", "mass", "density", "volume", "pressure", "energy"}) {
    Written column;
    column.shape = {points};
    for (int p = 0; p < points; ++p) column.values.push_back(0.1 + 0.15 * p);
    state.columns.emplace_back(name, column);
  }
  return state;
}

double any_number(FuzzedDataProvider& input) {
  return input.ConsumeBool() ? input.ConsumeFloatingPoint<double>() : input.ConsumeFloatingPointInRange<double>(-2, 2);
}

void spoil(FuzzedDataProvider& input, FileContent& state) {
  const auto column = [&]() -> Written& {
    return state.columns[input.ConsumeIntegralInRange<std::size_t>(0, state.columns.size() - 1)].second;
  };
  switch (input.ConsumeIntegralInRange(0, 9)) {
    case 0:
      state.numbers[input.ConsumeIntegralInRange<std::size_t>(0, 2)].second = any_number(input);
      break;
    case 1:
      state.texts[input.ConsumeIntegralInRange<std::size_t>(0, 4)].second = input.ConsumeRandomLengthString(40);
      break;
    case 2:
      state.numbers[input.ConsumeIntegralInRange<std::size_t>(0, 2)].first = input.ConsumeRandomLengthString(12);
      break;
    case 3:
      state.texts[input.ConsumeIntegralInRange<std::size_t>(0, 4)].first = input.ConsumeRandomLengthString(12);
      break;
    case 4:
      state.columns[input.ConsumeIntegralInRange<std::size_t>(0, state.columns.size() - 1)].first =
          input.ConsumeRandomLengthString(12);
      break;
    case 5:
      column().values[input.ConsumeIntegralInRange<std::size_t>(0, points - 1)] = any_number(input);
      break;
    case 6: {
      const hid_t types[] = {H5T_NATIVE_FLOAT, H5T_NATIVE_INT8,    H5T_NATIVE_UINT64,
                             H5T_IEEE_F64BE,   H5T_NATIVE_LDOUBLE, H5T_C_S1};
      column().type = types[input.ConsumeIntegralInRange<std::size_t>(0, 5)];
      break;
    }
    case 7: {
      Written& changed = column();
      changed.shape.clear();
      for (int rank = input.ConsumeIntegralInRange(0, 3); rank > 0; --rank)
        changed.shape.push_back(input.ConsumeIntegralInRange<hsize_t>(0, 7));
      break;
    }
    case 8: {
      Written& changed = column();
      changed.shape = {input.ConsumeIntegralInRange<hsize_t>(1, hsize_t{1} << 62)};
      changed.hollow = true;
      break;
    }
    default:
      state.columns.erase(state.columns.begin() +
                          input.ConsumeIntegralInRange<long>(0, static_cast<long>(state.columns.size()) - 1));
  }
}

void write_attribute(hid_t file, const std::string& name, hid_t type, const void* value) {
  if (name.empty() || H5Aexists(file, name.c_str()) > 0) return;
  const hid_t space = H5Screate(H5S_SCALAR);
  const hid_t attribute = H5Acreate2(file, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT);
  if (attribute >= 0) {
    H5Awrite(attribute, type, value);
    H5Aclose(attribute);
  }
  H5Sclose(space);
}

void write_column(hid_t group, const std::string& name, const Written& column) {
  if (name.empty() || name.find('/') != std::string::npos || name == "." ||
      H5Lexists(group, name.c_str(), H5P_DEFAULT) > 0)
    return;
  const hid_t space = column.shape.empty()
                          ? H5Screate(H5S_SCALAR)
                          : H5Screate_simple(static_cast<int>(column.shape.size()), column.shape.data(), nullptr);
  const hid_t how = H5Pcreate(H5P_DATASET_CREATE);
  const hsize_t chunk = 512;
  if (column.hollow) H5Pset_chunk(how, 1, &chunk);
  const hid_t set = H5Dcreate2(group, name.c_str(), column.type, space, H5P_DEFAULT, how, H5P_DEFAULT);
  if (set >= 0) {
    std::vector<double> values = column.values;
    values.resize(343);
    if (!column.hollow && column.type != H5T_C_S1)
      H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
    H5Dclose(set);
  }
  H5Pclose(how);
  H5Sclose(space);
}

// As a file in memory.
std::vector<char> image_of(const FileContent& state) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
  H5Pset_fapl_core(access, 4096, false);
  const hid_t file = H5Fcreate("image", H5F_ACC_TRUNC, H5P_DEFAULT, access);
  for (const auto& [name, value] : state.numbers) write_attribute(file, name, H5T_NATIVE_DOUBLE, &value);
  for (const auto& [name, value] : state.texts) {
    const hid_t type = H5Tcopy(H5T_C_S1);
    H5Tset_size(type, value.size() + 1);
    write_attribute(file, name, type, value.c_str());
    H5Tclose(type);
  }
  const hid_t bodies = H5Gcreate2(file, "bodies", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  const hid_t gas = H5Gcreate2(bodies, "gas", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  for (const auto& [name, column] : state.columns) write_column(gas, name, column);
  H5Gclose(gas);
  H5Gclose(bodies);
  H5Fflush(file, H5F_SCOPE_GLOBAL);
  std::vector<char> image(static_cast<std::size_t>(H5Fget_file_image(file, nullptr, 0)));
  H5Fget_file_image(file, image.data(), image.size());
  H5Fclose(file);
  H5Pclose(access);
  return image;
}

const Scene& tube() {
  static const auto problem = [] {
    const Case& sod = find_case("sod");
    return sod.problem(sod.settings("default", {{"cells", 4.0}}));
  }();
  static const Scene scene = problem->scene();
  return scene;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  FuzzedDataProvider input(bytes, size);
  FileContent state = right();
  for (int count = input.ConsumeIntegralInRange(0, 4); count > 0 && !state.columns.empty(); --count)
    spoil(input, state);
  static MemoryFile file;
  const std::vector<char> image = image_of(state);
  file.write(image.data(), image.size());
  try {
    const ResultFile result(file.path());
    for (const HandedIn& body : result.points(tube())) {
      if (body.points != body.columns.points()) std::abort();
    }
  } catch (const FileError& error) {  // but none for a process that ended while it read
    if (std::string_view(error.what()).find("the process that read it") != std::string_view::npos) std::abort();
  }
  return 0;
}
