#include "kernel/materials/neo_hookean.hpp"

#include <algorithm>
#include <cmath>

#include "kernel/largest.hpp"
#include "kernel/logarithm.hpp"
#include "kernel/materials/material_entry.hpp"
#include "kernel/materials/shared_dilatation.hpp"
#include "kernel/points/pack_tensors.hpp"
#include "kernel/register_part.hpp"
#include "kernel/shapes/reference_columns.hpp"

namespace plumbline {
namespace {

const RegisterPart neo_hookean_entry(material_entry<NeoHookean>(
    "finite strains, compressible neo-Hookean", "Wallstedt, Guilkey 2008, doi 10.1016/j.jcp.2008.07.019",
    {{"youngs_modulus", "Pa", &NeoHookean::youngs_modulus},
     {"poissons_ratio", "1", &NeoHookean::poissons_ratio},
     {"density", "kg/m^3", &NeoHookean::density}}));

// Loops over points of one geometry, packs of them at a time.
template <int dim, bool rings>
struct Loops {
  using Tensor = PackTensor<dim, rings>;
  using Reading = TensorColumn<Tensor, const double>;
  using Writing = TensorColumn<Tensor, double>;
  static constexpr int size = Tensor::size;

  static Tensor after(const Tensor& f, const Tensor& rate, double dt) {
    Tensor then = rate * f;
    for (int k = 0; k < size; ++k) then.at[k] = f.at[k] + dt * then.at[k];  // [Neo-Hookean 2]
    return then;
  }
  static Pack energy(const LameConstants& c, const Bulk<>& bulk, const Tensor& f, const Pack& theta) {
    constexpr double directions = dim + (rings ? 1 : 0);
    const Pack log_j = logarithm(f.determinant());
    return 0.5 * c.mu * (f.sum_of_squares() - directions - 2.0 * log_j) + bulk.energy(log_j, theta);  // [Neo-Hookean 1]
  }
  // P of point p, `ahead` seconds from where its dilatations are known.
  static Tensor stress(const LameConstants& c, const Bulk<>& bulk, const Tensor& f, int at, double ahead) {
    const Pack j = f.determinant(), pull = bulk.tension(logarithm(j), at, ahead), share = 1.0 / j;
    Tensor p, inverse = f.cofactors();
    for (int k = 0; k < size; ++k) {
      inverse.at[k] *= share;
      p.at[k] = c.mu * (f.at[k] - inverse.at[k]) + pull * inverse.at[k];  // [Neo-Hookean 1]
    }
    return p;
  }
  // The largest row sum of A A^T: no square of a principal stretch is larger.
  static Pack largest_square(const Tensor& a) {
    const Tensor left = a * a.transposed();
    Pack square = rings ? left.at[size - 1] : Pack(0.0);
    for (int row = 0; row < dim * dim; row += dim) {
      Pack sum = abs(left.at[row]);
      for (int k = 1; k < dim; ++k) sum += abs(left.at[row + k]);
      square = larger(square, sum);
    }
    return square;
  }
  static Tensor inverse(const Tensor& f) {
    Tensor back = f.cofactors().transposed();
    const Pack share = 1.0 / f.determinant();
    for (int k = 0; k < size; ++k) back.at[k] *= share;
    return back;
  }
  // rho_0 times the square of the largest speed of waves. In space they run along n at
  // sqrt((mu |F^T n|^2 + mu + lambda (1 - ln J)) / rho_0) ...
  static Pack stiffness(const LameConstants& c, const Tensor& f) {
    return c.mu * (largest_square(f) + 1.0) + bulk_stiffness(c, f);
  }
  // ... and among the places of a start with F_0, where n is (F F_0^-1)^-T N, so much slower or faster. [Lagrangian 4]
  static Pack stiffness_at_start(const LameConstants& c, const Tensor& f, const Tensor& start) {
    return c.mu * largest_square(start) + (c.mu + bulk_stiffness(c, f)) * largest_square(start * inverse(f));
  }
  static Pack bulk_stiffness(const LameConstants& c, const Tensor& f) {
    const Pack log_j = logarithm(f.determinant());
    return c.lambda * choose(log_j < 1.0, 1.0 - log_j, Pack(0.0));
  }

  // What a step changes ln J by beyond dt div v: a step along straight lines widens what turns. [Dilatation 4]
  static Pack beyond_rate(const Tensor& before, const Tensor& now, const Tensor& rate, double dt) {
    Pack divergence = rings ? rate.at[size - 1] : Pack(0.0);
    for (int d = 0; d < dim; ++d) divergence += rate.at[d * (dim + 1)];
    return logarithm(now.determinant() / before.determinant()) - dt * divergence;
  }

  static double advance(const NeoHookean& m, Columns& points, PointRange range, double dt) {
    const LameConstants c = m.constants();
    const Bulk bulk(c, points);
    const Writing deformation(points, column::deformation);
    const Reading rate(points, column::strain_rate);
    const double* mass = points(column::mass);
    double* shared = points.has(column::dilatation) ? points(column::dilatation) : nullptr;
    Pack stored = 0.0;
    for_packs(
        range.first, range.last, [&](int p, int count) __attribute__((always_inline)) {
          const Tensor before = deformation[p], now = after(before, rate[p], dt);
          const Pack theta = bulk.dilatation(p);
          Pack next = theta;
          if (shared) {
            next = bulk.dilatation(p, dt) + beyond_rate(before, now, rate[p], dt);
            plumbline::store(shared + p, next, count);
          }
          deformation.set(p, now, count);
          stored += kept(load(mass + p) * (energy(c, bulk, now, next) - energy(c, bulk, before, theta)), count);
        });
    return sum(stored) / m.density;
  }

