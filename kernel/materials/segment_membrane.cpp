#include "kernel/materials/segment_membrane.hpp"

#include <array>
#include <cmath>

namespace plumbline {
namespace {

const RegisterMaterial entry{{"segment_membrane", "a chain strained by the stretch of its segments, one-way law",
                              "Lian, Zhang, Liu 2014, doi 10.1007/s10999-014-9241-6"}};

struct Segment {
  std::array<double, 3> direction{};  // unit vector from the first to the second point
  double length = 0;
};

// As it will be `ahead` seconds later, if points keep the velocities in the strain_rate column.
Segment segment(const Columns& points, int p, double ahead) {
  const int dim = points.components(column::position), after = (p + 1) % points.points();
  Segment s;
  for (int d = 0; d < dim; ++d) {
    const double *x = points(column::position, d), *v = points(column::strain_rate, d);
    double& edge = s.direction[static_cast<std::size_t>(d)];
    edge = x[after] - x[p];
    if (ahead != 0) edge += ahead * (v[after] - v[p]);
    s.length += edge * edge;
  }
  s.length = std::sqrt(s.length);
  for (double& component : s.direction) component /= s.length;
  return s;
}

double energy_of(const SegmentMembrane& m, const Columns& points, int p) {
  const double strain = points(column::strain)[p];
  return 0.5 * points(column::rest_length)[p] * m.tension(strain) * strain;  // [Segments 1]
}

double strain_of(const Columns& points, int p) {
  return segment(points, p, 0).length / points(column::rest_length)[p] - 1;  // [Segments 1]
}

}  // namespace

void SegmentMembrane::add_columns(Columns& points, int) const {
  points.add(column::strain);
  points.add(column::rest_length);
}

std::vector<const ColumnId*> SegmentMembrane::internal_variables(const MaterialContext&) const {
  return {&column::strain};
}

// Stress does not depend on the strain column, but what is stored does.
std::vector<double> SegmentMembrane::rates(const Columns& points, const MaterialContext&) const {
  const int n = points.points();
  std::vector<double> rates(static_cast<std::size_t>(n));
  for (int p = 0; p < n; ++p) {
    if (!has_segment(points, p)) continue;
    const Segment s = segment(points, p, 0);
    double opening = 0;
    for (int d = 0; d < points.components(column::position); ++d) {
      const double* v = points(column::strain_rate, d);
      opening += s.direction[static_cast<std::size_t>(d)] * (v[(p + 1) % n] - v[p]);
    }
    rates[static_cast<std::size_t>(p)] = opening / points(column::rest_length)[p];
  }
  return rates;
}

double SegmentMembrane::advance(Columns& points, PointRange range, const MaterialContext&, double) const {
  double* strain = points(column::strain);
  double stored = 0;
  for (int p = range.first; p < range.last; ++p) {
    if (!has_segment(points, p)) continue;
    const double before = energy_of(*this, points, p);
    strain[p] = strain_of(points, p);
    stored += energy_of(*this, points, p) - before;
  }
  return stored;
}

void SegmentMembrane::evaluate_stress(Columns& points, PointRange range, const MaterialContext& context) const {
  const int dim = points.components(column::position), n = points.points();
  const double *volume = points(column::volume), *rest = points(column::rest_length);
  for (int p = range.first; p < range.last; ++p) {
    std::array<double, 3> force{};
    for (int side = 0; side < 2; ++side) {
      const int start = side == 0 ? p : (p + n - 1) % n;
      if ((side == 1 && p == 0 && !closed) || !has_segment(points, start)) continue;
      const Segment s = segment(points, start, context.ahead);
      const double pull = (side == 0 ? 1 : -1) * tension(s.length / rest[start] - 1);
      for (std::size_t d = 0; d < 3; ++d) force[d] += pull * s.direction[d];  // [Segments 2]
    }
    for (int d = 0; d < dim; ++d) points(column::stress, d)[p] = -force[static_cast<std::size_t>(d)] / volume[p];
  }
}

void SegmentMembrane::describe(Columns& points) const {
  for (int p = 0; p < points.points(); ++p) {
    if (has_segment(points, p)) points(column::strain)[p] = strain_of(points, p);
  }
}

double SegmentMembrane::stored_energy(const Columns& points, PointRange range) const {
  double stored = 0;
  for (int p = range.first; p < range.last; ++p) {
    if (has_segment(points, p)) stored += energy_of(*this, points, p);
  }
  return stored;
}

StepBounds SegmentMembrane::step_bounds(const Columns& points, PointRange range, int dim) const {
  StepBounds bounds;
  bounds.fastest = std::sqrt(youngs_modulus / density) + fastest_point(points, range, dim);
  return bounds;
}

Material::Fault SegmentMembrane::first_fault(const Columns& points, PointRange range) const {
  const Fault fault = first_not_finite(points, range, column::strain, "the strain must be finite");
  if (fault.point >= 0) return fault;
  for (int p = range.first; p < range.last; ++p) {
    const double rest = points(column::rest_length)[p];
    if (has_segment(points, p) && !(rest > 0)) {
      return {p, column::rest_length.name(), rest, "the rest length of a segment must be positive"};
    }
  }
  return {};
}

}  // namespace plumbline
