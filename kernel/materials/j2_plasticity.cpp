#include "kernel/materials/j2_plasticity.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "kernel/materials/material_entry.hpp"
#include "kernel/materials/shared_dilatation.hpp"
#include "kernel/register_part.hpp"

namespace plumbline {
namespace {

using Matrix = Eigen::Matrix3d;

const RegisterPart j2_plasticity_entry(
    material_entry<J2Plasticity>("finite strains, von Mises plasticity with linear isotropic hardening",
                                 "Simo 1992, doi 10.1016/0045-7825(92)90123-2",
                                 {{"youngs_modulus", "Pa", &J2Plasticity::youngs_modulus},
                                  {"poissons_ratio", "1", &J2Plasticity::poissons_ratio},
                                  {"density", "kg/m^3", &J2Plasticity::density},
                                  {"yield_stress", "Pa", &J2Plasticity::yield_stress},
                                  {"hardening_modulus", "Pa", &J2Plasticity::hardening_modulus},
                                  {"viscosity_linear", "1", &J2Plasticity::viscosity_linear}},
                                 {}, {{"yield_stress", 50}, {"hardening_modulus", 200}}));

// Where the component (i, j) of a column stands, -1 where the geometry has none.
using Places = std::array<int, 9>;
Places places_of_full(int components) {
  switch (components) {
    case 1:
      return {0, -1, -1, -1, -1, -1, -1, -1, -1};
    case 4:
      return {0, 1, -1, 2, 3, -1, -1, -1, -1};
    case 5:
      return {0, 1, -1, 2, 3, -1, -1, -1, 4};
    default:
      return {0, 1, 2, 3, 4, 5, 6, 7, 8};
  }
}
Places places_of_symmetric(int components) {
  switch (components) {
    case 3:
      return {0, -1, -1, -1, 1, -1, -1, -1, 2};
    case 4:
      return {0, 3, -1, 3, 1, -1, -1, -1, 2};
    default:
      return {0, 5, 4, 5, 1, 3, 4, 3, 2};
  }
}

// A column whose points hold a tensor in three directions, of which it has what the geometry can have; Number as in Components.
template <class Number>
class Tensors {
 public:
  template <class ColumnsRef>
  Tensors(ColumnsRef& points, const ColumnId& id, const Places& places, double elsewhere = 0) : elsewhere_(elsewhere) {
    for (std::size_t k = 0; k < places.size(); ++k) at_[k] = places[k] < 0 ? nullptr : points(id, places[k]);
  }
  Matrix operator[](int p) const {
    Matrix m;
    for (int k = 0; k < 9; ++k) {
      const Number* values = at_[static_cast<std::size_t>(k)];
      m(k / 3, k % 3) = values ? values[p] : k % 4 == 0 ? elsewhere_ : 0.0;
    }
    return m;
  }
  void set(int p, const Matrix& m) const {
    for (int k = 0; k < 9; ++k) {
      if (Number* values = at_[static_cast<std::size_t>(k)]) values[p] = m(k / 3, k % 3);
    }
  }

 private:
  std::array<Number*, 9> at_;
  double elsewhere_;  // on the diagonal, where the geometry has no component
};

// The columns of points that are read, or changed.
template <class Number, class ColumnsRef>
struct View {
  explicit View(ColumnsRef& points)
      : deformation(points, column::deformation, places_of_full(points.components(column::deformation)), 1),
        elastic(points, column::elastic_strain, places_of_symmetric(points.components(column::elastic_strain))),
        rate(points, column::strain_rate, places_of_full(points.components(column::strain_rate))),
        mass(points(column::mass)),
        volume(points(column::volume)),
        plastic(points(column::plastic_strain)),
        heat(points(column::heat)),
        viscous(points(column::viscous_pressure)) {}

  J2State state(int p) const { return {elastic[p], plastic[p]}; }
  // Power of the viscous pressure, W.
  double viscous_power(int p) const { return -volume[p] * viscous[p] * rate[p].trace(); }  // [J2 6]

  Tensors<Number> deformation, elastic;
  Tensors<const double> rate;
  const double* mass;
  Number *volume, *plastic, *heat, *viscous;
};
using Reading = View<const double, const Columns>;
using Writing = View<double, Columns>;

// Of the bulk modulus what stays a point's own where cells share the rest. None would leave motions within a cell without a force.
constexpr double own_share = 0.02;

// The law of points of which cells may share the dilatation.
class SharedLaw {
 public:
  SharedLaw(const J2Law& law, const Columns& points)
      : law_(law),
        bulk_(BulkModuli{law.bulk, own_share * law.bulk}, points) {}

