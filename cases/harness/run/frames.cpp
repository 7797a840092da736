#include "cases/harness/run/frames.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "cases/harness/description/archive.hpp"
#include "kernel/materials/segment_membrane.hpp"
#include "kernel/materials/surface_law.hpp"
#include "kernel/materials/uniaxial_membrane.hpp"

namespace plumbline {
namespace {

constexpr float no_value = std::numeric_limits<float>::quiet_NaN();

bool is_closed(const Material& material) {
  if (const auto* segments = dynamic_cast<const SegmentMembrane*>(&material)) return segments->closed;
  if (const auto* layer = dynamic_cast<const UniaxialMembrane*>(&material)) return layer->closed;
  return false;
}

FrameSet::BodyInfo describe(const Body& body) {
  const Material& material = *body.material;
  const bool sheet = material.chain() || body.points.has(column::tangent) || body.points.has(column::tangents);
  const char* kind = material.isotropic() ? "gas" : sheet ? "membrane" : "solid";
  return {body.name, material.name(), kind, material.chain(), is_closed(material)};
}

// The stress of one point as a matrix of the directions that its columns resolve.
Eigen::Matrix3d stress_matrix(const Columns& points, StressMeasure measure, int dim, int p) {
  Eigen::Matrix3d s = Eigen::Matrix3d::Zero();
  const auto at = [&](int component) { return points(column::stress, component)[p]; };
  const int components = points.components(column::stress);
  if (measure == StressMeasure::full) {
    for (int i = 0; i < dim; ++i) {
      for (int j = 0; j < dim; ++j) s(i, j) = 0.5 * (at(i * dim + j) + at(j * dim + i));
    }
    if (components > dim * dim) s(2, 2) = at(dim * dim);
    return s;
  }
  const int normals = components == 6 || components == 4 ? 3 : dim;
  for (int d = 0; d < normals; ++d) s(d, d) = at(d);
  if (components == 6) {
    s(1, 2) = s(2, 1) = at(3);
    s(0, 2) = s(2, 0) = at(4);
    s(0, 1) = s(1, 0) = at(5);
  } else if (dim == 2) {
    s(0, 1) = s(1, 0) = at(normals);
  }
  return s;
}

struct Stresses {
  double pressure, difference;
};

Stresses solid_stresses(const Columns& points, StressMeasure measure, const GridSpec& grid, int p) {
  const Eigen::Matrix3d s = stress_matrix(points, measure, grid.dim, p);
  const int resolved = grid.dim == 2 && !grid.axisymmetric ? 2 : grid.dim == 1 ? 1 : 3;
  const double pressure = -s.topLeftCorner(resolved, resolved).trace() / resolved;
  if (resolved == 1) return {pressure, std::abs(pressure)};
  if (resolved == 2) return {pressure, std::hypot(s(0, 0) - s(1, 1), 2 * s(0, 1))};
  const Eigen::Vector3d principal =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(s, Eigen::EigenvaluesOnly).eigenvalues();
  return {pressure, principal[2] - principal[0]};
}

double membrane_stress(const Body& body, int p) {
  const Columns& points = body.points;
  if (const auto* segments = dynamic_cast<const SegmentMembrane*>(body.material.get())) {
    const int start = segments->has_segment(points, p) ? p : std::max(p - 1, 0);
    const double strain = points(column::strain)[start];
    if (segments->revolved) return segments->band(strain, points(column::hoop_strain)[start]).along;
    return segments->tension(strain) / segments->section;
  }
  if (const auto* law = dynamic_cast<const SurfaceLaw*>(body.material.get()))
    return law->principal_stresses(metric_of(points, p)).largest;
  if (!points.has(column::tangent)) return points(column::stress)[p];
  const double tx = points(column::tangent)[p], ty = points(column::tangent, 1)[p];
  const int shear = points.components(column::stress) - 1;
  return points(column::stress)[p] * tx * tx + points(column::stress, 1)[p] * ty * ty +
         2 * points(column::stress, shear)[p] * tx * ty;
}

void add_vector(const Columns& points, const ColumnId& id, int dim, int p, std::vector<float>& values) {
  for (int d = 0; d < 3; ++d) values.push_back(d < dim ? static_cast<float>(points(id, d)[p]) : 0.0F);
}

// The points to keep, by number; those of a chain as they stand.
std::vector<int> kept_points(const Body& body, long every) {
  std::vector<int> kept(static_cast<std::size_t>(body.points.points()));
  std::iota(kept.begin(), kept.end(), 0);
  if (body.material->chain() || body.id.size() != kept.size()) return kept;
  const auto number = [&](int p) { return body.id[static_cast<std::size_t>(p)]; };
  // Multiples of the golden section fill the unit interval evenly, and rows of points with it: every n-th number would
  // leave stripes.
  const auto left_out = [&](int p) {
    return std::fmod(0.61803398874989485 * number(p), 1.0) >= 1.0 / static_cast<double>(every);
  };
  if (every > 1) kept.erase(std::remove_if(kept.begin(), kept.end(), left_out), kept.end());
  std::sort(kept.begin(), kept.end(), [&](int a, int b) { return number(a) < number(b); });
  return kept;
}

void add_body(const Body& body, const std::string& kind, const GridSpec& grid, long every, Frame& frame) {
  const std::vector<int> kept = kept_points(body, every);
  frame.points.push_back(static_cast<int>(kept.size()));
  for (const int p : kept) {
    frame.id.push_back(body.id.empty() ? p : body.id[static_cast<std::size_t>(p)]);
    add_vector(body.points, column::position, grid.dim, p, frame.position);
    add_vector(body.points, column::velocity, grid.dim, p, frame.velocity);
    float pressure = no_value, stress = no_value;
    if (kind == "gas") {
      pressure = static_cast<float>(body.points(column::pressure)[p]);
    } else if (kind == "membrane") {
      stress = static_cast<float>(membrane_stress(body, p));
    } else {
      const Stresses s = solid_stresses(body.points, body.material->measure(), grid, p);
      pressure = static_cast<float>(s.pressure);
      stress = static_cast<float>(s.difference);
    }
    frame.pressure.push_back(pressure);
    frame.stress.push_back(stress);
  }
}

long thinning(const Scene& scene, long most_points) {
  long in_chains = 0, others = 0;
  for (const Body& body : scene.bodies) (body.material->chain() ? in_chains : others) += body.points.points();
  const long free = std::max(most_points - in_chains, 1L);
  return most_points > 0 && others > free ? (others + free - 1) / free : 1;
}

}  // namespace

FrameRequest of_both(const FrameRequest& one, const FrameRequest& other) {
  if (one.count == 0 && other.count == 0) return {};
  if (one.count == 0 || other.count == 0) return one.count > 0 ? one : other;
  const bool all = one.most_points == 0 || other.most_points == 0;
  return {std::max(one.count, other.count), all ? 0 : std::max(one.most_points, other.most_points)};
}

FrameRecorder::FrameRecorder(const FrameRequest& request, const Scene& scene, double end_time)
    : request_(request),
      end_time_(end_time) {
  if (request.count == 0) return;
  set_.grid = scene.grid;
  for (const Body& body : scene.bodies) set_.bodies.push_back(describe(body));
  set_.every = thinning(scene, request.most_points);
}

void FrameRecorder::look(const Simulation& simulation) {
  const int last = request_.count - 1;
  // The same rounding that decides when a run is at its end.
  const auto due = [&] { return simulation.time() >= end_time_ * next_ / last - 1e-12 * end_time_; };
  if (next_ > last || !due()) return;
  Frame frame;
  frame.time = simulation.time();
  const Scene& scene = simulation.scene();
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    add_body(scene.bodies[b], set_.bodies[b].kind, set_.grid, set_.every, frame);
  }
  set_.frames.push_back(std::move(frame));
  while (next_ <= last && due()) ++next_;
}

