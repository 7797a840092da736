#include "kernel/materials/ideal_gas.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include "kernel/geometry.hpp"
#include "kernel/materials/material_entry.hpp"
#include "kernel/pack.hpp"
#include "kernel/register_part.hpp"

namespace plumbline {
namespace {

const RegisterPart ideal_gas_entry(material_entry<IdealGas>(
    "ideal gas with energy equation, viscosity and artificial viscosity", "York 1997, chapter 4",
    {{"gamma", "1", &IdealGas::gamma},
     {"viscosity", "Pa s", &IdealGas::viscosity},
     {"viscosity_linear", "1", &IdealGas::viscosity_linear},
     {"viscosity_quadratic", "1", &IdealGas::viscosity_quadratic}}));

// Energies of points, which a cold gas may not take below zero by what of |v_p|^2 is lost in the sum of kinetic and internal
// energy: there they become zero.
class Energies {
 public:
  explicit Energies(Columns& points)
      : energy_(points(column::energy)),
        components_(points.components(column::velocity)) {
    for (int k = 0; k < components_; ++k) velocity_[k] = points(column::velocity, k);
  }
  [[gnu::always_inline]] Pack operator[](int p) const { return load(energy_ + p); }
  [[gnu::always_inline]] void set(int p, const Pack& e, int count) const {
    constexpr double rounding = 1e-16;
    Pack square = 0.0;
    for (int k = 0; k < components_; ++k) square += load(velocity_[k] + p) * load(velocity_[k] + p);
    store(energy_ + p, choose(e < 0.0 && e > -rounding * square, Pack(0.0), e), count);
  }

 private:
  double* energy_;
  int components_;
  const double* velocity_[3] = {};
};

// Loops over points that carry `strains` strain rates and stresses, the first `normals` of them normal. <1, 1> serves
// points on a line and, with the divergence as their one rate, all points whose stress is a pressure.
template <int strains, int normals>
struct Loops {
  struct Tensor {
    Pack component[strains];
    Pack dot(const Tensor& o) const {
      Pack sum = component[0] * o.component[0];
      for (int k = 1; k < strains; ++k) sum += component[k] * o.component[k];
      return sum;
    }
    Pack trace() const {
      Pack sum = component[0];
      for (int k = 1; k < normals; ++k) sum += component[k];
      return sum;
    }
  };
  template <class Number>
  struct Reference {
    Number* at[strains];
    template <class C>
    Reference(C& points, const ColumnId& id) {
      for (int k = 0; k < strains; ++k) at[k] = points(id, k);
    }
    Tensor operator[](int p) const {
      Tensor t;
      for (int k = 0; k < strains; ++k) t.component[k] = load(at[k] + p);
      return t;
    }
    void set(int p, const Tensor& t, int count) const {
      for (int k = 0; k < strains; ++k) store(at[k] + p, t.component[k], count);
    }
  };
  using Reading = Reference<const double>;
  using Writing = Reference<double>;

  // The stress as written in the header. `rate`: strain rates; p: pressure.
  // closes: D.
  static Tensor stress(const IdealGas& gas, const Tensor& rate, const Pack& closes, const Pack& rho, const Pack& e,
                       const Pack& p, double h) {
    const Pack divergence = rate.trace();
    Pack pressure = p;
    if (gas.viscosity_linear > 0 || gas.viscosity_quadratic > 0) {
      const Pack c = sqrt(gas.gamma * (gas.gamma - 1) * e), closing = closes * h;
      pressure += rho * closing * (gas.viscosity_linear * c + gas.viscosity_quadratic * closing);  // [York 4.11]
    }
    const double mu = gas.viscosity;
    Tensor s;
    for (int k = 0; k < normals; ++k) {
      s.component[k] = 2 * mu * rate.component[k] - 2.0 / 3.0 * mu * divergence - pressure;  // [York 4.1]
    }
    for (int k = normals; k < strains; ++k) s.component[k] = mu * rate.component[k];
    return s;
  }

  // D of points from p on.
  static Pack closing(const double* limited, const Tensor& rate, int p) {
    return limited ? load(limited + p) : max(-rate.trace(), Pack(0.0));
  }

  static Tensor viscous_part(Tensor stress, const Pack& p) {
    for (int k = 0; k < normals; ++k) stress.component[k] += p;
    return stress;
  }

  // The energy after isentropic compression, e' = -(gamma - 1) e div v, to first order; never negative. [Leapfrog 2]
  static Pack ahead(const Pack& e, const Pack& z) { return choose(z < 0.0, e * (1.0 - z), e / (1.0 + z)); }

