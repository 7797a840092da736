#include "kernel/materials/uniaxial_membrane.hpp"

#include <cmath>

#include "kernel/materials/material_entry.hpp"
#include "kernel/normals/connectivity.hpp"
#include "kernel/register_part.hpp"

namespace plumbline {
namespace {

const RegisterPart uniaxial_membrane_entry(material_entry<UniaxialMembrane>(
    "one layer of points, tension along the tangent, one-way law", "York 1997, chapter 5",
    {{"youngs_modulus", "Pa", &UniaxialMembrane::youngs_modulus},
     {"density", "kg/m^3", &UniaxialMembrane::density},
     {"one_way", &UniaxialMembrane::one_way},
     {"closed", &UniaxialMembrane::closed}}));
const RegisterPart plane_stress_entry(material_entry<PlaneStressMembrane>(
    "the same held out of the plane, with the modulus E / (1 - nu^2)", "York 1997, (5.12-5.15)",
    {{"youngs_modulus", "Pa", &PlaneStressMembrane::youngs_modulus},
     {"poissons_ratio", "1", &PlaneStressMembrane::poissons_ratio},
     {"density", "kg/m^3", &PlaneStressMembrane::density},
     {"one_way", &PlaneStressMembrane::one_way},
     {"closed", &PlaneStressMembrane::closed}}));

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

// What of the stored energy the stress's work does not account for is the point's own loss, or gain.
double UniaxialMembrane::advance(Columns& points, PointRange range, const MaterialContext& context, double dt) const {
  const double* volume = points(column::volume);
  const int strains = context.dim == 1 ? 1 : 3;
  const double *rate[3], *stress[3];
  for (int k = 0; k < strains; ++k) {
    rate[k] = points(column::strain_rate, k);
    stress[k] = points(column::stress, k);
  }
  double* strain = points(column::strain);
  double* loss = points.has(column::transfer_loss) ? points(column::transfer_loss) : nullptr;
  double stored = 0;
  for (int p = range.first; p < range.last; ++p) {
    const double before = energy_density(strain[p]);
    strain[p] += dt * (context.dim == 1 ? rate[0][p] : tangential_rate(points, p));  // [York 5.3]
    const double gained = volume[p] * (energy_density(strain[p]) - before);
    stored += gained;
    if (!loss) continue;
    double power = 0;
    for (int k = 0; k < strains; ++k) power += stress[k][p] * rate[k][p];
    loss[p] += dt * volume[p] * power - gained;  // [Coupling 1]
  }
  return stored;
}

double UniaxialMembrane::set_strain(Columns& points, const std::vector<double>& strain) const {
  const double* volume = points(column::volume);
  double* own = points(column::strain);
  double* loss = points.has(column::transfer_loss) ? points(column::transfer_loss) : nullptr;
  double stored = 0;
  for (int p = 0; p < points.points(); ++p) {
    const double before = energy_density(own[p]);
    own[p] = strain[static_cast<std::size_t>(p)];
    const double gained = volume[p] * (energy_density(own[p]) - before);
    stored += gained;
    if (loss) loss[p] -= gained;  // [Coupling 1]
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
  if (!context.tangents_given) {
    chain_tangents(points(column::position), points(column::position, 1), points.points(), range.first, range.last,
                   closed, points(column::tangent), points(column::tangent, 1));
  }
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
