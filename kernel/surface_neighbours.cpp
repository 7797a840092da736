#include "kernel/surface_neighbours.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <stdexcept>
#include <string>

#include "kernel/points/cubes.hpp"
#include "kernel/surface_balance.hpp"

namespace plumbline {
namespace {

using Vec = Eigen::Vector3d;
using Frame = Eigen::Matrix<double, 3, 2>;
constexpr int terms = 5;  // of a quadratic without its constant

Vec place_of(const Columns& points, int p) {
  return {points(column::position, 0)[p], points(column::position, 1)[p], points(column::position, 2)[p]};
}

Frame frame_of(const Columns& points, int p) {
  Frame f;
  for (int a = 0; a < 2; ++a) {
    for (int d = 0; d < 3; ++d) f(d, a) = points(column::tangents, 3 * a + d)[p];
  }
  if (!((f.transpose() * f).determinant() > 0)) {
    throw std::invalid_argument("point " + std::to_string(p) + " of a surface has no tangents at the start");
  }
  return f;
}

// What may be a neighbour: a point, or an image of one.
struct Candidate {
  Vec place;
  int point;
  bool image;
};

std::vector<Candidate> candidates(const Columns& points, const std::vector<OddImage>& images) {
  std::vector<Candidate> all;
  for (int p = 0; p < points.points(); ++p) all.push_back({place_of(points, p), p, false});
  for (const OddImage& image : images) {
    all.push_back({Vec(image.place[0], image.place[1], image.place[2]), image.partner, true});
  }
  return all;
}

std::vector<Vec> places_of(const std::vector<Candidate>& all) {
  std::vector<Vec> places;
  for (const Candidate& one : all) places.push_back(one.place);
  return places;
}

double longest_tangent(const Columns& points) {
  double longest = 0;
  for (int p = 0; p < points.points(); ++p) longest = std::max(longest, frame_of(points, p).operatorNorm());
  return longest;
}

// A neighbour with the terms of its place on the surface at rest, lengths over the reach, and its weight.
struct Neighbour {
  Candidate at;
  Eigen::Matrix<double, terms, 1> phi;
  double weight;
};

// Places as a point sees them at the start: along its tangents as at rest, and out of their plane as in space, so that on a folded
// sheet the other side is no neighbour.
class Sight {
 public:
  Sight(const Columns& points, int p)
      : place_(place_of(points, p)),
        f_(frame_of(points, p)),
        dual_((f_.transpose() * f_).inverse() * f_.transpose()) {}
  const Vec& place() const { return place_; }
  Eigen::Vector2d along(const Vec& other) const { return dual_ * (other - place_); }
  // Of the distance over the reach.
  double square(const Vec& other, double reach) const {
    const Eigen::Vector2d to = along(other), xi = to / reach;
    return xi.squaredNorm() + (other - place_ - f_ * to).squaredNorm() / (reach * reach);
  }
  // Of weight zero at the reach.
  Neighbour neighbour(const Candidate& at, double reach) const {
    const Eigen::Vector2d xi = along(at.place) / reach;
    const double left = 1 - square(at.place, reach);
    Neighbour found{at, {}, left * left};
    found.phi << xi[0], xi[1], xi[0] * xi[0] / 2, xi[0] * xi[1], xi[1] * xi[1] / 2;
    return found;
  }

