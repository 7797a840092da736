#include "kernel/materials/segment_membrane.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "kernel/materials/material_entry.hpp"
#include "kernel/register_part.hpp"

namespace plumbline {
namespace {

const RegisterPart segment_membrane_entry(
    material_entry<SegmentMembrane>("a chain strained by the stretch of its segments, one-way law",
                                    "Lian, Zhang, Liu 2014, doi 10.1007/s10999-014-9241-6",
                                    {{"youngs_modulus", "Pa", &SegmentMembrane::youngs_modulus},
                                     {"density", "kg/m^3", &SegmentMembrane::density},
                                     {"section", "m^2", &SegmentMembrane::section},
                                     {"one_way", &SegmentMembrane::one_way},
                                     {"closed", &SegmentMembrane::closed},
                                     {"revolved", &SegmentMembrane::revolved},
                                     {"poissons_ratio", "1", &SegmentMembrane::poissons_ratio}}));

}  // namespace

// A segment as it will be `ahead` seconds later, if points keep the velocities in the strain_rate column.
struct SegmentMembrane::Band {
  std::array<double, 3> first{}, second{};  // forces on its two points, N
  double strain = 0, hoop_strain = 0, energy = 0;
};

struct SegmentMembrane::Chain {
  int points, dim;
  const double *position[3] = {}, *velocity[3] = {};  // velocity: of the nodes at the points
  const double *rest, *rest_radius;

