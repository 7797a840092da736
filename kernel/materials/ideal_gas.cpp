#include "kernel/materials/ideal_gas.hpp"

#include <array>
#include <cmath>

#include "kernel/geometry.hpp"
#include "kernel/summation.hpp"

namespace plumbline {
namespace {

const RegisterMaterial entry{
    {"ideal_gas", "ideal gas with energy equation, viscosity and artificial viscosity", "York 1997, chapter 4"}};

// The stress of one point, as written in the header. `rate`: strain rates of the point; p: its pressure.
template <class Geometry>
typename Geometry::Strain gas_stress(const IdealGas& gas, const typename Geometry::Strain& rate, double rho, double e,
                                     double p, double h) {
  double divergence = 0;
  for (int k = 0; k < Geometry::normals; ++k) divergence += rate[k];
  double q = 0;
  if (divergence < 0 && (gas.viscosity_linear > 0 || gas.viscosity_quadratic > 0)) {
    const double c = std::sqrt(gas.gamma * (gas.gamma - 1) * e);
    const double closing = -divergence * h;
    q = rho * closing * (gas.viscosity_linear * c + gas.viscosity_quadratic * closing);  // [York 4.11]
  }
  const double mu = gas.viscosity;
  typename Geometry::Strain stress;
  for (int k = 0; k < Geometry::normals; ++k) {
    stress[k] = 2 * mu * rate[k] - 2.0 / 3.0 * mu * divergence - p - q;  // [York 4.1]
  }
  for (int k = Geometry::normals; k < Geometry::strains; ++k) stress[k] = mu * rate[k];
  return stress;
}

template <class Geometry>
struct View {
  template <class C>
  static auto components(C& points, const ColumnId& id) {
    std::array<decltype(points(id)), Geometry::strains> all;
    for (int k = 0; k < Geometry::strains; ++k) all[static_cast<std::size_t>(k)] = points(id, k);
    return all;
  }
};

template <class Geometry, class Array>
typename Geometry::Strain at(const Array& columns, int p) {
  typename Geometry::Strain value;
  for (int k = 0; k < Geometry::strains; ++k) value[k] = columns[static_cast<std::size_t>(k)][p];
  return value;
}

template <class Geometry>
typename Geometry::Strain viscous_part(const typename Geometry::Strain& stress, double p) {
  auto viscous = stress;
  for (int k = 0; k < Geometry::normals; ++k) viscous[k] += p;
  return viscous;
}

template <class Geometry>
double advance_gas(Columns& points, const MaterialContext& context, double dt) {
  const auto rate = View<Geometry>::components(points, column::strain_rate);
  const auto stress = View<Geometry>::components(points, column::stress);
  const double *volume = points(column::volume), *mass = points(column::mass);
  double *energy = points(column::energy), *density = points(column::density);
  return block_sum<double>(points.points(), [&](int p) {
    const auto d = at<Geometry>(rate, p);
    const double heat = dt * volume[p] * at<Geometry>(stress, p).dot(d);
    energy[p] += heat / mass[p];  // [York 4.8]
    if (context.continuity_density) {
      double divergence = 0;
      for (int k = 0; k < Geometry::normals; ++k) divergence += d[k];
      density[p] /= 1 + dt * divergence;  // [York 4.7]
    }
    return heat;
  });
}

template <class Geometry>
std::vector<double> gas_rates(const Columns& points, bool continuity) {
  const auto rate = View<Geometry>::components(points, column::strain_rate);
  const auto stress = View<Geometry>::components(points, column::stress);
  const double *volume = points(column::volume), *mass = points(column::mass), *density = points(column::density);
  std::vector<double> rates;
  for (int p = 0; p < points.points(); ++p) {
    rates.push_back(volume[p] / mass[p] * at<Geometry>(stress, p).dot(at<Geometry>(rate, p)));  // [York 4.8]
  }
  for (int p = 0; continuity && p < points.points(); ++p) {
    double divergence = 0;
    for (int k = 0; k < Geometry::normals; ++k) divergence += rate[static_cast<std::size_t>(k)][p];
    rates.push_back(-density[p] * divergence);
  }
  return rates;
}

template <class Geometry>
void evaluate_gas(const IdealGas& gas, Columns& points, double h) {
  const auto rate = View<Geometry>::components(points, column::strain_rate);
  const auto stress = View<Geometry>::components(points, column::stress);
  const double *mass = points(column::mass), *energy = points(column::energy), *density = points(column::density);
  double *volume = points(column::volume), *pressure = points(column::pressure);
  for (int p = 0; p < points.points(); ++p) {
    volume[p] = mass[p] / density[p];
    pressure[p] = (gas.gamma - 1) * density[p] * energy[p];  // [York 4.4]
    const auto s = gas_stress<Geometry>(gas, at<Geometry>(rate, p), density[p], energy[p], pressure[p], h);
    for (int k = 0; k < Geometry::strains; ++k) stress[static_cast<std::size_t>(k)][p] = s[k];
  }
}

template <class Geometry>
bool reverse_gas_cooling(const IdealGas& gas, Columns& points, double h) {
  const auto rate = View<Geometry>::components(points, column::strain_rate);
  const auto stress = View<Geometry>::components(points, column::stress);
  const double *energy = points(column::energy), *density = points(column::density);
  const double* pressure = points(column::pressure);
  bool changed = false;
  for (int p = 0; p < points.points(); ++p) {
    const auto d = at<Geometry>(rate, p);
    if (viscous_part<Geometry>(at<Geometry>(stress, p), pressure[p]).dot(d) >= 0) continue;
    const auto s = gas_stress<Geometry>(gas, d, density[p], energy[p], pressure[p], h);
    for (int k = 0; k < Geometry::strains; ++k) stress[static_cast<std::size_t>(k)][p] = s[k];
    changed = true;
  }
  return changed;
}

template <class Geometry>
double viscous_gas_heat(const Columns& points, double dt) {
  const auto rate = View<Geometry>::components(points, column::strain_rate);
  const auto stress = View<Geometry>::components(points, column::stress);
  const double *volume = points(column::volume), *pressure = points(column::pressure);
  return block_sum<double>(points.points(), [&](int p) {
    return dt * volume[p] * viscous_part<Geometry>(at<Geometry>(stress, p), pressure[p]).dot(at<Geometry>(rate, p));
  });
}

}  // namespace

void IdealGas::add_columns(Columns& points, int) const {
  points.add(column::density);
  points.add(column::energy);
  points.add(column::pressure);
}

double IdealGas::advance(Columns& points, const MaterialContext& context, double dt) const {
  return context.dim == 1 ? advance_gas<Line>(points, context, dt) : advance_gas<Plane>(points, context, dt);
}

std::vector<const ColumnId*> IdealGas::internal_variables(const MaterialContext& context) const {
  if (context.continuity_density) return {&column::energy, &column::density};
  return {&column::energy};
}

std::vector<double> IdealGas::rates(const Columns& points, const MaterialContext& context) const {
  return context.dim == 1 ? gas_rates<Line>(points, context.continuity_density)
                          : gas_rates<Plane>(points, context.continuity_density);
}

void IdealGas::evaluate_stress(Columns& points, const MaterialContext& context) const {
  context.dim == 1 ? evaluate_gas<Line>(*this, points, context.h) : evaluate_gas<Plane>(*this, points, context.h);
}

bool IdealGas::reverse_cooling(Columns& points, const MaterialContext& context) const {
  if (viscosity == 0 && viscosity_linear == 0 && viscosity_quadratic == 0) return false;
  return context.dim == 1 ? reverse_gas_cooling<Line>(*this, points, context.h)
                          : reverse_gas_cooling<Plane>(*this, points, context.h);
}

double IdealGas::viscous_heat(const Columns& points, const MaterialContext& context, double dt) const {
  return context.dim == 1 ? viscous_gas_heat<Line>(points, dt) : viscous_gas_heat<Plane>(points, dt);
}

void IdealGas::add_heat(Columns& points, const double* heat) const {
  const double* mass = points(column::mass);
  double* energy = points(column::energy);
  for (int p = 0; p < points.points(); ++p) energy[p] += heat[p] / mass[p];  // [EC-APIC 6]
}

double IdealGas::stored_energy(const Columns& points) const {
  const double *mass = points(column::mass), *energy = points(column::energy);
  return block_sum<double>(points.points(), [&](int p) { return mass[p] * energy[p]; });
}

StepBounds IdealGas::step_bounds(const Columns& points, int dim) const {
  const double *energy = points(column::energy), *density = points(column::density);
  const double *u = points(column::velocity), *v = points(column::velocity, dim - 1);
  StepBounds bounds;
  double least_density = HUGE_VAL;
  for (int p = 0; p < points.points(); ++p) {
    const double speed = dim == 1 ? std::abs(u[p]) : std::sqrt(u[p] * u[p] + v[p] * v[p]);
    const double signal = std::sqrt(gamma * (gamma - 1) * energy[p]) + speed;
    if (!std::isnan(bounds.fastest) && !(signal <= bounds.fastest)) bounds.fastest = signal;
    if (density[p] < least_density) least_density = density[p];
  }
  bounds.diffusivity = 4.0 / 3.0 * viscosity / least_density;
  return bounds;
}

Material::Fault IdealGas::first_fault(const Columns& points) const {
  const double *energy = points(column::energy), *density = points(column::density);
  for (int p = 0; p < points.points(); ++p) {
    if (!(density[p] > 0 && std::isfinite(density[p]))) {
      return {p, column::density.name(), density[p], "the density must be positive and finite"};
    }
    if (!(energy[p] >= 0 && std::isfinite(energy[p]))) {
      return {p, column::energy.name(), energy[p], "the specific internal energy must be finite and not negative"};
    }
  }
  return {};
}

}  // namespace plumbline