 private:
  Vec place_;
  Frame f_;
  Eigen::Matrix<double, 2, 3> dual_;
};

std::vector<Neighbour> neighbours_of(const std::vector<Candidate>& candidates, const Cubes& near, int p,
                                     const Sight& sight, double reach, const std::vector<int>& sheet) {
  const auto together = [&](int a, int b) {
    if (sheet.empty()) return true;
    const int one = sheet[static_cast<std::size_t>(a)], other = sheet[static_cast<std::size_t>(b)];
    return one == other || one < 0 || other < 0;
  };
  std::vector<Neighbour> all;
  near.for_near(sight.place(), [&](std::size_t k) {
    const Candidate& other = candidates[k];
    if ((!other.image && other.point == p) || !together(p, other.point)) return;
    if (sight.square(other.place, reach) < 1) all.push_back(sight.neighbour(other, reach));
  });
  return all;
}

// Links of all points in their order, and of those with images what the places of image and partner add up to.
struct Links {
  std::vector<SurfaceLink> all;
  std::vector<Vec> both;
  // Of point p with its neighbours, by moving least squares.
  void add(const Columns& points, int p, const std::vector<Neighbour>& own, double reach) {
    Eigen::Matrix<double, terms, terms> normal = Eigen::Matrix<double, terms, terms>::Zero();
    for (const Neighbour& n : own) normal += n.weight * n.phi * n.phi.transpose();
    const Eigen::FullPivLU<Eigen::Matrix<double, terms, terms>> solver(normal);
    if (solver.rank() < terms) {
      throw std::invalid_argument("point " + std::to_string(p) + " of a surface has " + std::to_string(own.size()) +
                                  " neighbours, too few for its tangents: a larger reach, or more points");
    }
    const Eigen::Matrix<double, terms, terms> inverse = solver.inverse();
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (const Neighbour& n : own) {
      const Eigen::Vector2d c = inverse.topRows<2>() * n.phi * (n.weight / reach);  // [Surface 1]
      sum += c;
      all.push_back({p, n.at.point, n.at.image, {}, {c[0], c[1]}});
      for (std::size_t k = 0; k < terms; ++k) all.back().terms[k] = n.phi[static_cast<int>(k)];
      if (n.at.image) both.emplace_back(n.at.place + place_of(points, n.at.point));
    }
    all.push_back({p, p, false, {}, {-sum[0], -sum[1]}});
  }
};

void transpose(const SurfaceNeighbours::Links& of, SurfaceNeighbours::Links& on) {
  const std::size_t points = of.first.size() - 1, count = of.other.size();
  on.first.assign(points + 1, 0);
  for (const int other : of.other) ++on.first[static_cast<std::size_t>(other) + 1];
  for (std::size_t p = 0; p < points; ++p) on.first[p + 1] += on.first[p];
  std::vector<int> next(on.first.begin(), on.first.end() - 1);
  on.other.resize(count);
  on.along.resize(count);
  on.across.resize(count);
  for (std::size_t p = 0; p < points; ++p) {
    for (int k = of.first[p]; k < of.first[p + 1]; ++k) {
      const auto from = static_cast<std::size_t>(k);
      const auto to = static_cast<std::size_t>(next[static_cast<std::size_t>(of.other[from])]++);
      on.other[to] = static_cast<int>(p);
      on.along[to] = of.along[from];
      on.across[to] = of.across[from];
    }
  }
}

// Links in the order of the points that they are of.
SurfaceNeighbours of_links(const Links& links, int points) {
  SurfaceNeighbours found;
  SurfaceNeighbours::Links& of = found.of;
  if (!links.both.empty()) found.fixed.assign(static_cast<std::size_t>(6 * points), 0.0);
  of.first.assign(static_cast<std::size_t>(points) + 1, 0);
  auto image = links.both.begin();
  for (const SurfaceLink& link : links.all) {
    const double sign = link.image ? -1 : 1;
    of.other.push_back(link.on);
    of.along.push_back(sign * link.weight[0]);
    of.across.push_back(sign * link.weight[1]);
    of.first[static_cast<std::size_t>(link.of) + 1] = static_cast<int>(of.other.size());
    if (!link.image) continue;
    for (std::size_t a = 0; a < 2; ++a) {
      for (int d = 0; d < 3; ++d) {
        found.fixed[6 * static_cast<std::size_t>(link.of) + 3 * a + static_cast<std::size_t>(d)] += link.weight[a] *
                                                                                                    (*image)[d];
      }
    }
    ++image;
  }
  transpose(of, found.on);
  return found;
}

}  // namespace

SurfaceNeighbours surface_neighbours(const Columns& points, double reach, const std::vector<OddImage>& images,
                                     const std::vector<int>& sheet, const std::vector<std::array<double, 3>>& outward) {
  const std::vector<Candidate> all = candidates(points, images);
  const Cubes near(places_of(all), reach * longest_tangent(points));
  Links links;
  for (int p = 0; p < points.points(); ++p) {
    links.add(points, p, neighbours_of(all, near, p, Sight(points, p), reach, sheet), reach);
  }
  if (!outward.empty()) balance_weights(links.all, points, reach, outward);
  return of_links(links, points.points());
}

SurfaceNeighbours surface_neighbours(const Columns& points, const std::vector<std::vector<int>>& given) {
  constexpr double beyond = 1.2;  // reach over the distance of the farthest, so that it has a weight
  if (given.size() != static_cast<std::size_t>(points.points())) {
    throw std::invalid_argument("neighbours are given of " + std::to_string(given.size()) + " of the " +
                                std::to_string(points.points()) + " points of a surface");
  }
  Links links;
  for (int p = 0; p < points.points(); ++p) {
    const Sight sight(points, p);
    double farthest = 0;
    for (const int other : given[static_cast<std::size_t>(p)]) {
      if (other < 0 || other >= points.points() || other == p) {
        throw std::invalid_argument("point " + std::to_string(p) + " of a surface has " + std::to_string(other) +
                                    " for a neighbour: no other of its " + std::to_string(points.points()) + " points");
      }
      farthest = std::max(farthest, std::sqrt(sight.square(place_of(points, other), 1)));
    }
    std::vector<Neighbour> own;
    for (const int other : given[static_cast<std::size_t>(p)]) {
      own.push_back(sight.neighbour({place_of(points, other), other, false}, beyond * farthest));
    }
    links.add(points, p, own, beyond * farthest);
  }
  return of_links(links, points.points());
}

}  // namespace plumbline
