#include "reference/two_disks.hpp"

#include "reference/argument.hpp"
#include "reference/circle.hpp"

namespace plumbline::reference {

TwoDisks::TwoDisks(const TwoDisksProblem& problem) : problem_(problem) {
  check_finite("left_x", problem.left_x);
  check_finite("left_y", problem.left_y);
  check_finite("right_x", problem.right_x);
  check_finite("right_y", problem.right_y);
  check_positive("radius", problem.radius);
  check_positive("youngs_modulus", problem.youngs_modulus);
  check({"poisson", 0, -1, 0.5, true, true, "1", ""}, problem.poisson);
  check_positive("density", problem.density);
  check_positive("speed", problem.speed);
  if (!certainly_below(0.0, gap())) throw ParameterError("radius", problem.radius, "less than half the distance");
}

Bounded TwoDisks::distance() const {
  const Bounded dx = Bounded(problem_.right_x) - problem_.left_x, dy = Bounded(problem_.right_y) - problem_.left_y;
  return sqrt(dx * dx + dy * dy);
}

Bounded TwoDisks::mass() const { return pi * problem_.radius * problem_.radius * problem_.density; }
Bounded TwoDisks::gap() const { return distance() - Bounded(2) * problem_.radius; }
Bounded TwoDisks::contact_time() const { return gap() / (Bounded(2) * problem_.speed); }
Bounded TwoDisks::contact_x() const { return Bounded(0.5) * (Bounded(problem_.left_x) + problem_.right_x); }
Bounded TwoDisks::contact_y() const { return Bounded(0.5) * (Bounded(problem_.left_y) + problem_.right_y); }
Bounded TwoDisks::momentum_of_one() const { return mass() * problem_.speed; }
Bounded TwoDisks::energy() const { return momentum_of_one() * problem_.speed; }  // two halves

Bounded TwoDisks::wave_speed() const {  // c^2 = E (1 - nu)/((1 + nu)(1 - 2 nu) rho)
  const Bounded nu(problem_.poisson), one(1);
  const Bounded modulus = Bounded(problem_.youngs_modulus) * (one - nu) / ((one + nu) * (one - Bounded(2) * nu));
  return sqrt(modulus / problem_.density);
}

Bounded TwoDisks::crossing_time() const { return Bounded(2) * problem_.radius / wave_speed(); }

}  // namespace plumbline::reference