  static double advance(Columns& points, PointRange range, bool continuity, double dt) {
    const Reading rate(points, column::strain_rate), stress(points, column::stress);
    const double *volume = points(column::volume), *mass = points(column::mass);
    double* density = points(column::density);
    const Energies energy(points);
    Pack stored = 0.0;
    for_packs(
        range.first, range.last, [&](int p, int count) __attribute__((always_inline)) {
          const Tensor d = rate[p];
          const Pack heat = dt * load(volume + p) * stress[p].dot(d);
          energy.set(p, energy[p] + heat / load(mass + p), count);                                // [York 4.8]
          if (continuity) store(density + p, load(density + p) / (1.0 + dt * d.trace()), count);  // [York 4.7]
          stored += kept(heat, count);
        });
    return sum(stored);
  }

  static void evaluate(const IdealGas& gas, Columns& points, PointRange range, const MaterialContext& context) {
    const Reading rate(points, column::strain_rate);
    const Writing stresses(points, column::stress);
    const double *mass = points(column::mass), *energy = points(column::energy), *density = points(column::density);
    double *volume = points(column::volume), *pressure = points(column::pressure);
    double* sound = points.has(column::sound_speed) ? points(column::sound_speed) : nullptr;
    const double* limited = gas.limits_viscosity ? points(column::closing) : nullptr;
    for_packs(
        range.first, range.last, [&](int p, int count) __attribute__((always_inline)) {
          const Tensor d = rate[p];
          const Pack m = load(mass + p), e = ahead(load(energy + p), (gas.gamma - 1) * context.ahead * d.trace());
          const Pack rho = context.volume_given ? m / load(volume + p) : load(density + p);
          if (!context.volume_given) store(volume + p, m / rho, count);
          const Pack p_now = (gas.gamma - 1) * rho * e;  // [York 4.4]
          store(pressure + p, p_now, count);
          stresses.set(p, stress(gas, d, closing(limited, d, p), rho, e, p_now, context.h), count);
          if (sound) store(sound + p, sqrt(gas.gamma * (gas.gamma - 1) * e), count);
        });
  }

  static bool reverse_cooling(const IdealGas& gas, Columns& points, PointRange range, double h) {
    const Reading rate(points, column::strain_rate);
    const Writing stresses(points, column::stress);
    const double *mass = points(column::mass), *energy = points(column::energy), *volume = points(column::volume);
    const double* pressures = points(column::pressure);
    const double* limited = gas.limits_viscosity ? points(column::closing) : nullptr;
    bool changed = false;
    for_packs(
        range.first, range.last, [&](int p, int count) __attribute__((always_inline)) {
          const Pack e = load(energy + p), rho = load(mass + p) / load(volume + p), pressure = load(pressures + p);
          const Tensor d = rate[p], old = stresses[p];
          const PackMask cools = viscous_part(old, pressure).dot(d) < 0.0 && first_lanes(count);
          if (none_of(cools)) return;
          Tensor s = stress(gas, d, closing(limited, d, p), rho, e, pressure, h);
          for (int k = 0; k < strains; ++k) s.component[k] = choose(cools, s.component[k], old.component[k]);
          stresses.set(p, s, count);
          changed = true;
        });
    return changed;
  }

  static double viscous_heat(const Columns& points, PointRange range, double dt) {
    const Reading rate(points, column::strain_rate), stress(points, column::stress);
    const double *volume = points(column::volume), *pressure = points(column::pressure);
    Pack total = 0.0;
    for_packs(
        range.first, range.last, [&](int p, int count) __attribute__((always_inline)) {
          total += kept(dt * load(volume + p) * viscous_part(stress[p], load(pressure + p)).dot(rate[p]), count);
        });
    return sum(total);
  }