namespace {

// One part of all frames, in a vector of its own.
template <class T>
void archive_part(Archive& archive, const std::string& name, T Frame::*part, std::vector<Frame>& frames) {
  std::vector<T> all;
  for (const Frame& frame : frames) all.push_back(frame.*part);
  archive(name, all);
  if (archive.reads() && all.size() != frames.size()) throw ArchiveError(name + " is not there for each frame");
  for (std::size_t k = 0; archive.reads() && k < all.size(); ++k) frames[k].*part = std::move(all[k]);
}

}  // namespace

void FrameRecorder::history(Archive& archive) {
  auto count = static_cast<int>(set_.frames.size());
  archive("next", next_);
  archive("count", count);
  if (count < 0 || count > request_.count) throw ArchiveError("there are more frames than were asked for");
  set_.frames.resize(static_cast<std::size_t>(count));
  archive_part(archive, "time", &Frame::time, set_.frames);
  archive_part(archive, "points", &Frame::points, set_.frames);
  archive_part(archive, "id", &Frame::id, set_.frames);
  archive_part(archive, "position", &Frame::position, set_.frames);
  archive_part(archive, "velocity", &Frame::velocity, set_.frames);
  archive_part(archive, "pressure", &Frame::pressure, set_.frames);
  archive_part(archive, "stress", &Frame::stress, set_.frames);
}

}  // namespace plumbline