  // J/m^3 at rest.
  double energy(const J2State& state, double theta) const {
    const double own = state.elastic.trace();
    const double beside = bulk_.energy(own, theta) - 0.5 * law_.bulk * own * own;  // [J2 7]
    return elastic_energy(law_, state.elastic) + beside +
           0.5 * law_.hardening * state.plastic * state.plastic;  // [J2 1]
  }
  // tau, Pa, with the mean dilatation of the cell `ahead` seconds later.
  Matrix stress(const Matrix& elastic, int p, double ahead) const {
    const double own = elastic.trace();
    return kirchhoff_stress(law_, elastic) + (bulk_.tension(own, p, ahead) - law_.bulk * own) * Matrix::Identity();
  }
  double dilatation(int p, double dt = 0) const { return bulk_.dilatation(p, dt); }

 private:
  J2Law law_;
  Bulk<double> bulk_;
};

double wave_modulus(const J2Law& law) { return law.bulk + 4.0 / 3.0 * law.shear; }

void check_range(const char* name, double value, bool inside, const char* range) {
  if (inside && std::isfinite(value)) return;
  std::ostringstream text;
  text << "material j2_plasticity: " << name << " is " << value << ", it must be " << range;
  throw std::invalid_argument(text.str());
}

}  // namespace

void J2Plasticity::check() const {
  check_range("youngs_modulus", youngs_modulus, youngs_modulus > 0, "in (0, inf) Pa");
  check_range("poissons_ratio", poissons_ratio, poissons_ratio > -1 && poissons_ratio < 0.5, "in (-1, 0.5)");
  check_range("density", density, density > 0, "in (0, inf) kg/m^3");
  check_range("yield_stress", yield_stress, yield_stress > 0, "in (0, inf) Pa");
  check_range("hardening_modulus", hardening_modulus, hardening_modulus >= 0, "in [0, inf) Pa");
  check_range("viscosity_linear", viscosity_linear, viscosity_linear >= 0, "in [0, inf)");
}

J2Law J2Plasticity::law() const {
  const LameConstants c = lame_constants(youngs_modulus, poissons_ratio);
  return {c.lambda + 2.0 / 3.0 * c.mu, c.mu, yield_stress, hardening_modulus};
}

std::optional<RestState> J2Plasticity::rest(int) const {
  const LameConstants c = lame_constants(youngs_modulus, poissons_ratio);
  return RestState{density, c.lambda + 2 * c.mu};
}

void J2Plasticity::add_columns(Columns& points, int dim) const {
  check();
  add_deformation(points, dim);
  constexpr int strains[] = {3, 4, 6};
  points.add(column::elastic_strain, strains[dim - 1]);
  for (const ColumnId* id : {&column::plastic_strain, &column::heat, &column::pressure, &column::viscous_pressure}) {
    points.add(*id);
  }
}

void J2Plasticity::share_dilatation(Columns& points) const {
  if (points.components(column::stress) == 1) return;  // what moves along a line alone does not lock
  points.add(column::dilatation);
  const Reading at(points);
  for (int p = 0; p < points.points(); ++p) points(column::dilatation)[p] = at.elastic[p].trace();
}

std::vector<const ColumnId*> J2Plasticity::internal_variables(const MaterialContext&) const {
  return {&column::deformation, &column::elastic_strain, &column::plastic_strain, &column::heat};
}

std::vector<double> J2Plasticity::rates(const Columns& points, const MaterialContext& context) const {
  const J2Law own = law();
  const Reading at(points);
  Columns all(points.points());
  for (const ColumnId* id : internal_variables(context)) all.add(*id, points.components(*id));
  const Tensors<double> deformation(all, column::deformation, places_of_full(all.components(column::deformation)));
  const Tensors<double> elastic(all, column::elastic_strain,
                                places_of_symmetric(all.components(column::elastic_strain)));
  for (int p = 0; p < points.points(); ++p) {
    const J2State change = rate_of(own, at.state(p), at.rate[p]);
    deformation.set(p, at.rate[p] * at.deformation[p]);
    elastic.set(p, change.elastic);
    all(column::plastic_strain)[p] = change.plastic;
    all(column::heat)[p] = own.yield * change.plastic / density + at.viscous_power(p) / at.mass[p];  // [J2 5]
  }
  std::vector<double> values;
  for (const ColumnId* id : internal_variables(context)) {
    values.insert(values.end(), all.values(*id).begin(), all.values(*id).end());
  }
  return values;
}

double J2Plasticity::advance(Columns& points, PointRange range, const MaterialContext&, double dt) const {
  const J2Law own = law();
  const SharedLaw shared(own, points);
  const Writing at(points);
  double* dilatation = points.has(column::dilatation) ? points(column::dilatation) : nullptr;
  double gained = 0;
  for (int p = range.first; p < range.last; ++p) {
    const J2State before = at.state(p);
    const double theta_before = shared.dilatation(p);
    const Matrix increment = dt * at.rate[p];
    const J2State now = returned(own, {strained(before.elastic, increment), before.plastic});
    at.deformation.set(p, at.deformation[p] + increment * at.deformation[p]);
    at.elastic.set(p, now.elastic);
    at.plastic[p] = now.plastic;
    const double heat_before = at.heat[p];
    at.heat[p] += own.yield * (now.plastic - before.plastic) / density +
                  dt * at.viscous_power(p) / at.mass[p];  // [J2 5]
    double theta = theta_before;
    if (dilatation) {  // what the step changes tr eps by beyond dt div v, a point keeps [Dilatation 4]
      theta = shared.dilatation(p, dt) + (now.elastic.trace() - before.elastic.trace()) - increment.trace();
      dilatation[p] = theta;
    }
    const double kept = (shared.energy(at.state(p), theta) - shared.energy(before, theta_before)) / density;
    gained += at.mass[p] * (kept + (at.heat[p] - heat_before));
  }
  return gained;
}

void J2Plasticity::evaluate_stress(Columns& points, PointRange range, const MaterialContext& context) const {
  const J2Law own = law();
  const SharedLaw shared(own, points);
  const Writing at(points);
  const Tensors<double> stress(points, column::stress, places_of_full(points.components(column::stress)));
  double* pressure = points(column::pressure);
  const double viscosity = viscosity_linear * std::sqrt(wave_modulus(own) * density) * context.h;
  for (int p = range.first; p < range.last; ++p) {
    const Matrix rate = at.rate[p], increment = context.ahead * rate;
    J2State then = at.state(p);
    if (context.ahead != 0) then = returned(own, {strained(then.elastic, increment), then.plastic});
    const double j = at.deformation[p].determinant();
    const Matrix tau = shared.stress(then.elastic, p, context.ahead);
    Matrix sigma = tau / j;
    if (context.ahead != 0) sigma = sigma * (Matrix::Identity() + increment).inverse().transpose();
    at.volume[p] = j * at.mass[p] / density;
    at.viscous[p] = viscosity / j * std::max(0.0, -rate.trace());  // [J2 6]
    pressure[p] = -tau.trace() / (3 * j);
    stress.set(p, sigma - at.viscous[p] * Matrix::Identity());
  }
}

double J2Plasticity::viscous_heat(const Columns& points, PointRange range, const MaterialContext&, double dt) const {
  const Reading at(points);
  double total = 0;
  for (int p = range.first; p < range.last; ++p) total += dt * at.viscous_power(p);
  return total;
}

double J2Plasticity::stored_energy(const Columns& points, PointRange range) const {
  const SharedLaw shared(law(), points);
  const Reading at(points);
  double total = 0;
  for (int p = range.first; p < range.last; ++p) {
    total += at.mass[p] * (shared.energy(at.state(p), shared.dilatation(p)) / density + at.heat[p]);
  }
  return total;
}

double J2Plasticity::heat(const Columns& points, PointRange range) const {
  const Reading at(points);
  double total = 0;
  for (int p = range.first; p < range.last; ++p) total += at.mass[p] * at.heat[p];
  return total;
}

// Along a principal axis waves run at sqrt((K + 4 G/3 - tau_1)/rho_0) in space, those of shear between two axes at less than
// sqrt((G + |tau_1 - tau_2|)/rho_0); plastic flow makes none faster. No |tau_k| is larger than the largest row sum.
StepBounds J2Plasticity::step_bounds(const Columns& points, PointRange range, int dim) const {
  const J2Law own = law();
  const Reading at(points);
  double largest = 0;
  for (int p = range.first; p < range.last; ++p) {
    const double sum = kirchhoff_stress(own, at.elastic[p]).cwiseAbs().rowwise().sum().maxCoeff();
    if (!(sum <= largest) && !std::isnan(largest)) largest = sum;
  }
  StepBounds bounds;
  bounds.fastest = std::sqrt((wave_modulus(own) + 2 * largest) / density) + fastest_point(points, range, dim);
  return bounds;
}

Material::Fault J2Plasticity::first_fault(const Columns& points, PointRange range) const {
  const Reading at(points);
  for (int p = range.first; p < range.last; ++p) {
    const double j = at.deformation[p].determinant();
    if (!(j > 0 && std::isfinite(j))) {
      return {p, column::deformation.name(), j, "the determinant of the deformation gradient must be positive"};
    }
    const double strain = at.elastic[p].sum();
    if (!std::isfinite(strain)) return {p, column::elastic_strain.name(), strain, "the elastic strain must be finite"};
    if (!(at.plastic[p] >= 0 && std::isfinite(at.plastic[p]))) {
      return {p, column::plastic_strain.name(), at.plastic[p], "the plastic strain must be finite and not negative"};
    }
    if (!std::isfinite(at.heat[p])) return {p, column::heat.name(), at.heat[p], "the heat must be finite"};
  }
  return {};
}

}  // namespace plumbline
