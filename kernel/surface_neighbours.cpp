#include "kernel/surface_neighbours.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "kernel/materials/surface_law.hpp"
#include "kernel/points/cubes.hpp"
#include "kernel/surface_balance.hpp"

namespace plumbline {
namespace {

using Vec = Eigen::Vector3d;
using Frame = Eigen::Matrix<double, 3, 2>;
constexpr int terms = 5;  // of a quadratic without its constant

Frame frame_of(const Columns& points, int p) {
  Frame f;
  for (int a = 0; a < 2; ++a) {
    for (int d = 0; d < 3; ++d) f(d, a) = points(column::tangents, 3 * a + d)[p];
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
  for (int p = 0; p < points.points(); ++p) {
    const Frame f = frame_of(points, p);
    if (!((f.transpose() * f).determinant() > 0)) {
      throw std::invalid_argument("point " + std::to_string(p) + " of a surface has no tangents at the start");
    }
    longest = std::max(longest, f.operatorNorm());
  }
  return longest;
}

// Which pairs of points may be neighbours, however near they are.
struct Pairs {
  const std::vector<int>& sheet;
  const std::vector<std::vector<int>>& given;  // sorted
  bool may_be(int a, int b) const {
    if (!given.empty()) {
      const std::vector<int>& of = given[static_cast<std::size_t>(a)];
      if (!std::binary_search(of.begin(), of.end(), b)) return false;
    }
    if (sheet.empty()) return true;
    const int one = sheet[static_cast<std::size_t>(a)], other = sheet[static_cast<std::size_t>(b)];
    return one == other || one < 0 || other < 0;
  }
};

// Throws std::invalid_argument for what cannot be neighbours.
void sort_given(std::vector<std::vector<int>>& given, int points) {
  if (given.empty()) return;
  if (given.size() != static_cast<std::size_t>(points)) {
    throw std::invalid_argument("neighbours are given of " + std::to_string(given.size()) + " of the " +
                                std::to_string(points) + " points of a surface");
  }
  for (std::size_t p = 0; p < given.size(); ++p) {
    std::vector<int>& of = given[p];
    std::sort(of.begin(), of.end());
    for (const int other : of) {
      if (other >= 0 && other < points && other != static_cast<int>(p)) continue;
      throw std::invalid_argument("point " + std::to_string(p) + " of a surface has the neighbour " +
                                  std::to_string(other) + ": no other of the points 0 to " +
                                  std::to_string(points - 1));
    }
  }
}

// A neighbour with the terms of its place on the surface at rest, lengths over the reach, and its weight.
struct Neighbour {
  Candidate at;
  Eigen::Matrix<double, terms, 1> phi;
  double weight;
};

std::vector<Neighbour> neighbours_of(const std::vector<Candidate>& candidates, const Cubes& near, int p, const Frame& f,
                                     double reach, const Pairs& pairs) {
  const Candidate& point = candidates[static_cast<std::size_t>(p)];
  const Eigen::Matrix<double, 2, 3> dual = (f.transpose() * f).inverse() * f.transpose();
  std::vector<Neighbour> all;
  near.for_near(point.place, [&](std::size_t k) {
    const Candidate& other = candidates[k];
    const bool own = other.point == point.point;
    if (own ? !other.image : !pairs.may_be(point.point, other.point)) return;
    const Vec apart = other.place - point.place;
    const Eigen::Vector2d xi = dual * apart / reach;
    // Out of the tangents' plane distances are those of space: on a folded sheet the other side is no neighbour.
    const double across = (apart - f * (dual * apart)).squaredNorm() / (reach * reach);
    const double square = xi.squaredNorm() + across;
    if (square >= 1) return;
    Neighbour found{other, {}, (1 - square) * (1 - square)};
    found.phi << xi[0], xi[1], xi[0] * xi[0] / 2, xi[0] * xi[1], xi[1] * xi[1] / 2;
    all.push_back(found);
  });
  return all;
}

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
SurfaceNeighbours of_links(const std::vector<SurfaceLink>& links, const std::vector<Vec>& both, int points) {
  SurfaceNeighbours found;
  SurfaceNeighbours::Links& of = found.of;
  if (!both.empty()) found.fixed.assign(static_cast<std::size_t>(6 * points), 0.0);
  of.first.assign(static_cast<std::size_t>(points) + 1, 0);
  auto image = both.begin();
  for (const SurfaceLink& link : links) {
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
                                     const std::vector<int>& sheet, const std::vector<std::array<double, 3>>& outward,
                                     std::vector<std::vector<int>> given) {
  sort_given(given, points.points());
  const std::vector<Candidate> all = candidates(points, images);
  const Cubes near(places_of(all), reach * longest_tangent(points));
  std::vector<SurfaceLink> links;
  std::vector<Vec> both;  // of the links with images: what the places of image and partner add up to
  for (int p = 0; p < points.points(); ++p) {
    const std::vector<Neighbour> own = neighbours_of(all, near, p, frame_of(points, p), reach, {sheet, given});
    Eigen::Matrix<double, terms, terms> normal = Eigen::Matrix<double, terms, terms>::Zero();
    for (const Neighbour& n : own) normal += n.weight * n.phi * n.phi.transpose();
    const Eigen::FullPivLU<Eigen::Matrix<double, terms, terms>> solver(normal);
    if (solver.rank() < terms) {
      throw std::invalid_argument("point " + std::to_string(p) + " of a surface has " + std::to_string(own.size()) +
                                  " neighbours within reach, too few for its tangents: a larger reach, or more points");
    }
    const Eigen::Matrix<double, terms, terms> inverse = solver.inverse();
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (const Neighbour& n : own) {
      const Eigen::Vector2d c = inverse.topRows<2>() * n.phi * (n.weight / reach);  // [Surface 1]
      sum += c;
      links.push_back({p, n.at.point, n.at.image, {}, {c[0], c[1]}});
      for (std::size_t k = 0; k < terms; ++k) links.back().terms[k] = n.phi[static_cast<int>(k)];
      if (n.at.image) both.emplace_back(n.at.place + place_of(points, n.at.point));
    }
    links.push_back({p, p, false, {}, {-sum[0], -sum[1]}});
  }
  if (!outward.empty()) balance_weights(links, points, reach, outward);
  return of_links(links, both, points.points());
}

}  // namespace plumbline
