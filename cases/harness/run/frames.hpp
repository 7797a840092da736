// Snapshots of the points of a run: what the report draws and ParaView shows.
#pragma once

#include <string>
#include <vector>

#include "kernel/simulation.hpp"

namespace plumbline {

class Archive;

inline constexpr int most_frames = 1000;

// What is wanted of a run.
struct FrameRequest {
  int count =
      0;  // snapshots evenly spaced in time, the first and the last instant included; 0: none, else 2 ... most_frames
  long most_points = 0;  // > 0: of larger runs one point in n, evenly by number, chains whole; 0: all points
};

// What serves both; of two that want none, the same whichever comes first.
FrameRequest of_both(const FrameRequest& one, const FrameRequest& other);

// One instant. Bodies one after another; in a body points by number, those of a chain in the order of their connectivity.
struct Frame {
  double time = 0;                        // s: of the first step that reached the wanted instant
  std::vector<int> points;                // how many of each body
  std::vector<int> id;                    // Body::id
  std::vector<float> position, velocity;  // m, m/s; three components a point, unused ones 0
  // Pa. Gas: the thermodynamic pressure. Solids: minus the mean of the normal stresses that the scene resolves.
  std::vector<float> pressure;  // NaN for membranes
  // Pa. Membranes: along the tangent, of the segment that starts at the point; in space the larger principal resultant
  // over the thickness at rest. Solids: largest less smallest principal stress among those that the scene resolves; on a
  // line the size of the stress.
  std::vector<float> stress;  // NaN for gas
};

struct FrameSet {
  struct BodyInfo {
    std::string name, material, kind;    // kind: "gas", "membrane", "solid"
    bool chain = false, closed = false;  // closed: its last point is joined to the first
  };
  GridSpec grid;
  std::vector<BodyInfo> bodies;
  long every = 1;  // one point in so many is there of bodies that are no chain
  std::vector<Frame> frames;
};

// Looks on as a run goes; changes nothing in it.
class FrameRecorder {
 public:
  FrameRecorder(const FrameRequest& request, const Scene& scene, double end_time);
  // Call before the first step and after each one. One frame a step at most: a run of few steps has fewer frames.
  void look(const Simulation& simulation);
  FrameSet take() { return std::move(set_); }
  void history(Archive& archive);

 private:
  FrameRequest request_;
  double end_time_;
  int next_ = 0;
  FrameSet set_;
};

}  // namespace plumbline
