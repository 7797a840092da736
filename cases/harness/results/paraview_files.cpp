#include "cases/harness/results/paraview_files.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstdint>
#include <filesystem>

#include "cases/harness/files/errors.hpp"
#include "cases/harness/files/hdf5_file.hpp"
#include "cases/harness/files/text_file.hpp"

namespace plumbline {
namespace {

using Integers = std::vector<std::int64_t>;

constexpr std::uint8_t vtk_vertex = 1, vtk_polyline = 4;

struct Cells {
  Integers connectivity, offsets{0};
  std::vector<std::uint8_t> types;

  void add(std::uint8_t type) {
    types.push_back(type);
    offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
  }
};

Cells cells_of(const FrameSet& set, const Frame& frame) {
  Cells cells;
  std::int64_t end = 0;
  for (std::size_t b = 0; b < set.bodies.size(); ++b) {
    const std::int64_t first = end;
    end += frame.points[b];
    for (std::int64_t p = first; p < end; ++p) {
      cells.connectivity.push_back(p);
      if (!set.bodies[b].chain) cells.add(vtk_vertex);
    }
    if (!set.bodies[b].chain || frame.points[b] == 0) continue;
    if (set.bodies[b].closed) cells.connectivity.push_back(first);
    cells.add(vtk_polyline);
  }
  return cells;
}

std::vector<std::int32_t> bodies_of(const Frame& frame) {
  std::vector<std::int32_t> body;
  for (std::size_t b = 0; b < frame.points.size(); ++b) {
    body.insert(body.end(), static_cast<std::size_t>(frame.points[b]), static_cast<std::int32_t>(b));
  }
  return body;
}

void write_frame(const std::string& path, const FrameSet& set, const Frame& frame) {
  const auto length = [](const auto& list) { return Integers{static_cast<std::int64_t>(list.size())}; };
  const Cells cells = cells_of(set, frame);
  Hdf5Writer file(path);
  file.group("/VTKHDF");
  file.integers_attribute("/VTKHDF", "Version", {1, 0});
  file.ascii_attribute("/VTKHDF", "Type", "UnstructuredGrid");
  file.array<std::int64_t>("/VTKHDF/NumberOfPoints", length(frame.id));
  file.array<std::int64_t>("/VTKHDF/NumberOfCells", length(cells.types));
  file.array<std::int64_t>("/VTKHDF/NumberOfConnectivityIds", length(cells.connectivity));
  file.array<std::int64_t>("/VTKHDF/Connectivity", cells.connectivity);
  file.array<std::int64_t>("/VTKHDF/Offsets", cells.offsets);
  file.array<std::uint8_t>("/VTKHDF/Types", cells.types);
  file.array<float>("/VTKHDF/Points", frame.position, 3);
  file.array<float>("/VTKHDF/PointData/velocity", frame.velocity, 3);
  file.array<float>("/VTKHDF/PointData/pressure", frame.pressure);
  file.array<float>("/VTKHDF/PointData/stress", frame.stress);
  file.array<std::int32_t>("/VTKHDF/PointData/id", frame.id);
  file.array<std::int32_t>("/VTKHDF/PointData/body", bodies_of(frame));
  file.commit();
}

void make_folder(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw FileError(folder, fmt::format("{}: cannot be made: {}", folder, error.message()));
}

}  // namespace

std::string write_paraview_files(const std::string& folder, const std::string& name, const FrameSet& set) {
  if (set.frames.empty()) return "";
  const auto frame_name = [&](std::size_t k) { return fmt::format("{}-{:04}.hdf", name, k); };
  const std::string list = fmt::format("{}/{}.hdf.series", folder, name);
  std::error_code ignored;
  std::filesystem::remove(list, ignored);
  make_folder(folder);
  remove_abandoned(folder);
  nlohmann::ordered_json files = nlohmann::ordered_json::array();
  for (std::size_t k = 0; k < set.frames.size(); ++k) {
    write_frame(folder + "/" + frame_name(k), set, set.frames[k]);
    files.push_back({{"name", frame_name(k)}, {"time", set.frames[k].time}});
  }
  for (std::size_t k = set.frames.size(); std::filesystem::remove(folder + "/" + frame_name(k), ignored);) ++k;
  write_text_file(list, nlohmann::ordered_json{{"file-series-version", "1.0"}, {"files", files}}.dump(1) + "\n");
  return list;
}

}  // namespace plumbline