  explicit Chain(const Columns& of)
      : points(of.points()),
        dim(of.components(column::position)),
        rest(of(column::rest_length)),
        rest_radius(of.has(column::rest_radius) ? of(column::rest_radius) : nullptr) {
    for (int d = 0; d < dim; ++d) {
      position[d] = of(column::position, d);
      velocity[d] = of(column::strain_rate, d);
    }
  }
  int after(int p) const { return p + 1 < points ? p + 1 : 0; }
};

SegmentMembrane::BandState SegmentMembrane::band(double strain, double hoop) const {
  const double nu = poissons_ratio, e = youngs_modulus, stiff = e / (1 - nu * nu);
  const double along = strain + nu * hoop, around = hoop + nu * strain;
  if (along > 0 && around > 0) {
    return {0.5 * stiff * (strain * along + hoop * around), stiff * along, stiff * around};  // [Segments 3]
  }
  if (strain > 0 && around <= 0) return {0.5 * e * strain * strain, e * strain, 0};
  if (hoop > 0 && along <= 0) return {0.5 * e * hoop * hoop, 0, e * hoop};
  return {};
}

auto SegmentMembrane::band_of(const Chain& chain, int p, double ahead) const -> Band {
  const int after = chain.after(p);
  const double rest = chain.rest[p];
  Band b;
  std::array<double, 3> direction{};
  double length = 0, radius = 0;
  for (int d = 0; d < chain.dim; ++d) {
    double from = chain.position[d][p], to = chain.position[d][after];
    if (ahead != 0) {
      from += ahead * chain.velocity[d][p];
      to += ahead * chain.velocity[d][after];
    }
    if (d == 0) radius = 0.5 * (from + to);
    const double edge = to - from;
    direction[static_cast<std::size_t>(d)] = edge;
    length += edge * edge;
  }
  length = std::sqrt(length);
  b.strain = length / rest - 1;  // [Segments 1]
  double pull = tension(b.strain), outward = 0;
  b.energy = 0.5 * rest * pull * b.strain;  // [Segments 1]
  if (revolved) {
    b.hoop_strain = radius / chain.rest_radius[p] - 1;
    const BandState state = band(b.strain, b.hoop_strain);
    b.energy = section * rest * chain.rest_radius[p] * state.energy;
    pull = section * chain.rest_radius[p] * state.along;
    outward = -0.5 * section * rest * state.around;  // half to each end [Segments 3]
  }
  for (std::size_t d = 0; d < 3; ++d) {
    b.first[d] = pull * direction[d] / length;
    b.second[d] = -b.first[d];
  }
  b.first[0] += outward;
  b.second[0] += outward;
  return b;
}

void SegmentMembrane::add_columns(Columns& points, int dim) const {
  points.add(column::strain);
  points.add(column::rest_length);
  points.add(column::segment_force, 2 * dim);
  if (!revolved) return;
  points.add(column::rest_radius);
  points.add(column::hoop_strain);
}

std::vector<const ColumnId*> SegmentMembrane::internal_variables(const MaterialContext&) const {
  if (revolved) return {&column::strain, &column::hoop_strain};
  return {&column::strain};
}

// Stress does not depend on the strain columns, but what is stored does.
std::vector<double> SegmentMembrane::rates(const Columns& points, const MaterialContext&) const {
  const int n = points.points(), dim = points.components(column::position);
  std::vector<double> rates(static_cast<std::size_t>(revolved ? 2 * n : n));
  for (int p = 0; p < n; ++p) {
    if (!has_segment(points, p)) continue;
    const int after = (p + 1) % n;
    double opening = 0, square = 0;
    for (int d = 0; d < dim; ++d) {
      const double *x = points(column::position, d), *v = points(column::strain_rate, d);
      const double edge = x[after] - x[p];
      opening += edge * (v[after] - v[p]);
      square += edge * edge;
    }
    rates[static_cast<std::size_t>(p)] = opening / std::sqrt(square) / points(column::rest_length)[p];
    if (!revolved) continue;
    const double* v = points(column::strain_rate);
    rates[static_cast<std::size_t>(n + p)] = 0.5 * (v[p] + v[after]) / points(column::rest_radius)[p];
  }
  return rates;
}

// What of the stored energy the forces' work does not account for is the segment's own loss, or gain.
double SegmentMembrane::advance(Columns& points, PointRange range, const MaterialContext&, double dt) const {
  const Chain chain(points);
  double* strain = points(column::strain);
  double* hoop_strain = revolved ? points(column::hoop_strain) : nullptr;
  double* loss = points.has(column::transfer_loss) ? points(column::transfer_loss) : nullptr;
  const double* force[6] = {};
  for (int d = 0; d < 2 * chain.dim; ++d) force[d] = points(column::segment_force, d);
  double stored = 0;
  for (int p = range.first; p < range.last; ++p) {
    if (!has_segment(points, p)) continue;
    const double before = energy_of(chain, p, strain[p], revolved ? hoop_strain[p] : 0.0);
    const Band now = band_of(chain, p, 0);
    strain[p] = now.strain;
    if (revolved) hoop_strain[p] = now.hoop_strain;
    stored += now.energy - before;
    if (!loss) continue;
    double work = 0;
    for (int d = 0; d < chain.dim; ++d) {
      work -= dt * (force[d][p] * chain.velocity[d][p] + force[chain.dim + d][p] * chain.velocity[d][chain.after(p)]);
    }
    loss[p] += work - (now.energy - before);  // [Coupling 1]
  }
  return stored;
}

void SegmentMembrane::evaluate_stress(Columns& points, PointRange range, const MaterialContext& context) const {
  const Chain chain(points);
  const int dim = chain.dim, n = chain.points;
  const double* volume = points(column::volume);
  double *stress[3] = {}, *force[6] = {};
  for (int d = 0; d < dim; ++d) stress[d] = points(column::stress, d);
  for (int d = 0; d < 2 * dim; ++d) force[d] = points(column::segment_force, d);
  const auto segment = [&](int p) { return has_segment(points, p) ? band_of(chain, p, context.ahead) : Band{}; };
  Band before = range.first > 0 || closed ? segment(range.first > 0 ? range.first - 1 : n - 1) : Band{};
  for (int p = range.first; p < range.last; ++p) {
    const Band own = segment(p);
    for (int d = 0; d < dim; ++d) {
      const auto k = static_cast<std::size_t>(d);
      force[d][p] = own.first[k];
      force[dim + d][p] = own.second[k];
      stress[d][p] = -(own.first[k] + before.second[k]) / volume[p];  // [Segments 2]
    }
    before = own;
  }
}

double SegmentMembrane::point_forces(const Columns& points, std::vector<double>& forces) const {
  const Chain chain(points);
  const int dim = chain.dim, n = chain.points;
  const double *mass = points(column::mass), *rest = chain.rest, *radius = revolved ? chain.rest_radius : nullptr;
  forces.assign(static_cast<std::size_t>(dim * n), 0.0);
  const double stiff = youngs_modulus / (1 - poissons_ratio * poissons_ratio) * section;
  const auto stiffness_of = [&](int p) {
    const double along = stiff * (radius ? radius[p] : 1.0) / rest[p];
    return radius ? along + stiff * rest[p] / (4 * radius[p]) : along;
  };
  double fastest = 0, stiffness_before = 0;
  Band before;
  if (closed) {
    before = band_of(chain, n - 1, 0);
    stiffness_before = stiffness_of(n - 1);
  }
  for (int p = 0; p < n; ++p) {
    const bool starts = has_segment(points, p);
    const Band own = starts ? band_of(chain, p, 0) : Band{};
    const double stiffness = starts ? stiffness_of(p) : 0.0;
    for (int d = 0; d < dim; ++d) {
      const auto k = static_cast<std::size_t>(d);
      forces[static_cast<std::size_t>(d * n + p)] = own.first[k] + before.second[k];
    }
    fastest = std::max(fastest, 2 * (stiffness + stiffness_before) / mass[p]);  // Gershgorin
    before = own;
    stiffness_before = stiffness;
  }
  return fastest > 0 ? 1 / fastest : 0;
}

void SegmentMembrane::describe(Columns& points) const {
  const Chain chain(points);
  for (int p = 0; p < points.points(); ++p) {
    if (!has_segment(points, p)) continue;
    const Band now = band_of(chain, p, 0);
    points(column::strain)[p] = now.strain;
    if (revolved) points(column::hoop_strain)[p] = now.hoop_strain;
  }
}

double SegmentMembrane::energy_of(const Chain& chain, int p, double strain, double hoop_strain) const {
  return revolved ? section * chain.rest[p] * chain.rest_radius[p] * band(strain, hoop_strain).energy
                  : 0.5 * chain.rest[p] * tension(strain) * strain;  // [Segments 1]
}

double SegmentMembrane::stored_energy(const Columns& points, PointRange range) const {
  const Chain chain(points);
  const double *strain = points(column::strain), *hoop = revolved ? points(column::hoop_strain) : nullptr;
  double stored = 0;
  for (int p = range.first; p < range.last; ++p) {
    if (has_segment(points, p)) stored += energy_of(chain, p, strain[p], hoop ? hoop[p] : 0.0);
  }
  return stored;
}

StepBounds SegmentMembrane::step_bounds(const Columns& points, PointRange range, int dim) const {
  StepBounds bounds;
  const double modulus = revolved ? youngs_modulus / (1 - poissons_ratio * poissons_ratio) : youngs_modulus;
  bounds.fastest = std::sqrt(modulus / density) + fastest_point(points, range, dim);
  return bounds;
}

Material::Fault SegmentMembrane::first_fault(const Columns& points, PointRange range) const {
  const Fault fault = first_not_finite(points, range, column::strain, "the strain must be finite");
  if (fault.point >= 0) return fault;
  const auto positive = [&](const ColumnId& id, const char* reason) -> Fault {
    const double* values = points(id);
    for (int p = range.first; p < range.last; ++p) {
      if (has_segment(points, p) && !(values[p] > 0)) return {p, id.name(), values[p], reason};
    }
    return {};
  };
  const Fault length = positive(column::rest_length, "the rest length of a segment must be positive");
  if (length.point >= 0 || !revolved) return length;
  return positive(column::rest_radius, "the rest radius of a band must be positive");
}

}  // namespace plumbline