  static std::vector<double> rates(const Columns& points, bool continuity) {
    const Reading rate(points, column::strain_rate), stress(points, column::stress);
    const double *volume = points(column::volume), *mass = points(column::mass), *density = points(column::density);
    const auto n = static_cast<std::size_t>(points.points());
    std::vector<double> all((continuity ? 2 : 1) * n);
    for_packs(
        0, points.points(), [&](int p, int count) __attribute__((always_inline)) {
          store(all.data() + p, load(volume + p) / load(mass + p) * stress[p].dot(rate[p]), count);  // [York 4.8]
          if (continuity)
            store(all.data() + n + static_cast<std::size_t>(p), -load(density + p) * rate[p].trace(), count);
        });
    return all;
  }
};

// Calls visit with the Loops of the columns that the points have.
template <class Visit>
auto with_loops(const Columns& points, Visit&& visit) {
  switch (points.components(column::stress)) {
    case 3:
      return visit(Loops<3, 2>());
    case 4:
      return visit(Loops<4, 3>());
    case 6:
      return visit(Loops<6, 3>());
    default:
      return visit(Loops<1, 1>());
  }
}

}  // namespace

void IdealGas::add_columns(Columns& points, int) const {
  points.add(column::density);
  points.add(column::energy);
  points.add(column::pressure);
  if (limits_viscosity) points.add(column::closing);
}

double IdealGas::advance(Columns& points, PointRange range, const MaterialContext& context, double dt) const {
  return with_loops(points, [&](auto loops) { return loops.advance(points, range, context.continuity_density, dt); });
}

std::vector<const ColumnId*> IdealGas::internal_variables(const MaterialContext& context) const {
  if (context.continuity_density) return {&column::energy, &column::density};
  return {&column::energy};
}

std::vector<double> IdealGas::rates(const Columns& points, const MaterialContext& context) const {
  return with_loops(points, [&](auto loops) { return loops.rates(points, context.continuity_density); });
}

void IdealGas::evaluate_stress(Columns& points, PointRange range, const MaterialContext& context) const {
  with_loops(points, [&](auto loops) { loops.evaluate(*this, points, range, context); });
}

bool IdealGas::reverse_cooling(Columns& points, PointRange range, const MaterialContext& context) const {
  if (!viscous()) return false;
  return with_loops(points, [&](auto loops) { return loops.reverse_cooling(*this, points, range, context.h); });
}

double IdealGas::viscous_heat(const Columns& points, PointRange range, const MaterialContext&, double dt) const {
  if (!viscous()) return 0;
  return with_loops(points, [&](auto loops) { return loops.viscous_heat(points, range, dt); });
}

void IdealGas::add_heat(Columns& points, PointRange range, const double* heat) const {
  const double* mass = points(column::mass);
  const Energies energy(points);
  for_packs(
      range.first, range.last, [&](int p, int count) __attribute__((always_inline)) {
        energy.set(p, energy[p] + load(heat + p) / load(mass + p), count);  // [EC-APIC 6]
      });
}

double IdealGas::stored_energy(const Columns& points, PointRange range) const {
  const double *mass = points(column::mass), *energy = points(column::energy);
  Pack total = 0.0;
  for_packs(
      range.first, range.last, [&](int p, int count) __attribute__((always_inline)) {
        total += kept(load(mass + p) * load(energy + p), count);
      });
  return sum(total);
}

StepBounds IdealGas::step_bounds(const Columns& points, PointRange range, int dim) const {
  const double *mass = points(column::mass), *energy = points(column::energy), *volume = points(column::volume);
  const double* velocity[3];
  for (int d = 0; d < dim; ++d) velocity[d] = points(column::velocity, d);
  Pack fastest = 0.0, lightest = std::numeric_limits<double>::infinity();
  bool number = true;
  for_packs(
      range.first, range.last, [&](int p, int count) __attribute__((always_inline)) {
        Pack square = load(velocity[0] + p) * load(velocity[0] + p);
        for (int d = 1; d < dim; ++d) square += load(velocity[d] + p) * load(velocity[d] + p);
        const Pack signal = kept(sqrt(gamma * (gamma - 1) * load(energy + p)) + sqrt(square), count);
        number = number && none_of(isnan(signal));  // max() would swallow it
        fastest = max(fastest, signal);
        if (viscosity > 0)
          lightest = min(lightest, choose(first_lanes(count), load(mass + p) / load(volume + p), lightest));
      });
  StepBounds bounds;
  bounds.fastest = number ? hmax(fastest) : std::numeric_limits<double>::quiet_NaN();
  if (viscosity > 0) bounds.diffusivity = 4.0 / 3.0 * viscosity / hmin(lightest);
  return bounds;
}

Material::Fault IdealGas::first_fault(const Columns& points, PointRange range) const {
  const double *mass = points(column::mass), *energy = points(column::energy), *volume = points(column::volume);
  const auto admissible = [](const Pack& value) { return value < std::numeric_limits<double>::infinity(); };
  bool good = true;
  for_packs(
      range.first, range.last, [&](int p, int count) __attribute__((always_inline)) {
        const Pack v = load(volume + p), e = load(energy + p);
        good = good && all_of((v > 0.0 && admissible(v) && e >= 0.0 && admissible(e)) || !first_lanes(count));
      });
  if (good) return {};
  for (int p = range.first; p < range.last; ++p) {
    const double density = mass[p] / volume[p];
    if (!(density > 0 && std::isfinite(density))) {
      return {p, column::density.name(), density, "the density must be positive and finite"};
    }
    if (!(energy[p] >= 0 && std::isfinite(energy[p]))) {
      return {p, column::energy.name(), energy[p], "the specific internal energy must be finite and not negative"};
    }
  }
  return {};
}

void IdealGas::describe(Columns& points) const {
  const double *mass = points(column::mass), *energy = points(column::energy), *volume = points(column::volume);
  double *density = points(column::density), *pressure = points(column::pressure);
  for_packs(
      0, points.points(), [&](int p, int count) __attribute__((always_inline)) {
        const Pack rho = load(mass + p) / load(volume + p);
        plumbline::store(density + p, rho, count);
        plumbline::store(pressure + p, (gamma - 1) * rho * load(energy + p), count);  // [York 4.4]
      });
}

}  // namespace plumbline
