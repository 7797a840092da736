#include "reference/rotating_disk.hpp"

#include <cmath>

#include "reference/argument.hpp"
#include "reference/circle.hpp"

namespace plumbline::reference {

RotatingDisk::RotatingDisk(const RotatingDiskProblem& problem) : problem_(problem) {
  check_positive("radius", problem.radius);
  check_positive("youngs_modulus", problem.youngs_modulus);
  check({"poisson", 0, -1, 0.5, true, true, "1", ""}, problem.poisson);
  check_positive("density", problem.density);
  check_finite("angular_velocity", problem.angular_velocity);
  const Bounded nu(problem.poisson), e(problem.youngs_modulus),
      speed = Bounded(problem.angular_velocity) * problem.radius;
  const bool thick = problem.plane == PlaneState::strain;
  stiffness_ = thick ? e / ((Bounded(1) - nu) * (Bounded(1) + nu)) : e;
  nu_ = thick ? nu / (Bounded(1) - nu) : nu;
  load_ = Bounded(problem.density) * speed * speed / 8.0;
  if (!(largest_strain() < 0.1)) {
    throw ParameterError("angular_velocity", problem.angular_velocity, "slow enough for strains below 0.1");
  }
}

/// u/r at the centre, where both strains are equal.
double RotatingDisk::largest_strain() const {
  return (load_ * (Bounded(1) - nu_) * (Bounded(3) + nu_) / stiffness_).value;
}

Bounded RotatingDisk::bounded(Bounded value, Bounded largest) const {
  return {value.value, (value.bound + 4 * largest_strain() * std::abs(largest.value)) * rounding::inflate};
}

Bounded RotatingDisk::displacement(double radius) const {
  check_within("radius", radius, 0, problem_.radius);
  const Bounded part = Bounded(radius) / problem_.radius;
  auto at = [&](Bounded x) {  // [Timoshenko 32]
    return load_ * (Bounded(1) - nu_) / stiffness_ * problem_.radius * x *
           (Bounded(3) + nu_ - (Bounded(1) + nu_) * x * x);
  };
  return bounded(at(part), at(1.0));
}

Bounded RotatingDisk::velocity(double radius) const {
  return Bounded(problem_.angular_velocity) * (Bounded(radius) + displacement(radius));
}

Bounded RotatingDisk::radial_stress(double radius) const {
  check_within("radius", radius, 0, problem_.radius);
  const Bounded part = Bounded(radius) / problem_.radius;
  const Bounded centre = load_ * (Bounded(3) + nu_);
  return bounded(centre * (Bounded(1) - part) * (Bounded(1) + part), centre);  // [Timoshenko 32]
}

Bounded RotatingDisk::hoop_stress(double radius) const {
  check_within("radius", radius, 0, problem_.radius);
  const Bounded part = Bounded(radius) / problem_.radius;
  const Bounded value = load_ * (Bounded(3) + nu_ - (Bounded(1) + Bounded(3) * nu_) * part * part);  // [Timoshenko 32]
  return bounded(value, load_ * (Bounded(3) + nu_));
}

Bounded RotatingDisk::axial_stress(double radius) const {
  if (problem_.plane == PlaneState::stress) return 0.0;
  return Bounded(problem_.poisson) * (radial_stress(radius) + hoop_stress(radius));
}

Bounded RotatingDisk::centre_stress() const { return radial_stress(0); }

/// rho times the integral of (r + u)^2 over the disk at rest, u = r (a - b r^2/R^2).
Bounded RotatingDisk::inertia() const {
  const Bounded share = load_ * (Bounded(1) - nu_) / stiffness_, r2 = Bounded(problem_.radius) * problem_.radius;
  const Bounded a = Bounded(1) + share * (Bounded(3) + nu_), b = share * (Bounded(1) + nu_);
  const Bounded integral = a * a / 4.0 - a * b / 3.0 + b * b / 8.0;
  const Bounded value = Bounded(2) * pi * problem_.density * r2 * r2 * integral;
  const double neglected = 8 * largest_strain() * largest_strain();  // displacements enter twice, each within 4 strains
  return {value.value, value.bound + neglected * value.value};
}

Bounded RotatingDisk::angular_momentum() const { return inertia() * problem_.angular_velocity; }

Bounded RotatingDisk::kinetic_energy() const {
  return Bounded(0.5) * inertia() * problem_.angular_velocity * problem_.angular_velocity;
}

/// Half the work of the centrifugal load, by Clapeyron's theorem: 2 pi q^2 (1 - nu)(7 + nu) R^6/(3 E).
Bounded RotatingDisk::strain_energy() const {
  const Bounded r2 = Bounded(problem_.radius) * problem_.radius;
  const Bounded value = Bounded(2) * pi * load_ * load_ * r2 * (Bounded(1) - nu_) * (Bounded(7) + nu_) /
                        (Bounded(3) * stiffness_);
  return bounded(value, Bounded(2) * value);  // a square of the stresses
}

}  // namespace plumbline::reference