  static void evaluate(const NeoHookean& m, Columns& points, PointRange range, double ahead) {
    const LameConstants c = m.constants();
    const Bulk bulk(c, points);
    const Reading deformation(points, column::deformation), rate(points, column::strain_rate);
    const Writing stresses(points, column::stress);
    const double *mass = points(column::mass), specific_volume = 1 / m.density;
    double* volume = points(column::volume);
    for_packs(
        range.first, range.last, [&](int p, int count) __attribute__((always_inline)) {
          const Tensor here = deformation[p];
          const Pack j = here.determinant(), share = 1.0 / j;
          Tensor s = stress(c, bulk, ahead == 0 ? here : after(here, rate[p], ahead), p, ahead) * here.transposed();
          for (int k = 0; k < size; ++k) s.at[k] *= share;
          stresses.set(p, s, count);
          plumbline::store(volume + p, j * load(mass + p) * specific_volume, count);
        });
  }

  static std::vector<double> rates(const Columns& points) {
    const Reading deformation(points, column::deformation), rate(points, column::strain_rate);
    Columns result(points.points());
    result.add(column::deformation, size);
    const Writing change(result, column::deformation);
    for_packs(
        0, points.points(), [&](int p, int count) __attribute__((always_inline)) {
          change.set(p, rate[p] * deformation[p], count);
        });
    const auto values = result.values(column::deformation);
    return {values.begin(), values.end()};
  }

  static void find_dilatation(Columns& points) {
    const Reading deformation(points, column::deformation);
    double* dilatation = points(column::dilatation);
    for_packs(
        0, points.points(), [&](int p, int count) __attribute__((always_inline)) {
          plumbline::store(dilatation + p, logarithm(deformation[p].determinant()), count);
        });
  }

  static double stored(const NeoHookean& m, const Columns& points, PointRange range) {
    const LameConstants c = m.constants();
    const Bulk bulk(c, points);
    const Reading deformation(points, column::deformation);
    const double* mass = points(column::mass);
    Pack total = 0.0;
    for_packs(
        range.first, range.last, [&](int p, int count) __attribute__((always_inline)) {
          total += kept(load(mass + p) * energy(c, bulk, deformation[p], bulk.dilatation(p)), count);
        });
    return sum(total) / m.density;
  }

  static double fastest_wave(const NeoHookean& m, const Columns& points, PointRange range) {
    const LameConstants c = m.constants();
    const Reading deformation(points, column::deformation);
    Largest largest;
    if (points.has(column::position_at_start)) {
      const Reading start(points, column::deformation_at_start);
      for_packs(range.first, range.last,
                [&](int p, int count) { largest.include(stiffness_at_start(c, deformation[p], start[p]), count); });
      return std::sqrt(largest.value() / m.density);
    }
    for_packs(
        range.first, range.last, [&](int p, int count) __attribute__((always_inline)) {
          largest.include(stiffness(c, deformation[p]), count);
        });
    return std::sqrt(largest.value() / m.density);
  }

  static Material::Fault fault(const Columns& points, PointRange range) {
    const Reading deformation(points, column::deformation);
    Material::Fault first;
    for_packs(
        range.first, range.last, [&](int p, int count) __attribute__((always_inline)) {
          const Pack j = deformation[p].determinant();
          const PackMask bad = !(j > 0.0 && j < HUGE_VAL) && first_lanes(count);
          if (first.point >= 0 || none_of(bad)) return;
          const int lane = find_first_set(bad);
          first = {p + lane, column::deformation.name(), j[static_cast<std::size_t>(lane)],
                   "the determinant of the deformation gradient must be positive"};
        });
    return first;
  }
};

template <class Visit>
auto with_loops(const Columns& points, Visit&& visit) {
  switch (points.components(column::stress)) {
    case 1:
      return visit(Loops<1, false>{});
    case 4:
      return visit(Loops<2, false>{});
    case 5:
      return visit(Loops<2, true>{});
    default:
      return visit(Loops<3, false>{});
  }
}

}  // namespace

std::optional<RestState> NeoHookean::rest(int) const {
  const LameConstants c = constants();
  return RestState{density, c.lambda + 2 * c.mu};
}

void NeoHookean::add_columns(Columns& points, int dim) const { add_deformation(points, dim); }

void NeoHookean::share_dilatation(Columns& points) const {
  if (!hardly_compresses(constants())) return;
  points.add(column::dilatation);
  with_loops(points, [&](auto loops) { loops.find_dilatation(points); });
}

std::vector<const ColumnId*> NeoHookean::internal_variables(const MaterialContext&) const {
  return {&column::deformation};
}

std::vector<double> NeoHookean::rates(const Columns& points, const MaterialContext&) const {
  return with_loops(points, [&](auto loops) { return loops.rates(points); });
}

double NeoHookean::advance(Columns& points, PointRange range, const MaterialContext&, double dt) const {
  return with_loops(points, [&](auto loops) { return loops.advance(*this, points, range, dt); });
}

void NeoHookean::evaluate_stress(Columns& points, PointRange range, const MaterialContext& context) const {
  with_loops(points, [&](auto loops) { loops.evaluate(*this, points, range, context.ahead); });
}

double NeoHookean::stored_energy(const Columns& points, PointRange range) const {
  return with_loops(points, [&](auto loops) { return loops.stored(*this, points, range); });
}

StepBounds NeoHookean::step_bounds(const Columns& points, PointRange range, int dim) const {
  StepBounds bounds;
  bounds.fastest = with_loops(points, [&](auto loops) { return loops.fastest_wave(*this, points, range); }) +
                   fastest_point(points, range, dim);
  return bounds;
}

Material::Fault NeoHookean::first_fault(const Columns& points, PointRange range) const {
  return with_loops(points, [&](auto loops) { return loops.fault(points, range); });
}

}  // namespace plumbline
