#include "kernel/normals/surface_fit.hpp"

#include <Eigen/Dense>
#include <optional>
#include <stdexcept>
#include <string>

#include "kernel/points/cubes.hpp"

namespace plumbline {
namespace {

using Vec = Eigen::Vector3d;

// A point and what is near it, relative to it and over the reach.
struct Patch {
  std::vector<Vec> place;
  std::vector<double> weight;

  Vec mean() const {
    Vec sum = Vec::Zero();
    double whole = 0;
    for (std::size_t k = 0; k < place.size(); ++k) {
      sum += weight[k] * place[k];
      whole += weight[k];
    }
    return sum / whole;
  }
};

Patch near_point(const Cubes& all, const Vec& x, double reach) {
  Patch patch;
  all.for_near(x, [&](std::size_t k) {
    const Vec off = (all.place(k) - x) / reach;
    const double square = off.squaredNorm();
    if (square >= 1) return;
    patch.place.push_back(off);
    patch.weight.push_back((1 - square) * (1 - square));
  });
  return patch;
}

// Of eigenvalues and pivots of a patch of size one: what is less is none.
constexpr double least_share = 1e-12;

// Axes of the plane, its normal the first; none where the points are on a line. [Surface 15]
std::optional<Eigen::Matrix3d> plane(const Patch& patch) {
  const Vec mean = patch.mean();
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (std::size_t k = 0; k < patch.place.size(); ++k) {
    const Vec off = patch.place[k] - mean;
    spread += patch.weight[k] * off * off.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread);
  if (!(axes.eigenvalues()[1] > least_share * axes.eigenvalues()[2])) return std::nullopt;
  return axes.eigenvectors();
}

// None where the points do not determine a quadratic. [Surface 16]
std::optional<Vec> tilted(const Patch& patch, const Eigen::Matrix3d& axes) {
  constexpr int terms = 6;
  Eigen::Matrix<double, terms, terms> normal = Eigen::Matrix<double, terms, terms>::Zero();
  Eigen::Matrix<double, terms, 1> right = Eigen::Matrix<double, terms, 1>::Zero();
  for (std::size_t k = 0; k < patch.place.size(); ++k) {
    const Vec local = axes.transpose() * patch.place[k];
    const double u = local[1], v = local[2];
    Eigen::Matrix<double, terms, 1> phi;
    phi << 1, u, v, u * u, u * v, v * v;
    normal += patch.weight[k] * phi * phi.transpose();
    right += patch.weight[k] * local[0] * phi;
  }
  const auto solver = normal.ldlt();
  if (!(solver.vectorD().minCoeff() > least_share * solver.vectorD().maxCoeff())) return std::nullopt;
  const Eigen::Matrix<double, terms, 1> fit = solver.solve(right);
  return (axes.col(0) - fit[1] * axes.col(1) - fit[2] * axes.col(2)).normalized();
}

std::optional<Vec> normal_of(const Patch& patch, SurfaceFit fit) {
  const std::optional<Eigen::Matrix3d> axes = plane(patch);
  if (!axes) return std::nullopt;
  return fit == SurfaceFit::plane ? Vec(axes->col(0)) : tilted(patch, *axes);
}

}  // namespace

std::vector<Vec> fitted_normals(const std::vector<Vec>& points, double reach, SurfaceFit fit) {
  if (!(reach > 0))
    throw std::invalid_argument("the reach of a fit is " + std::to_string(reach) + " m; it must be > 0");
  const Cubes all(points, reach);
  std::vector<Vec> normals;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const Patch patch = near_point(all, points[p], reach);
    const std::optional<Vec> normal = normal_of(patch, fit);
    if (!normal) {
      throw std::invalid_argument("point " + std::to_string(p) + " of a surface has " +
                                  std::to_string(patch.place.size()) +
                                  " points within reach, itself among them, which determine no fit: a larger reach, or "
                                  "more points");
    }
    normals.push_back(*normal);
  }
  return normals;
}

}  // namespace plumbline
