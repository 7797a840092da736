#include "kernel/surface_balance.hpp"

#include <Eigen/Dense>
#include <Eigen/IterativeLinearSolvers>
#include <Eigen/Sparse>
#include <stdexcept>

#include "kernel/materials/surface_law.hpp"

namespace plumbline {
namespace {

using Vec = Eigen::Vector3d;
using Rows = Eigen::SparseMatrix<double, Eigen::RowMajor>;

Vec tangent(const Columns& points, int p, int a) {
  return {points(column::tangents, 3 * a)[p], points(column::tangents, 3 * a + 1)[p],
          points(column::tangents, 3 * a + 2)[p]};
}

// Directions of the surface at a point along which nothing may pull: all but out of a free edge.
std::vector<Vec> directions(const Columns& points, int p, const Vec& out) {
  const Vec normal = tangent(points, p, 0).cross(tangent(points, p, 1)).normalized();
  if (out.squaredNorm() > 0) return {normal.cross(out).normalized()};
  const Vec first = tangent(points, p, 0).normalized();
  return {first, normal.cross(first)};
}

// Unknowns are the changes of the weights times the reach, two for each link; rows are conditions, and what they miss now.
struct Conditions {
  std::vector<Eigen::Triplet<double>> entries;
  std::vector<double> missed;
};

// Of each point the six sums of its weights, along both tangents, keep their values.
void keep_sums(const std::vector<SurfaceLink>& links, int points, Conditions& to) {
  for (std::size_t n = 0; n < links.size(); ++n) {
    for (int a = 0; a < 2; ++a) {
      const int row = 6 * (2 * links[n].of + a), unknown = 2 * static_cast<int>(n) + a;
      to.entries.emplace_back(row, unknown, 1.0);
      for (int k = 0; k < 5; ++k) to.entries.emplace_back(row + 1 + k, unknown, links[n].terms[static_cast<std::size_t>(k)]);
    }
  }
  to.missed.assign(static_cast<std::size_t>(12 * points), 0.0);
}

// Of each point the pull in the surface vanishes, over the mean area times the reach.
void end_pulls(const std::vector<SurfaceLink>& links, const Columns& points, double reach,
               const std::vector<std::array<double, 3>>& outward, Conditions& to) {
  const int count = points.points();
  std::vector<std::vector<std::size_t>> on(static_cast<std::size_t>(count));
  for (std::size_t n = 0; n < links.size(); ++n) on[static_cast<std::size_t>(links[n].on)].push_back(n);
  const double* volume = points(column::volume);
  double mean = 0;
  for (int p = 0; p < count; ++p) mean += volume[p] / count;
  for (int k = 0; k < count; ++k) {
    const auto& out = outward[static_cast<std::size_t>(k)];
    for (const Vec& along : directions(points, k, {out[0], out[1], out[2]})) {
      double pull = 0;
      for (const std::size_t n : on[static_cast<std::size_t>(k)]) {
        const SurfaceLink& link = links[n];
        for (int a = 0; a < 2; ++a) {
          const double share = (link.image ? -1 : 1) * volume[link.of] / mean * along.dot(tangent(points, link.of, a));
          to.entries.emplace_back(static_cast<int>(to.missed.size()), 2 * static_cast<int>(n) + a, share);
          pull += share * reach * link.weight[static_cast<std::size_t>(a)];
        }
      }
      to.missed.push_back(-pull);
    }
  }
}

}  // namespace

void balance_weights(std::vector<SurfaceLink>& links, const Columns& points, double reach,
                     const std::vector<std::array<double, 3>>& outward) {
  constexpr double close = 1e-13;  // of what the weights miss
  if (static_cast<int>(outward.size()) != points.points()) {
    throw std::invalid_argument("a surface of " + std::to_string(points.points()) + " points has " +
                                std::to_string(outward.size()) + " directions out of its free edges");
  }
  Conditions all;
  keep_sums(links, points.points(), all);
  end_pulls(links, points, reach, outward, all);
  Rows matrix(static_cast<int>(all.missed.size()), 2 * static_cast<int>(links.size()));
  matrix.setFromTriplets(all.entries.begin(), all.entries.end());
  const Eigen::Map<const Eigen::VectorXd> missed(all.missed.data(), static_cast<int>(all.missed.size()));
  // From no change at all, conjugate gradients end at the least one.
  Eigen::LeastSquaresConjugateGradient<Rows, Eigen::IdentityPreconditioner> solver;
  solver.setTolerance(close);
  solver.setMaxIterations(20000);
  solver.compute(matrix);
  const Eigen::VectorXd change = solver.solve(missed);
  const double left = (matrix * change - missed).norm();
  if (!(left <= 1e-6 * std::sqrt(static_cast<double>(points.points())))) {
    throw std::invalid_argument("no weights of a surface's neighbours let a uniform tension be at rest: " +
                                std::to_string(left) + " is left; a larger reach, or more points");
  }
  for (std::size_t n = 0; n < links.size(); ++n) {
    for (std::size_t a = 0; a < 2; ++a) links[n].weight[a] += change[2 * static_cast<int>(n) + static_cast<int>(a)] / reach;
  }
}

}  // namespace plumbline
