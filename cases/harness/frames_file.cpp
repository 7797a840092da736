#include "cases/harness/frames_file.hpp"

#include <nlohmann/json.hpp>

#include <cstdint>

namespace plumbline {
namespace {

using Json = nlohmann::ordered_json;
using Integers = std::vector<std::int64_t>;

constexpr std::uint8_t vtk_vertex = 1, vtk_polyline = 4;

// Cells of frames that have as many points in each body: written once, as one part of the file.
struct Topology {
  std::int64_t points = 0;
  Integers connectivity, offsets{0};
  std::vector<std::uint8_t> types;

  void add_cell(std::uint8_t type) {
    types.push_back(type);
    offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
  }
};

Topology topology_of(const FrameSet& set, const Frame& frame) {
  Topology cells;
  for (std::size_t b = 0; b < set.bodies.size(); ++b) {
    const std::int64_t first = cells.points;
    cells.points += frame.points[b];
    for (std::int64_t p = first; p < cells.points; ++p) {
      cells.connectivity.push_back(p);
      if (!set.bodies[b].chain) cells.add_cell(vtk_vertex);
    }
    if (!set.bodies[b].chain || frame.points[b] == 0) continue;
    if (set.bodies[b].closed) cells.connectivity.push_back(first);
    cells.add_cell(vtk_polyline);
  }
  return cells;
}

template <class To, class From>
void append(std::vector<To>& all, const std::vector<From>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

// Where each step finds its part, points and cells.
struct Steps {
  std::vector<double> times;
  Integers parts, points, cells, connectivity;
};

Steps write_cells(Hdf5Writer& file, const FrameSet& set) {
  Steps steps;
  Integers part_points, part_cells, part_connectivity, connectivity, offsets;
  std::vector<std::uint8_t> types;
  std::vector<int> known;
  std::int64_t points = 0, first_cell = 0, first_connectivity = 0;
  for (const Frame& frame : set.frames) {
    if (frame.points != known) {
      known = frame.points;
      const Topology cells = topology_of(set, frame);
      first_cell = static_cast<std::int64_t>(types.size());
      first_connectivity = static_cast<std::int64_t>(connectivity.size());
      part_points.push_back(cells.points);
      part_cells.push_back(static_cast<std::int64_t>(cells.types.size()));
      part_connectivity.push_back(static_cast<std::int64_t>(cells.connectivity.size()));
      append(connectivity, cells.connectivity);
      append(offsets, cells.offsets);
      append(types, cells.types);
    }
    steps.times.push_back(frame.time);
    steps.parts.push_back(static_cast<std::int64_t>(part_points.size()) - 1);
    steps.points.push_back(points);
    steps.cells.push_back(first_cell);
    steps.connectivity.push_back(first_connectivity);
    points += part_points.back();
  }
  file.array<std::int64_t>("/VTKHDF/NumberOfPoints", part_points);
  file.array<std::int64_t>("/VTKHDF/NumberOfCells", part_cells);
  file.array<std::int64_t>("/VTKHDF/NumberOfConnectivityIds", part_connectivity);
  file.array<std::int64_t>("/VTKHDF/Connectivity", connectivity);
  file.array<std::int64_t>("/VTKHDF/Offsets", offsets);
  file.array<std::uint8_t>("/VTKHDF/Types", types);
  return steps;
}

void write_steps(Hdf5Writer& file, const Steps& steps, const std::vector<std::string>& fields) {
  file.group("/VTKHDF/Steps");
  file.attribute("/VTKHDF/Steps", "NSteps", static_cast<std::int64_t>(steps.times.size()));
  file.numbers("/VTKHDF/Steps/Values", steps.times);
  file.array<std::int64_t>("/VTKHDF/Steps/PartOffsets", steps.parts);
  file.array<std::int64_t>("/VTKHDF/Steps/NumberOfParts", Integers(steps.times.size(), 1));
  file.array<std::int64_t>("/VTKHDF/Steps/PointOffsets", steps.points);
  file.array<std::int64_t>("/VTKHDF/Steps/CellOffsets", steps.cells, 1);
  file.array<std::int64_t>("/VTKHDF/Steps/ConnectivityIdOffsets", steps.connectivity, 1);
  for (const std::string& field : fields) {
    file.array<std::int64_t>("/VTKHDF/Steps/PointDataOffsets/" + field, steps.points);
  }
}

std::vector<std::string> write_points(Hdf5Writer& file, const FrameSet& set) {
  std::vector<float> position, velocity, pressure, stress;
  std::vector<std::int32_t> id, body;
  for (const Frame& frame : set.frames) {
    append(position, frame.position);
    append(velocity, frame.velocity);
    append(pressure, frame.pressure);
    append(stress, frame.stress);
    append(id, frame.id);
    for (std::size_t b = 0; b < frame.points.size(); ++b) {
      body.insert(body.end(), static_cast<std::size_t>(frame.points[b]), static_cast<std::int32_t>(b));
    }
  }
  file.array<float>("/VTKHDF/Points", position, 3);
  file.array<float>("/VTKHDF/PointData/velocity", velocity, 3);
  file.array<float>("/VTKHDF/PointData/pressure", pressure);
  file.array<float>("/VTKHDF/PointData/stress", stress);
  file.array<std::int32_t>("/VTKHDF/PointData/id", id);
  file.array<std::int32_t>("/VTKHDF/PointData/body", body);
  return {"velocity", "pressure", "stress", "id", "body"};
}

const char* name_of(Wall wall) { return wall == Wall::free ? "free" : wall == Wall::symmetry ? "symmetry" : "no_slip"; }

Json description(const FrameSet& set) {
  Json bodies = Json::array(), walls = Json::array();
  for (const FrameSet::BodyInfo& body : set.bodies) {
    bodies.push_back({{"name", body.name},
                      {"kind", body.kind},
                      {"material", body.material},
                      {"chain", body.chain},
                      {"closed", body.closed}});
  }
  const GridSpec& grid = set.grid;
  Json low = Json::array(), high = Json::array();
  for (std::size_t d = 0; d < static_cast<std::size_t>(grid.dim); ++d) {
    low.push_back(grid.origin[d]);
    high.push_back(grid.origin[d] + grid.h * grid.cells[d]);
    walls.push_back({name_of(grid.walls[d][0]), name_of(grid.walls[d][1])});
  }
  return {{"dim", grid.dim},
          {"axisymmetric", grid.axisymmetric},
          {"h", grid.h},
          {"low", low},
          {"high", high},
          {"walls", walls},
          {"every", set.every},
          {"bodies", bodies},
          {"units", {{"position", "m"}, {"velocity", "m/s"}, {"pressure", "Pa"}, {"stress", "Pa"}, {"time", "s"}}}};
}

}  // namespace

void write_frames(Hdf5Writer& file, const FrameSet& set) {
  if (set.frames.empty()) return;
  file.text("/frames", description(set).dump());
  file.group("/VTKHDF");
  file.integers_attribute("/VTKHDF", "Version", {2, 0});
  file.ascii_attribute("/VTKHDF", "Type", "UnstructuredGrid");
  const Steps steps = write_cells(file, set);
  write_steps(file, steps, write_points(file, set));
}

}  // namespace plumbline
