#include "cases/harness/parts/material_probe.hpp"

#include <cmath>
#include <utility>

#include "kernel/materials/surface_law.hpp"  // the column tangents

namespace plumbline {
namespace {

constexpr int material_points = 7;  // no whole pack

// Where the shear of directions d and e stands behind the normal components.
int shear_at(int dim, int d, int e) { return dim == 2 ? 0 : 3 - d - e; }

}  // namespace

MaterialProbe::MaterialProbe(std::shared_ptr<const Material> material, std::size_t geometry, double density)
    : material_(std::move(material)),
      geometry_(geometry) {
  context_.dim = geometry == 0 ? 1 : geometry == 3 ? 3 : 2;
  context_.continuity_density = true;  // densities follow the strain, point by point
  context_.tangents_given = true;
  body_ = make_body("points", material_, material_points, dim(), rings());
  for (int p = 0; p < count(); ++p) {
    points()(column::volume)[p] = 0.3 + 0.1 * p;
    points()(column::mass)[p] = density * points()(column::volume)[p];
    for (int d = 0; d < dim(); ++d) points()(column::position, d)[p] = 1.0 + p + 0.3 * d * p;
    if (points().has(column::density)) points()(column::density)[p] = density;
    if (points().has(column::energy)) points()(column::energy)[p] = 1 + 0.2 * p;
    for (int d = 0; points().has(column::tangent) && d < dim(); ++d) {
      points()(column::tangent, d)[p] = d == 0 ? std::cos(p) : d == 1 ? std::sin(p) : 0;
    }
    if (points().has(column::tangents)) {  // two that are orthonormal
      const double first[] = {std::cos(p), std::sin(p), 0}, second[] = {0, 0, 1};
      for (int d = 0; d < 3; ++d) {
        points()(column::tangents, d)[p] = first[d];
        points()(column::tangents, 3 + d)[p] = second[d];
      }
    }
  }
  evaluate();
}

void MaterialProbe::set_no_rate() {
  for (double& rate : points().values(column::strain_rate)) rate = 0;
}

void MaterialProbe::set_rate(const Straining& rate) {
  set_no_rate();
  const Eigen::MatrixXd& l = rate.gradient;
  const StressMeasure measure = material_->measure();
  const int normals = normal_components(dim(), rings());
  for (int p = 0; p < count(); ++p) {
    const auto set = [&](int k, double value) { points()(column::strain_rate, k)[p] = value; };
    if (measure == StressMeasure::pressure) {
      set(0, l.trace() + rate.hoop);
    } else if (measure == StressMeasure::full) {
      for (int k = 0; k < dim() * dim(); ++k) set(k, l(k / dim(), k % dim()));
      if (rings()) set(dim() * dim(), rate.hoop);
    } else {
      for (int d = 0; d < dim(); ++d) set(d, l(d, d));
      if (rings()) set(2, rate.hoop);
      for (int d = 0; d < dim(); ++d) {
        for (int e = d + 1; e < dim(); ++e) set(normals + shear_at(dim(), d, e), l(d, e) + l(e, d));
      }
    }
  }
}

// A line of the material turns with it.
void MaterialProbe::turn_tangents(const Eigen::MatrixXd& gradient, double dt) {
  if (!points().has(column::tangent)) return;
  for (int p = 0; p < count(); ++p) {
    Eigen::VectorXd t(dim());
    for (int d = 0; d < dim(); ++d) t[d] = points()(column::tangent, d)[p];
    t = (t + dt * (gradient * t)).normalized().eval();
    for (int d = 0; d < dim(); ++d) points()(column::tangent, d)[p] = t[d];
  }
}

MaterialProbe MaterialProbe::strained(const Straining& rate, double dt) const {
  MaterialProbe after = *this;
  after.set_rate(rate);
  after.material_->advance(after.points(), all_points(after.points()), context_, dt);
  after.turn_tangents(rate.gradient, dt);
  after.set_no_rate();
  after.evaluate();
  return after;
}

Straining MaterialProbe::random_rate(ProbeRandom& random) const {
  return {Eigen::MatrixXd::NullaryExpr(dim(), dim(), [&] { return random(-1, 1); }), rings() ? random(-1, 1) : 0};
}

void MaterialProbe::strain_at_random(double strain, ProbeRandom& random) {
  constexpr int steps = 20;
  const Straining rate = random_rate(random);
  for (int k = 0; k < steps; ++k) *this = strained(rate, strain / steps);
}

Eigen::MatrixXd MaterialProbe::stress(int p) const {
  const auto at = [&](int k) { return points()(column::stress, k)[p]; };
  const StressMeasure measure = material_->measure();
  if (measure == StressMeasure::pressure) return at(0) * Eigen::MatrixXd::Identity(dim(), dim());
  Eigen::MatrixXd sigma(dim(), dim());
  const int normals = normal_components(dim(), rings());
  for (int d = 0; d < dim(); ++d) {
    for (int e = 0; e < dim(); ++e) {
      sigma(d, e) = measure == StressMeasure::full ? at(d * dim() + e)
                    : d == e                       ? at(d)
                                                   : at(normals + shear_at(dim(), d, e));
    }
  }
  return sigma;
}

double MaterialProbe::hoop_stress(int p) const {
  if (!rings()) return 0;
  const StressMeasure measure = material_->measure();
  return points()(column::stress, measure == StressMeasure::pressure ? 0 : measure == StressMeasure::full ? 4 : 2)[p];
}

double MaterialProbe::power(const Straining& rate, int p) const {
  return volume(p) * (stress(p).cwiseProduct(rate.gradient).sum() + hoop_stress(p) * rate.hoop);
}

}  // namespace plumbline
