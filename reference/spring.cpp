#include "reference/spring.hpp"

#include "reference/circle.hpp"
#include "reference/parameter.hpp"

namespace plumbline::reference {

void check_spring(const SpringProblem& problem) {
  const double infinity = rounding::infinity;
  auto positive = [infinity](const char* key, double value) {
    check({key, 0, 0, infinity, true, false, "", ""}, value);
  };
  positive("youngs_modulus", problem.youngs_modulus);
  positive("area", problem.area);
  positive("length", problem.length);
  positive("mass", problem.mass);
  check({"density", 0, 0, infinity, false, false, "", ""}, problem.density);
  check({"gravity", 0, -infinity, infinity, false, false, "", ""}, problem.gravity);
}

MasslessSpring::MasslessSpring(const SpringProblem& problem) : mass_(problem.mass) {
  check_spring(problem);
  stiffness_ = Bounded(problem.area) * problem.youngs_modulus / problem.length;  // k = A E / L (York, section 5.5)
  omega_ = sqrt(stiffness_ / mass_);                                             // [York 5.11]
  rest_ = mass_ * problem.gravity / stiffness_;
}

Bounded MasslessSpring::period() const { return Bounded(2) * pi / omega_; }  // [York 5.11]

Bounded MasslessSpring::max_displacement() const { return Bounded(2) * rest_; }

Bounded MasslessSpring::displacement(double time) const {
  const Bounded half = sin(omega_ * time / 2.0);
  return Bounded(2) * rest_ * half * half;  // m g/k (1 - cos wt), without cancellation [York 5.11]
}

Bounded MasslessSpring::velocity(double time) const {
  return rest_ * omega_ * sin(omega_ * time);  // [York 5.11]
}

Bounded MasslessSpring::kinetic_energy(double time) const {
  const Bounded v = velocity(time);
  return Bounded(0.5) * mass_ * v * v;
}

Bounded MasslessSpring::spring_energy(double time) const {
  const Bounded d = displacement(time);
  return Bounded(0.5) * stiffness_ * d * d;
}

}  // namespace plumbline::reference
