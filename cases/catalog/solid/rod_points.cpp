#include "cases/catalog/solid/rod_points.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "cases/harness/description/measures.hpp"
#include "cases/harness/files/whole.hpp"
#include "kernel/materials/j2_plasticity.hpp"
#include "kernel/materials/shared_dilatation.hpp"
#include "kernel/shapes/domain_columns.hpp"

namespace plumbline {
namespace {

using Matrix = Eigen::Matrix3d;

constexpr double own_share = 0.02;  // of the bulk modulus, where cells share a dilatation [J2 7]

Matrix exponential(const Matrix& symmetric) {
  const Eigen::SelfAdjointEigenSolver<Matrix> principal(symmetric);
  return principal.eigenvectors() * principal.eigenvalues().array().exp().matrix().asDiagonal() *
         principal.eigenvectors().transpose();
}

}  // namespace

Body rod_points(std::shared_ptr<const Material> material, double length, double radius, double spacing,
                double density) {
  const int across = whole(std::round(radius / spacing)), rows = whole(std::round(length / spacing));
  const double up = length / rows;
  Body body = make_body("rod", std::move(material), across * rows, 2, true);
  body.spacing = spacing;
  body.points.add(column::half_edges_at_start, 4);
  for (int p = 0; p < across * rows; ++p) {
    const double r = (p % across + 0.5) * spacing, edges[] = {spacing / 2, 0, 0, up / 2};
    body.points(column::position, 0)[p] = r;
    body.points(column::position, 1)[p] = (p / across + 0.5) * up;
    body.points(column::volume)[p] = spacing * up * r;
    body.points(column::mass)[p] = density * body.points(column::volume)[p];
    for (int k = 0; k < 4; ++k) body.points(column::half_edges_at_start, k)[p] = edges[k];
  }
  return body;
}

Matrix RodPoints::elastic(int p) const {
  const auto e = [&](int k) { return points_(column::elastic_strain, k)[p]; };
  Matrix m;
  m << e(0), e(3), 0, e(3), e(1), 0, 0, 0, e(2);
  return m;
}

Matrix RodPoints::deformation(int p) const {
  const auto f = [&](int k) { return points_(column::deformation, k)[p]; };
  Matrix m;
  m << f(0), f(1), 0, f(2), f(3), 0, 0, 0, f(4);
  return m;
}

double RodPoints::beyond_yield(int p) const {
  const Matrix e = elastic(p);
  const double q = std::sqrt(6.0) * law_.shear * (e - e.trace() / 3 * Matrix::Identity()).norm();
  return (q - law_.yield - law_.hardening * points_(column::plastic_strain)[p]) / law_.yield;
}

double RodPoints::volume_off(int p) const {
  return std::abs(std::log(deformation(p).determinant()) - elastic(p).trace());
}

double RodPoints::axial_stress(int p) const {
  const Matrix e = elastic(p);
  const double kirchhoff = law_.bulk * dilatation(p) - 2.0 / 3 * law_.shear * e.trace() + 2 * law_.shear * e(1, 1);
  return kirchhoff / deformation(p).determinant();
}

double RodPoints::dilatation(int p) const {
  const double own = elastic(p).trace();
  return points_.has(column::dilatation) ? own_share * own + (1 - own_share) * points_(column::mean_dilatation)[p]
                                         : own;
}

double RodPoints::stretch(int p) const { return (exponential(-elastic(p)) * deformation(p).col(1)).norm(); }

double RodPoints::reach(int p, int d) const {
  double sum = 0;
  for (const int k : {0, 1}) {
    double edge = 0;
    for (const int j : {0, 1})
      edge += points_(column::deformation, 2 * d + j)[p] * points_(column::half_edges_at_start, 2 * k + j)[p];
    sum += std::abs(edge);
  }
  return sum;
}

RodShape RodPoints::shape() const {
  RodShape shape;
  for (int p = 0; p < points_.points(); ++p) {
    shape.radius = larger(shape.radius, points_(column::position, 0)[p] + reach(p, 0));
    shape.length = larger(shape.length, points_(column::position, 1)[p] + reach(p, 1));
  }
  return shape;
}

std::vector<RodSlice> RodPoints::slices(double thickness) const {
  std::vector<RodSlice> all;
  std::vector<double> nearest;  // distance from the axis of the point that `axis` is of; infinite where there is none
  for (int p = 0; p < points_.points(); ++p) {
    const double r = points_(column::position, 0)[p], plastic = points_(column::plastic_strain)[p];
    const auto k = static_cast<std::size_t>(std::max(0.0, points_(column::position, 1)[p] / thickness));
    while (all.size() <= k) {
      all.push_back({.height = (static_cast<double>(all.size()) + 0.5) * thickness});
      nearest.push_back(std::numeric_limits<double>::infinity());
    }
    all[k].radius = larger(all[k].radius, r + reach(p, 0));
    all[k].largest = larger(all[k].largest, plastic);
    if (r < nearest[k]) nearest[k] = r, all[k].axis = plastic;
  }
  std::erase_if(all, [](const RodSlice& slice) { return slice.radius == 0; });
  return all;
}

RodSums RodPoints::sums() const {
  RodSums sums;
  for (int p = 0; p < points_.points(); ++p) {
    const double volume = points_(column::mass)[p] / law_.density, plastic = points_(column::plastic_strain)[p];
    const Matrix e = elastic(p);
    const double trace = e.trace(), shape = e.squaredNorm() - trace * trace / 3;
    sums.heat += volume * law_.yield * plastic;
    sums.hardening += 0.5 * volume * law_.hardening * plastic * plastic;
    const double theta = points_.has(column::dilatation) ? points_(column::dilatation)[p] : trace;
    const double squares = own_share * trace * trace + (1 - own_share) * theta * theta;
    sums.elastic += volume * (0.5 * law_.bulk * squares + law_.shear * shape);
  }
  return sums;
}

double RodPoints::shared_off() const {
  if (!points_.has(column::dilatation)) return 0;
  double off = 0, size = 0;
  for (int p = 0; p < points_.points(); ++p) {
    const double own = elastic(p).trace();
    off += points_(column::mass)[p] * (points_(column::dilatation)[p] - own);
    size += points_(column::mass)[p] * std::abs(own);
  }
  return size > 0 ? std::abs(off) / size : 0;
}

double RodPoints::largest_plastic_strain() const {
  const double* plastic = points_(column::plastic_strain);
  return *std::max_element(plastic, plastic + points_.points());
}

double RodPoints::mean_of_lines() const {
  double sum = 0, mass = 0;
  for (int p = 0; p < points_.points(); ++p) {
    sum += points_(column::mass)[p] * stretch(p);
    mass += points_(column::mass)[p];
  }
  return sum / mass;
}

double RodPoints::excess_of_lines() const {
  double excess = -1;
  for (int p = 0; p < points_.points(); ++p)
    excess = larger(excess, std::abs(std::log(stretch(p))) - points_(column::plastic_strain)[p]);
  return excess;
}

double RodPoints::alternation(int across) const {
  std::vector<double> pressure(static_cast<std::size_t>(points_.points()));
  for (int p = 0; p < points_.points(); ++p) {
    const auto number = static_cast<std::size_t>(body_.id[static_cast<std::size_t>(p)]);
    pressure[number] = -law_.bulk * dilatation(p) / deformation(p).determinant();
  }
  const auto row = static_cast<std::size_t>(across);
  double sum = 0, count = 0;
  for (std::size_t k = row; k + row < pressure.size(); ++k) {
    const double kink = (pressure[k - row] - 2 * pressure[k] + pressure[k + row]) / 4;
    sum += kink * kink;
    ++count;
  }
  return std::sqrt(sum / count);
}

}  // namespace plumbline
