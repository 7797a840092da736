#include "cases/catalog/membrane/sphere_mesh.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

namespace plumbline {
namespace {

using Vec = Eigen::Vector3d;

std::vector<Vec> places_of(const Columns& points) {
  std::vector<Vec> all;
  for (int p = 0; p < points.points(); ++p) {
    all.emplace_back(points(column::position, 0)[p], points(column::position, 1)[p], points(column::position, 2)[p]);
  }
  return all;
}

// Of the points that for which `size` is largest, and must be more than none.
template <class Size>
int farthest(const std::vector<Vec>& places, Size&& size) {
  const auto most = std::max_element(places.begin(), places.end(),
                                     [&](const Vec& a, const Vec& b) { return size(a) < size(b); });
  if (most == places.end() || !(size(*most) > 0))
    throw std::invalid_argument("a mesh of points on a sphere needs four that are in no plane");
  return static_cast<int>(most - places.begin());
}

// The convex hull of the points that it was given so far.
class Hull {
 public:
  explicit Hull(const std::vector<Vec>& places) : places_(places) {
    const int a = farthest(places, [](const Vec& x) { return x.squaredNorm(); });
    const int b = farthest(places, [&](const Vec& x) { return (x - at(a)).squaredNorm(); });
    const Vec along = at(b) - at(a);
    const int c = farthest(places, [&](const Vec& x) { return along.cross(x - at(a)).squaredNorm(); });
    const Vec normal = along.cross(at(c) - at(a));
    const int d = farthest(places, [&](const Vec& x) { return std::abs(normal.dot(x - at(a))); });
    first_ = {a, b, c, d};
    const bool below = normal.dot(at(d) - at(a)) < 0;
    for (const Triangle& face : {Triangle{a, b, c}, {a, d, b}, {b, d, c}, {c, d, a}})
      add_face(below ? face : Triangle{face[0], face[2], face[1]});
  }

  // The faces that see the point give way to triangles between it and the edges about them.
  void add(int p) {
    if (std::find(first_.begin(), first_.end(), p) != first_.end()) return;
    const auto seen = std::partition(faces_.begin(), faces_.end(), [&](const Face& face) {
      return !(face.normal.dot(at(p) - at(face.corners[0])) > 0);
    });
    std::set<std::pair<int, int>> edges;
    for (auto face = seen; face != faces_.end(); ++face) {
      for (std::size_t k = 0; k < 3; ++k) edges.emplace(face->corners[k], face->corners[(k + 1) % 3]);
    }
    faces_.erase(seen, faces_.end());
    for (const auto& [from, to] : edges) {
      if (at(from) == at(p)) {
        throw std::invalid_argument("points " + std::to_string(from) + " and " + std::to_string(p) +
                                    " of a sphere stand in one place");
      }
      if (!edges.contains({to, from})) add_face({from, to, p});
    }
  }

  std::vector<Triangle> triangles() const {
    std::vector<Triangle> all;
    for (const Face& face : faces_) all.push_back(face.corners);
    return all;
  }

 private:
  struct Face {
    Triangle corners;  // counter-clockwise from outside
    Vec normal;        // outwards
  };

  const Vec& at(int p) const { return places_[static_cast<std::size_t>(p)]; }
  void add_face(const Triangle& corners) {
    const Vec& a = at(corners[0]);
    faces_.push_back({corners, (at(corners[1]) - a).cross(at(corners[2]) - a)});
  }

  const std::vector<Vec>& places_;
  std::array<int, 4> first_{};
  std::vector<Face> faces_;
};

// Each edge once in each of its directions, each point a corner, and of V points 2 V - 4 faces (Euler).
bool closed(const std::vector<Triangle>& mesh, std::size_t points) {
  std::set<std::pair<int, int>> edges;
  std::set<int> corners;
  for (const Triangle& face : mesh) {
    for (std::size_t k = 0; k < 3; ++k) {
      corners.insert(face[k]);
      if (!edges.emplace(face[k], face[(k + 1) % 3]).second) return false;
    }
  }
  const bool paired = std::all_of(edges.begin(), edges.end(), [&](const std::pair<int, int>& edge) {
    return edges.contains({edge.second, edge.first});
  });
  return paired && corners.size() == points && mesh.size() + 4 == 2 * points;
}

}  // namespace

std::vector<Triangle> sphere_mesh(const Columns& points) {
  const std::vector<Vec> places = places_of(points);
  Hull hull(places);
  for (int p = 0; p < points.points(); ++p) hull.add(p);
  std::vector<Triangle> mesh = hull.triangles();
  if (!closed(mesh, places.size())) {
    throw std::invalid_argument("the " + std::to_string(places.size()) + " points have no mesh of a sphere: its " +
                                std::to_string(mesh.size()) + " triangles do not close with each point for a corner");
  }
  return mesh;
}

}  // namespace plumbline
