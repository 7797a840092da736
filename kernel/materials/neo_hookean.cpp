#include "kernel/materials/neo_hookean.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "kernel/materials/material_entry.hpp"
#include "kernel/points/components.hpp"
#include "kernel/register_part.hpp"

namespace plumbline {
namespace {

const RegisterPart entry(material_entry<NeoHookean>("finite strains, compressible neo-Hookean",
                                                    "Wallstedt, Guilkey 2008, doi 10.1016/j.jcp.2008.07.019",
                                                    {{"youngs_modulus", "Pa", &NeoHookean::youngs_modulus},
                                                     {"poissons_ratio", "1", &NeoHookean::poissons_ratio},
                                                     {"density", "kg/m^3", &NeoHookean::density}}));

// One point's deformation, or the rate of its change: F and the hoop's stretch, which is 1 where there is none.
template <int dim, bool rings>
struct Loops {
  using Matrix = Eigen::Matrix<double, dim, dim>;
  template <class Number>
  struct Reading {
    Components<Matrix, Number> in_plane;
    Number* hoop;
    template <class C>
    Reading(C& points, const ColumnId& id) : in_plane(points, id),
                                             hoop(rings ? points(id, dim * dim) : nullptr) {}
    double hoop_at(int p, double none) const { return rings ? hoop[p] : none; }
  };
  struct Stretch {
    Matrix f;
    double hoop = 1;
    double volume_ratio() const { return f.determinant() * hoop; }
  };
  static Stretch after(const Matrix& f, double hoop, const Matrix& rate, double hoop_rate, double dt) {
    return {f + dt * rate * f, hoop + dt * hoop_rate * hoop};  // [Neo-Hookean 2]
  }
  static double energy(const LameConstants& c, const Stretch& s) {
    const double log_j = std::log(s.volume_ratio());
    const double squares = s.f.squaredNorm() - dim + (rings ? s.hoop * s.hoop - 1 : 0.0);
    return 0.5 * c.mu * (squares - 2 * log_j) + 0.5 * c.lambda * log_j * log_j;  // [Neo-Hookean 1]
  }

  static double advance(const NeoHookean& m, Columns& points, PointRange range, double dt) {
    const LameConstants c = m.constants();
    Reading<double> deformation(points, column::deformation);
    const Reading<double> rate(points, column::strain_rate);
    const double* mass = points(column::mass);
    double stored = 0;
    for (int p = range.first; p < range.last; ++p) {
      const Stretch before{deformation.in_plane[p], deformation.hoop_at(p, 1)};
      const Stretch now = after(before.f, before.hoop, rate.in_plane[p], rate.hoop_at(p, 0), dt);
      deformation.in_plane.set(p, now.f);
      if (rings) deformation.hoop[p] = now.hoop;
      stored += mass[p] / m.density * (energy(c, now) - energy(c, before));
    }
    return stored;
  }

  static void evaluate(const NeoHookean& m, Columns& points, PointRange range, double ahead) {
    const LameConstants c = m.constants();
    const Reading<double> deformation(points, column::deformation), rate(points, column::strain_rate);
    Reading<double> stress(points, column::stress);
    const double* mass = points(column::mass);
    double* volume = points(column::volume);
    for (int p = range.first; p < range.last; ++p) {
      const Stretch here{deformation.in_plane[p], deformation.hoop_at(p, 1)};
      const Stretch then = ahead == 0 ? here : after(here.f, here.hoop, rate.in_plane[p], rate.hoop_at(p, 0), ahead);
      const double log_j = std::log(then.volume_ratio()), j = here.volume_ratio();
      const Matrix inverse = then.f.inverse().transpose();
      const Matrix first = c.mu * (then.f - inverse) + c.lambda * log_j * inverse;  // [Neo-Hookean 1]
      stress.in_plane.set(p, first * here.f.transpose() / j);
      if (rings) stress.hoop[p] = (c.mu * (then.hoop - 1 / then.hoop) + c.lambda * log_j / then.hoop) * here.hoop / j;
      volume[p] = j * mass[p] / m.density;
    }
  }

  static std::vector<double> rates(const Columns& points) {
    const Reading<const double> deformation(points, column::deformation), rate(points, column::strain_rate);
    Columns result(points.points());
    result.add(column::deformation, points.components(column::deformation));
    Reading<double> change(result, column::deformation);
    for (int p = 0; p < points.points(); ++p) {
      change.in_plane.set(p, rate.in_plane[p] * deformation.in_plane[p]);
      if (rings) change.hoop[p] = rate.hoop[p] * deformation.hoop[p];
    }
    const auto values = result.values(column::deformation);
    return {values.begin(), values.end()};
  }

  static double stored(const NeoHookean& m, const Columns& points, PointRange range) {
    const LameConstants c = m.constants();
    const Reading<const double> deformation(points, column::deformation);
    const double* mass = points(column::mass);
    double sum = 0;
    for (int p = range.first; p < range.last; ++p) {
      sum += mass[p] / m.density * energy(c, {deformation.in_plane[p], deformation.hoop_at(p, 1)});
    }
    return sum;
  }

  // Along a principal stretch s waves run at sqrt((mu (s^2 + 1) + lambda (1 - ln J)) / rho_0) in space; no s^2 is larger
  // than the largest row sum of F F^T.
  static double fastest_wave(const NeoHookean& m, const Columns& points, PointRange range) {
    const LameConstants c = m.constants();
    const Reading<const double> deformation(points, column::deformation);
    double largest = 0;
    for (int p = range.first; p < range.last; ++p) {
      const Stretch here{deformation.in_plane[p], deformation.hoop_at(p, 1)};
      const Matrix left = here.f * here.f.transpose();
      const double square = std::max(left.cwiseAbs().rowwise().sum().maxCoeff(), rings ? here.hoop * here.hoop : 0.0);
      const double speed = std::sqrt(
          (c.mu * (square + 1) + c.lambda * std::max(0.0, 1 - std::log(here.volume_ratio()))) / m.density);
      if (!std::isnan(largest) && !(speed <= largest)) largest = speed;
    }
    return largest;
  }

  static Material::Fault fault(const Columns& points, PointRange range) {
    const Reading<const double> deformation(points, column::deformation);
    for (int p = range.first; p < range.last; ++p) {
      const double j = Stretch{deformation.in_plane[p], deformation.hoop_at(p, 1)}.volume_ratio();
      if (!(j > 0) || !std::isfinite(j)) {
        return {p, column::deformation.name(), j, "the determinant of the deformation gradient must be positive"};
      }
    }
    return {};
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

void NeoHookean::add_columns(Columns& points, int dim) const {
  const int components = points.components(column::stress);
  points.add(column::deformation, components);
  for (int k = 0; k < components; ++k) {
    const bool diagonal = k == dim * dim || k % (dim + 1) == 0;
    if (diagonal) std::fill_n(points(column::deformation, k), points.points(), 1.0);
  }
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
