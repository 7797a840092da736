#include "kernel/surface_balance.hpp"

#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "kernel/dissection.hpp"
#include "kernel/materials/surface_law.hpp"

namespace plumbline {
namespace {

using Vec = Eigen::Vector3d;

Vec tangent(const Columns& points, int p, int a) {
  return {points(column::tangents, 3 * a)[p], points(column::tangents, 3 * a + 1)[p],
          points(column::tangents, 3 * a + 2)[p]};
}

Vec normal_of(const Columns& points, int p) { return tangent(points, p, 0).cross(tangent(points, p, 1)).normalized(); }

// Directions at a point along which the pull is known: of the surface, where nothing may pull, all but out of a free edge; last the
// normal.
std::vector<Vec> directions(const Columns& points, int p, const Vec& out) {
  const Vec normal = normal_of(points, p);
  if (out.squaredNorm() > 0) return {normal.cross(out).normalized(), normal};
  const Vec first = tangent(points, p, 0).normalized();
  return {first, normal.cross(first), normal};
}

// Of the quadratic surface through a point's neighbours: the sum of its second derivatives along the normal, times the reach squared, m.
double bend(const SurfaceLink* links, int count, const Columns& points) {
  const int p = links[0].of;
  const Vec normal = normal_of(points, p);
  Eigen::MatrixXd terms(count, 5);
  Eigen::VectorXd height(count);
  for (int n = 0; n < count; ++n) {
    for (int k = 0; k < 5; ++k) terms(n, k) = links[n].terms[static_cast<std::size_t>(k)];
    const Vec away = place_of(points, links[n].on) - place_of(points, p);
    height[n] = normal.dot(away);
    if (links[n].image &&
        std::abs(height[n]) > 1e-9 * away.norm()) {  // pulls next to a rim of odd images are not those of the curvature
      throw std::invalid_argument("point " + std::to_string(p) +
                                  " of a curved surface has images: balanced weights are of flat sheets with images");
    }
  }
  const Eigen::VectorXd fit = terms.householderQr().solve(height);
  return fit[2] + fit[4];
}

// Links of each point are one after another: the first, and one past the last.
std::vector<int> first_links(const std::vector<SurfaceLink>& links, int points) {
  std::vector<int> first(static_cast<std::size_t>(points) + 1, 0);
  for (std::size_t n = 0; n < links.size(); ++n)
    first[static_cast<std::size_t>(links[n].of) + 1] = static_cast<int>(n) + 1;
  return first;
}

// A condition for each direction in which the pull at a point is known.
struct Pulls {
  std::vector<std::vector<Vec>> along;  // of each point
  std::vector<int> first;               // row of its first direction
  Pulls(const Columns& points, const std::vector<std::array<double, 3>>& outward) : first{0} {
    for (int p = 0; p < points.points(); ++p) {
      const auto& out = outward[static_cast<std::size_t>(p)];
      along.push_back(directions(points, p, {out[0], out[1], out[2]}));
      first.push_back(first.back() + static_cast<int>(along.back().size()));
    }
  }
  int rows() const { return first.back(); }
  int normal_row(int p) const { return first[static_cast<std::size_t>(p) + 1] - 1; }
  std::vector<Vec> places(const Columns& points) const {
    std::vector<Vec> all;
    for (int p = 0; p < points.points(); ++p)
      all.insert(all.end(), along[static_cast<std::size_t>(p)].size(), place_of(points, p));
    return all;
  }
};

// What the weights of point p may be changed by, as a projection: the six sums of its links stay.
Eigen::MatrixXd free_changes(const SurfaceLink* links, int count) {
  Eigen::MatrixXd sums(count, 6);
  for (int n = 0; n < count; ++n) {
    sums(n, 0) = 1;
    for (int k = 0; k < 5; ++k) sums(n, 1 + k) = links[n].terms[static_cast<std::size_t>(k)];
  }
  const Eigen::MatrixXd basis = sums.householderQr().householderQ() * Eigen::MatrixXd::Identity(count, 6);
  return Eigen::MatrixXd::Identity(count, count) - basis * basis.transpose();
}

// Of the links of a point, what their weights add to each condition, over the mean volume: rows, and a factor for each tangent.
struct Shares {
  std::vector<int> row, link;
  std::vector<std::array<double, 2>> factor;
};
Shares shares_of(const SurfaceLink* links, int count, const Columns& points, double mean, const Pulls& pulls) {
  Shares all;
  for (int n = 0; n < count; ++n) {
    const auto on = static_cast<std::size_t>(links[n].on);
    const double share = (links[n].image ? -1 : 1) * points(column::volume)[links[n].of] / mean;
    const Vec first = tangent(points, links[n].of, 0), second = tangent(points, links[n].of, 1);
    for (std::size_t d = 0; d < pulls.along[on].size(); ++d) {
      const Vec& along = pulls.along[on][d];
      all.row.push_back(pulls.first[on] + static_cast<int>(d));
      all.link.push_back(n);
      all.factor.push_back({share * along.dot(first), share * along.dot(second)});
    }
  }
  return all;
}

// The links of a point, how they may change, and what they add to which conditions.
struct PointLinks {
  SurfaceLink* own;
  Eigen::MatrixXd free;
  Shares shares;
  double coupling(std::size_t i, std::size_t j) const {
    const auto &one = shares.factor[i], &other = shares.factor[j];
    return free(shares.link[i], shares.link[j]) * (one[0] * other[0] + one[1] * other[1]);
  }
};

// The conditions on free changes times themselves, and `slack` on the diagonal of normals. Column by column: of all pairs of links of
// all points there are some ten times as many as entries.
Eigen::SparseMatrix<double> square_of(const std::vector<PointLinks>& all, const Pulls& pulls, double slack) {
  struct Use {
    int point;
    std::size_t share;
  };
  const auto rows = static_cast<std::size_t>(pulls.rows());
  std::vector<std::vector<Use>> uses(rows);
  for (std::size_t p = 0; p < all.size(); ++p) {
    for (std::size_t i = 0; i < all[p].shares.row.size(); ++i)
      uses[static_cast<std::size_t>(all[p].shares.row[i])].push_back({static_cast<int>(p), i});
  }
  Eigen::SparseMatrix<double> matrix(pulls.rows(), pulls.rows());
  std::vector<double> sum(rows);
  std::vector<bool> met(rows);
  std::vector<int> entries;
  for (int column = 0; column < pulls.rows(); ++column) {
    entries.clear();
    for (const Use& use : uses[static_cast<std::size_t>(column)]) {
      const PointLinks& links = all[static_cast<std::size_t>(use.point)];
      for (std::size_t i = 0; i < links.shares.row.size(); ++i) {
        const auto row = static_cast<std::size_t>(links.shares.row[i]);
        if (!met[row]) {
          met[row] = true;
          sum[row] = 0;
          entries.push_back(links.shares.row[i]);
        }
        if (links.shares.row[i] == column && pulls.normal_row(use.point) == column) sum[row] += slack;
        sum[row] += links.coupling(i, use.share);
      }
    }
    std::sort(entries.begin(), entries.end());
    matrix.startVec(column);
    for (const int row : entries) {
      matrix.insertBack(row, column) = sum[static_cast<std::size_t>(row)];
      met[static_cast<std::size_t>(row)] = false;
    }
  }
  matrix.finalize();
  return matrix;
}

// y of matrix y = missed. Throws where there is none.
Eigen::VectorXd factors_of(const Eigen::SparseMatrix<double>& matrix, const Eigen::VectorXd& missed,
                           const std::vector<Vec>& places, int points) {
  constexpr int sweeps = 8;
  // Conditions depend on each other where all of a sheet is at rest: a little on the diagonal, and what it takes given back.
  Eigen::SparseMatrix<double> regular = matrix;
  for (int row = 0; row < static_cast<int>(missed.size()); ++row) regular.coeffRef(row, row) += 1e-12;
  const DissectedCholesky solver(regular, places);
  Eigen::VectorXd y = Eigen::VectorXd::Zero(static_cast<int>(missed.size()));
  for (int sweep = 0; sweep < sweeps; ++sweep) y += solver.solve(missed - matrix * y);
  const double left = (matrix * y - missed).norm() / std::sqrt(static_cast<double>(points));
  if (!(left <= 1e-9)) {
    throw std::invalid_argument("no weights of a surface's neighbours let a uniform tension be at rest: " +
                                std::to_string(left) + " of the pull of a point is left");
  }
  return y;
}

}  // namespace

void balance_weights(std::vector<SurfaceLink>& links, const Columns& points, double reach,
                     const std::vector<std::array<double, 3>>& outward) {
  if (static_cast<int>(outward.size()) != points.points()) {
    throw std::invalid_argument("a surface of " + std::to_string(points.points()) + " points has " +
                                std::to_string(outward.size()) + " directions out of its free edges");
  }
  // The least change is Q^T y, Q the conditions on free changes alone; then Q Q^T y is what was missed. Curvatures are fitted and do not
  // agree with the work of a uniform tension in a motion of the whole, which no weights change: along the normal y times `slack` is left.
  constexpr double slack = 1e-6;  // the conditions' own factors are of the order of 1
  const int count = points.points();
  const std::vector<int> first = first_links(links, count);
  const Pulls pulls(points, outward);
  double mean = 0;
  for (int p = 0; p < count; ++p) mean += points(column::volume)[p] / count;
  Eigen::VectorXd missed = Eigen::VectorXd::Zero(pulls.rows());
  std::vector<PointLinks> all;
  for (int p = 0; p < count; ++p) {
    const int from = first[static_cast<std::size_t>(p)], n = first[static_cast<std::size_t>(p) + 1] - from;
    SurfaceLink* own = &links[static_cast<std::size_t>(from)];
    all.push_back({own, free_changes(own, n), shares_of(own, n, points, mean, pulls)});
    missed[pulls.normal_row(p)] -= points(column::volume)[p] / mean * bend(own, n, points) / reach;
    const Shares& shares = all.back().shares;
    for (std::size_t i = 0; i < shares.row.size(); ++i) {
      const auto& [first_i, second_i] = shares.factor[i];
      const auto& [along, across] = own[shares.link[i]].weight;
      missed[shares.row[i]] -= reach * (first_i * along + second_i * across);
    }
  }
  const Eigen::VectorXd y = factors_of(square_of(all, pulls, slack), missed, pulls.places(points), count);
  for (const auto& [own, free, shares] : all) {
    for (std::size_t a = 0; a < 2; ++a) {
      Eigen::VectorXd wanted = Eigen::VectorXd::Zero(free.rows());
      for (std::size_t i = 0; i < shares.row.size(); ++i)
        wanted[shares.link[i]] += shares.factor[i][a] * y[shares.row[i]];
      const Eigen::VectorXd change = free * (free * wanted) / reach;  // twice: rounding of large factors would stay
      double sum = 0;
      for (int n = 0; n < change.size(); ++n) sum += own[n].weight[a] += change[n];
      own[change.size() - 1].weight[a] -= sum;  // the point's own, so that momentum is exact
    }
  }
}

}  // namespace plumbline
