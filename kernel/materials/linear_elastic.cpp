#include "kernel/materials/linear_elastic.hpp"

#include <algorithm>
#include <cmath>

#include "kernel/materials/material_entry.hpp"
#include "kernel/materials/shared_dilatation.hpp"
#include "kernel/pack.hpp"
#include "kernel/register_part.hpp"

namespace plumbline {
namespace {

// By sqrt(2) |w| |sigma| of a stress without a mean, by less of others.
MaterialEntry::KnownFailure unturned(const std::string& geometry) {
  return {"frame/spin/" + geometry,
          "strains add up in fixed axes, so that a stress stays where its point turns; for small turns", 1.1, 1.45};
}
const RegisterPart linear_elastic_entry(
    material_entry<LinearElastic>("small strains, Hooke's law: line, plane strain or stress, rings, space",
                                  "L. D. Landau, E. M. Lifshitz, Theory of Elasticity, 3rd ed., section 4",
                                  {{"youngs_modulus", "Pa", &LinearElastic::youngs_modulus},
                                   {"poissons_ratio", "1", &LinearElastic::poissons_ratio},
                                   {"density", "kg/m^3", &LinearElastic::density},
                                   {"plane_stress", &LinearElastic::plane_stress}},
                                  {unturned("plane"), unturned("space")}));

// Normal components come first: 1 of 1, 2 of 3, 3 of 4 and of 6.
int normals_of(int components) { return components == 1 ? 1 : components == 3 ? 2 : 3; }

// lambda and mu of the geometry that has so many components.
LameConstants constants_of(const LinearElastic& material, int components) {
  return material.constants(components == 1 ? 1 : components == 6 || components == 4 ? 3 : 2);
}

struct Law {
  int components, normals;
  double mu;
  Bulk<> bulk;

  Law(const LinearElastic& material, const Columns& points)
      : components(points.components(column::stress)),
        normals(normals_of(components)),
        mu(constants_of(material, components).mu),
        bulk(constants_of(material, components), points) {}
  Pack trace(const Pack* strain) const {
    Pack sum = strain[0];
    for (int k = 1; k < normals; ++k) sum += strain[k];
    return sum;
  }
  // Component k of the stress, the first term of normal ones given; shear strains are engineering strains. [Hooke 1]
  Pack stress(const Pack* strain, const Pack& tension, int k) const {
    return k < normals ? tension + 2 * mu * strain[k] : mu * strain[k];
  }
  // W, J/m^3.
  Pack energy(const Pack* strain, const Pack& theta) const {
    Pack sum = bulk.energy(trace(strain), theta);
    for (int k = 0; k < components; ++k) sum += 0.5 * stress(strain, 0.0, k) * strain[k];
    return sum;
  }
};
constexpr int most = 6;

}  // namespace

LameConstants LinearElastic::constants(int dim) const {
  if (dim == 1) return {0, youngs_modulus / 2};
  LameConstants constants = lame_constants(youngs_modulus, poissons_ratio);
  if (dim == 2 && plane_stress) {
    constants.lambda *= 2 * constants.mu / (constants.lambda + 2 * constants.mu);
  }
  return constants;
}

double LinearElastic::wave_speed(int dim) const {
  const LameConstants c = constants(dim);
  return std::sqrt((c.lambda + 2 * c.mu) / density);
}

std::optional<RestState> LinearElastic::rest(int dim) const {
  const LameConstants c = constants(dim);
  return RestState{density, c.lambda + 2 * c.mu};
}

void LinearElastic::add_columns(Columns& points, int) const {
  points.add(column::strain, points.components(column::stress));
}

void LinearElastic::share_dilatation(Columns& points) const {
  const int components = points.components(column::stress);
  if (!hardly_compresses(constants_of(*this, components))) return;
  points.add(column::dilatation);
  for (int k = 0; k < normals_of(components); ++k) {
    for (int p = 0; p < points.points(); ++p) points(column::dilatation)[p] += points(column::strain, k)[p];
  }
}

std::vector<const ColumnId*> LinearElastic::internal_variables(const MaterialContext&) const {
  return {&column::strain};
}

std::vector<double> LinearElastic::rates(const Columns& points, const MaterialContext&) const {
  const auto rate = points.values(column::strain_rate);
  return {rate.begin(), rate.end()};
}

double LinearElastic::advance(Columns& points, PointRange range, const MaterialContext&, double dt) const {
  const Law law(*this, points);
  const double* volume = points(column::volume);
  Pack stored = 0.0;
  for_packs(range.first, range.last, [&](int p, int count) {
    Pack strain[most];
    for (int k = 0; k < law.components; ++k) strain[k] = load(points(column::strain, k) + p);
    const Pack before = law.energy(strain, law.bulk.dilatation(p));
    for (int k = 0; k < law.components; ++k) {
      strain[k] += dt * load(points(column::strain_rate, k) + p);  // [Hooke 1]
      plumbline::store(points(column::strain, k) + p, strain[k], count);
    }
    stored += kept(load(volume + p) * (law.energy(strain, law.bulk.dilatation(p, dt)) - before), count);
  });
  advance_dilatation(points, range.first, range.last, dt);
  return sum(stored);
}

void LinearElastic::evaluate_stress(Columns& points, PointRange range, const MaterialContext& context) const {
  const Law law(*this, points);
  for_packs(range.first, range.last, [&](int p, int count) {
    Pack strain[most];
    for (int k = 0; k < law.components; ++k) {
      strain[k] = load(points(column::strain, k) + p);
      if (context.ahead != 0) strain[k] += context.ahead * load(points(column::strain_rate, k) + p);
    }
    const Pack tension = law.bulk.tension(law.trace(strain), p, context.ahead);
    for (int k = 0; k < law.components; ++k) {
      plumbline::store(points(column::stress, k) + p, law.stress(strain, tension, k), count);
    }
  });
}

double LinearElastic::stored_energy(const Columns& points, PointRange range) const {
  const Law law(*this, points);
  Pack stored = 0.0;
  for_packs(range.first, range.last, [&](int p, int count) {
    Pack strain[most];
    for (int k = 0; k < law.components; ++k) strain[k] = load(points(column::strain, k) + p);
    stored += kept(load(points(column::volume) + p) * law.energy(strain, law.bulk.dilatation(p)), count);
  });
  return sum(stored);
}

StepBounds LinearElastic::step_bounds(const Columns& points, PointRange range, int dim) const {
  const LameConstants c = constants_of(*this, points.components(column::stress));
  StepBounds bounds;
  bounds.fastest = std::sqrt((c.lambda + 2 * c.mu) / density) + fastest_point(points, range, dim);
  return bounds;
}

Material::Fault LinearElastic::first_fault(const Columns& points, PointRange range) const {
  return first_not_finite(points, range, column::strain, "the strain must be finite");
}

}  // namespace plumbline
