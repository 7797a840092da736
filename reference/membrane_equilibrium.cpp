#include "reference/membrane_equilibrium.hpp"

#include "reference/argument.hpp"
#include "reference/circle.hpp"
#include "reference/exponential.hpp"
#include "reference/root.hpp"

namespace plumbline::reference {
namespace {

void check_problem(const MembraneEquilibriumProblem& p) {
  check_positive("gas_energy", p.gas_energy);
  check_positive("gas_area", p.gas_area);
  check({"gamma", 0, 1, rounding::infinity, true, true, "", ""}, p.gamma);
  check_positive("length", p.length);
  check_positive("youngs_modulus", p.youngs_modulus);
  check({"poisson_ratio", 0, -0.5, 0.5, true, true, "", ""}, p.poisson_ratio);
  check_positive("thickness", p.thickness);
  check_positive("density", p.density);
  check({"lost", 0, 0, p.gas_energy, false, true, "", ""}, p.lost);
}

/// A = area R^2, Lambda = length R, distance of the wall = apothem R.
struct Shape {
  Bounded area, length, apothem;
};

Shape shape_of(int segments) {
  check({"segments", 0, 0, 1e6, false, false, "", ""}, segments);
  if (segments == 0) return {pi / 4.0, pi / 2.0, 1};
  const Bounded n = segments, half = pi / (Bounded(4) * n);
  return {n * sin(half) * cos(half), Bounded(2) * n * sin(half), cos(half)};
}

/// The positive root of a x^2 + x = b for a, b > 0.
Bounded small_root(Bounded a, Bounded b) {
  return Bounded(2) * b / (Bounded(1) + sqrt(Bounded(1) + Bounded(4) * a * b));
}

}  // namespace

MembraneEquilibrium::MembraneEquilibrium(const MembraneEquilibriumProblem& problem) : problem_(problem) {
  check_problem(problem);
  const Bounded nu = problem.poisson_ratio;
  modulus_ = Bounded(problem.youngs_modulus) / (Bounded(1) - nu * nu);  // [York 5.12]
  elastic_ = modulus_ * problem.thickness * problem.length;
}

Bounded MembraneEquilibrium::membrane_volume() const { return Bounded(problem_.thickness) * problem_.length; }
Bounded MembraneEquilibrium::membrane_mass() const { return membrane_volume() * problem_.density; }

/// Lambda/L
Bounded MembraneEquilibrium::stretched(Bounded strain) const {
  return Bounded(1) + (problem_.law == MembraneLaw::segments ? strain : expm1(strain));
}

MembraneState MembraneEquilibrium::state(int segments) const {
  const Bounded left = Bounded(problem_.gas_energy) - problem_.lost, gamma = problem_.gamma;
  const Bounded b = Bounded(2) * (gamma - 1.0) * left / elastic_;
  return state_at(small_root(problem_.law == MembraneLaw::segments ? gamma : gamma - 1.0, b), segments);
}

// 2 p A = T Lambda and p A^gamma as at the start: eps (1 + eps) (Lambda^2 C')^(gamma-1) w/2 = (gamma - 1) U_0 A_0^(gamma-1)
// for segments, eps alone in front for the accumulated law; C' = A/Lambda^2. Here its logarithm, in ln eps.
MembraneState MembraneEquilibrium::isentropic(int segments) const {
  const Shape shape = shape_of(segments);
  const bool chords = problem_.law == MembraneLaw::segments;
  const Bounded g = Bounded(problem_.gamma) - 1.0, long_to_area = shape.area / (shape.length * shape.length);
  const Bounded ratio = long_to_area * problem_.length * problem_.length / problem_.gas_area;
  const Bounded known = log(Bounded(2) * g * problem_.gas_energy / elastic_) - g * log(ratio);
  auto f = [&](double at) {
    const Bounded strain = exp(Bounded(at));
    const Bounded longer = chords ? log(Bounded(1) + strain) : strain;  // ln(Lambda/L)
    return Bounded(at) + (Bounded(2) * g + (chords ? 1.0 : 0.0)) * longer - known;
  };
  // the terms beside ln eps are positive, so it lies below `known`; for eps <= 1 they are below 2 g + 1
  const double high = known.value, least = std::min(high, 0.0) - 2 * g.value - 2;
  auto value = [&f](double at) { return f(at).value; };
  const double x = value(high) <= 0 ? high : brent_root(value, least, high);
  const double strain = std::exp(x), slope = 1 + strain * (2 * g.value + 1) / (chords ? 1 + strain : 1);
  const Bounded root = enclose_root(f, x, slope, -rounding::infinity, rounding::infinity);
  return state_at(exp(root), segments);
}

MembraneState MembraneEquilibrium::state_at(Bounded strain, int segments) const {
  const Shape shape = shape_of(segments);
  const bool chords = problem_.law == MembraneLaw::segments;
  MembraneState s;
  s.strain = strain;
  s.length = stretched(strain) * problem_.length;
  s.radius = s.length / shape.length;
  s.apothem = s.radius * shape.apothem;
  s.area = shape.area * s.radius * s.radius;
  s.stress = modulus_ * strain;  // [York 5.12]
  s.tension = s.stress * problem_.thickness;
  if (!chords) s.tension = s.tension / stretched(strain);
  s.pressure = s.tension / s.apothem;
  s.gas_energy = s.tension * s.length / (Bounded(2) * (Bounded(problem_.gamma) - 1.0));
  s.membrane_energy = Bounded(0.5) * elastic_ * strain * strain;
  // d2W/dR2 - 2 p C, 2 p C = T Lambda'/R, Lambda' = Lambda/R. Segments: w Lambda'^2/L^2 - w eps Lambda'/(L R);
  // accumulated: T' = E' V (1 - eps) Lambda'/Lambda^2.
  const Bounded dry = elastic_ / (s.radius * s.radius) *
                      (chords ? Bounded(1) + strain : Bounded(1) - Bounded(2) * strain);
  const Bounded gas = Bounded(4) * problem_.gamma * s.pressure * shape.area;
  s.dry_omega = sqrt(dry / membrane_mass());
  s.breathing_omega = sqrt((dry + gas) / membrane_mass());
  s.breathing_period = Bounded(2) * pi / s.breathing_omega;
  return s;
}

Bounded MembraneEquilibrium::virial_stress() const {
  return Bounded(2) * (Bounded(problem_.gamma) - 1.0) * state().gas_energy / membrane_volume();
}

}  // namespace plumbline::reference
