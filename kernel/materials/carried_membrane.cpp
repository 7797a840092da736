#include "kernel/materials/carried_membrane.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <stdexcept>

#include "kernel/materials/material_entry.hpp"
#include "kernel/register_part.hpp"

namespace plumbline {
namespace {

using Frame = Eigen::Matrix<double, 3, 2>;

const RegisterPart carried_membrane_entry(material_entry<CarriedMembrane>(
    "a membrane in space whose tangents the velocity gradient carries", "reports/docs/theory/membranes.md",
    {{"youngs_modulus", "Pa", &CarriedMembrane::youngs_modulus},
     {"poissons_ratio", "1", &CarriedMembrane::poissons_ratio},
     {"density", "kg/m^3", &CarriedMembrane::density},
     {"thickness", "m", &CarriedMembrane::thickness},
     {"one_way", &CarriedMembrane::one_way},
     {"neo_hookean", &CarriedMembrane::neo_hookean}},
    {{"speed/strained/space",
      "the gate strains points that stay where they are: of those that move along the stress counts once, not twice",
      0.05, 0.09}}));

Frame tangents_of(const Columns& points, int p) {
  return Frame::NullaryExpr(
      [&](Eigen::Index d, Eigen::Index a) { return points(column::tangents, static_cast<int>(3 * a + d))[p]; });
}

// (grad v) f.
Frame rate_of(const Columns& points, int p, const Frame& f) {
  const Eigen::Matrix3d gradient = Eigen::Matrix3d::NullaryExpr(
      [&](Eigen::Index d, Eigen::Index e) { return points(column::strain_rate, static_cast<int>(3 * d + e))[p]; });
  return gradient * f;
}

SurfaceLaw::Metric metric(const Frame& f) {
  return {f.col(0).squaredNorm(), f.col(0).dot(f.col(1)), f.col(1).squaredNorm()};
}

}  // namespace

void CarriedMembrane::add_columns(Columns& points, int dim) const {
  refuse_what_cannot_work(dim);
  points.add(column::tangents, 6);
}

std::vector<const ColumnId*> CarriedMembrane::internal_variables(const MaterialContext&) const {
  return {&column::tangents};
}

std::vector<double> CarriedMembrane::rates(const Columns& points, const MaterialContext&) const {
  const int n = points.points();
  std::vector<double> all(static_cast<std::size_t>(6 * n));
  for (int p = 0; p < n; ++p) {
    const Frame rate = rate_of(points, p, tangents_of(points, p));
    for (int k = 0; k < 6; ++k) all[static_cast<std::size_t>(k * n + p)] = rate(k % 3, k / 3);
  }
  return all;
}

double CarriedMembrane::advance(Columns& points, PointRange range, const MaterialContext&, double dt) const {
  const double* volume = points(column::volume);
  double stored = 0;
  for (int p = range.first; p < range.last; ++p) {
    const Frame before = tangents_of(points, p), after = before + dt * rate_of(points, p, before);
    for (int k = 0; k < 6; ++k) points(column::tangents, k)[p] = after(k % 3, k / 3);
    stored += volume[p] * (state(metric(after)).energy - state(metric(before)).energy);
  }
  return stored;
}

void CarriedMembrane::evaluate_stress(Columns& points, PointRange range, const MaterialContext& context) const {
  for (int p = range.first; p < range.last; ++p) {
    Frame f = tangents_of(points, p);
    if (context.ahead != 0) f += context.ahead * rate_of(points, p, f);
    const State s = state(metric(f));
    Eigen::Matrix2d pull;
    pull << s.first, s.mixed, s.mixed, s.second;
    const Eigen::Matrix3d sigma = f * pull * f.transpose();  // [Carried 1]
    for (int k = 0; k < 9; ++k) points(column::stress, k)[p] = sigma(k / 3, k % 3);
  }
}

double CarriedMembrane::stored_energy(const Columns& points, PointRange range) const {
  const double* volume = points(column::volume);
  double sum = 0;
  for (int p = range.first; p < range.last; ++p) sum += volume[p] * state(metric_of(points, p)).energy;
  return sum;
}

StepBounds CarriedMembrane::step_bounds(const Columns& points, PointRange range, int dim) const {
  return {.fastest = fastest_wave(points, range.first, range.last) + fastest_point(points, range, dim)};
}

Material::Fault CarriedMembrane::first_fault(const Columns& points, PointRange range) const {
  for (int p = range.first; p < range.last; ++p) {
    const double area = metric_of(points, p).determinant();
    if (!(area > 0)) return {p, column::tangents.name(), area, "the tangents of a membrane point span no area"};
  }
  return {};
}

}  // namespace plumbline
