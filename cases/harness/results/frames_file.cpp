#include "cases/harness/results/frames_file.hpp"
#include "cases/harness/files/json_text.hpp"

#include <nlohmann/json.hpp>

#include <cstdint>

namespace plumbline {
namespace {

using Json = nlohmann::ordered_json;

template <class To, class From>
void append(std::vector<To>& all, const std::vector<From>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

void write_points(Hdf5Writer& file, const FrameSet& set) {
  std::vector<double> times;
  std::vector<std::int64_t> starts{0};
  std::vector<float> position, velocity, pressure, stress;
  std::vector<std::int32_t> id, body;
  for (const Frame& frame : set.frames) {
    times.push_back(frame.time);
    append(position, frame.position);
    append(velocity, frame.velocity);
    append(pressure, frame.pressure);
    append(stress, frame.stress);
    append(id, frame.id);
    for (std::size_t b = 0; b < frame.points.size(); ++b) {
      body.insert(body.end(), static_cast<std::size_t>(frame.points[b]), static_cast<std::int32_t>(b));
    }
    starts.push_back(static_cast<std::int64_t>(id.size()));
  }
  file.numbers("/frames/time", times);
  file.array<std::int64_t>("/frames/start", starts);
  file.array<float>("/frames/position", position, 3);
  file.array<float>("/frames/velocity", velocity, 3);
  file.array<float>("/frames/pressure", pressure);
  file.array<float>("/frames/stress", stress);
  file.array<std::int32_t>("/frames/id", id);
  file.array<std::int32_t>("/frames/body", body);
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
  file.group("/frames");
  file.text("/frames/description", json_text(description(set)));
  write_points(file, set);
}

}  // namespace plumbline
