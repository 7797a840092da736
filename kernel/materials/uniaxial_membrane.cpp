#include "kernel/materials/uniaxial_membrane.hpp"

#include <cmath>

namespace plumbline {
namespace {

const RegisterMaterial entry{
    {"uniaxial_membrane", "one layer of points, tension along the tangent, one-way law", "York 1997, chapter 5"}};
const RegisterMaterial plane_stress_entry{{"plane_stress_membrane",
                                           "the same held out of the plane, with the modulus E / (1 - nu^2)",
                                           "York 1997, (5.12-5.15)"}};

struct Direction {
  double x, y;
};

Direction segment(const double* x, const double* y, int from, int to) {
  const double dx = x[to] - x[from], dy = y[to] - y[from], length = std::sqrt(dx * dx + dy * dy);
  return {dx / length, dy / length};
}

// Unit tangents from the chain. The normalised sum of two unit vectors has the mean of their angles. [York 7.1]
void find_tangents(Columns& points, PointRange range, bool closed) {
  const int n = points.points();
  if (n < 2) return;
  const double *x = points(column::position), *y = points(column::position, 1);
  double *tx = points(column::tangent), *ty = points(column::tangent, 1);
  for (int p = range.first; p < range.last; ++p) {
    const bool first = p == 0 && !closed, last = p == n - 1 && !closed;
    const int before = (p + n - 1) % n, after = (p + 1) % n;
    const Direction a = first ? segment(x, y, p, after) : segment(x, y, before, p);
    const Direction b = last ? a : segment(x, y, p, after);
    const double sx = a.x + b.x, sy = a.y + b.y, length = std::sqrt(sx * sx + sy * sy);
    tx[p] = sx / length;
    ty[p] = sy / length;
  }
}

// t . e . t in the plane; the third strain rate is the engineering shear. [York 5.2]
double tangential_rate(const Columns& points, int p) {
  const double tx = points(column::tangent)[p], ty = points(column::tangent, 1)[p];
  return points(column::strain_rate)[p] * tx * tx + points(column::strain_rate, 1)[p] * ty * ty +
         points(column::strain_rate, 2)[p] * tx * ty;
}

}  // namespace

void UniaxialMembrane::add_columns(Columns& points, int dim) const {
  points.add(column::strain);
  if (dim > 1) points.add(column::tangent, dim);
}

std::vector<const ColumnId*> UniaxialMembrane::internal_variables(const MaterialContext&) const {
  return {&column::strain};
}

std::vector<double> UniaxialMembrane::rates(const Columns& points, const MaterialContext& context) const {
  std::vector<double> rates(static_cast<std::size_t>(points.points()));
  for (int p = 0; p < points.points(); ++p) {
    rates[static_cast<std::size_t>(p)] = context.dim == 1 ? points(column::strain_rate)[p] : tangential_rate(points, p);
  }
  return rates;
}

double UniaxialMembrane::advance(Columns& points, PointRange range, const MaterialContext& context, double dt) const {
  const double* volume = points(column::volume);
  double* strain = points(column::strain);
  double stored = 0;
  for (int p = range.first; p < range.last; ++p) {
    const double before = energy_density(strain[p]);
    strain[p] += dt * (context.dim == 1 ? points(column::strain_rate)[p] : tangential_rate(points, p));  // [York 5.3]
    stored += volume[p] * (energy_density(strain[p]) - before);
  }
  return stored;
}

void UniaxialMembrane::evaluate_stress(Columns& points, PointRange range, const MaterialContext& context) const {
  const double* strain = points(column::strain);
  double* xx = points(column::stress);
  const auto tension = [&](int p) {
    double eps = strain[p];
    if (context.ahead != 0) {
      eps += context.ahead * (context.dim == 1 ? points(column::strain_rate)[p] : tangential_rate(points, p));
    }
    return carries(eps) ? modulus() * eps : 0.0;  // [York 5.5]
  };
  if (context.dim == 1) {
    for (int p = range.first; p < range.last; ++p) xx[p] = tension(p);
    return;
  }
  find_tangents(points, range, closed);
  double *yy = points(column::stress, 1), *xy = points(column::stress, 2);
  const double *tx = points(column::tangent), *ty = points(column::tangent, 1);
  for (int p = range.first; p < range.last; ++p) {
    const double s = tension(p);
    xx[p] = s * tx[p] * tx[p];
    yy[p] = s * ty[p] * ty[p];
    xy[p] = s * tx[p] * ty[p];
  }
}

double UniaxialMembrane::stored_energy(const Columns& points, PointRange range) const {
  const double *volume = points(column::volume), *strain = points(column::strain);
  double stored = 0;
  for (int p = range.first; p < range.last; ++p) stored += volume[p] * energy_density(strain[p]);
  return stored;
}

StepBounds UniaxialMembrane::step_bounds(const Columns& points, PointRange range, int dim) const {
  StepBounds bounds;
  bounds.fastest = std::sqrt(modulus() / density) + fastest_point(points, range, dim);
  return bounds;
}

Material::Fault UniaxialMembrane::first_fault(const Columns& points, PointRange range) const {
  return first_not_finite(points, range, column::strain, "the strain must be finite");
}

}  // namespace plumbline
