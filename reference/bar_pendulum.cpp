#include "reference/bar_pendulum.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "reference/argument.hpp"

namespace plumbline::reference {
namespace {

class BarRow {
 public:
  BarRow(const ElasticPendulumProblem& of, int elements) : of_(of), elements_(static_cast<std::size_t>(elements)) {
    const double x = of.bob_x - of.pivot_x, y = of.bob_y - of.pivot_y;
    rest_ = std::hypot(x, y) / (1 + of.strain) / elements;
    for (std::size_t n = 0; n <= elements_; ++n) {
      const double at = static_cast<double>(n) / elements;
      place_.push_back({of.pivot_x + at * x, of.pivot_y + at * y});
    }
    velocity_.assign(elements_ + 1, {0, 0});
    mass_.assign(elements_ + 1, of.density * of.area * rest_);
    mass_.back() = 0.5 * mass_.back() + of.mass;
  }

  double longest_step() const { return 0.5 * rest_ * std::sqrt(of_.density / of_.youngs_modulus); }
  const BarNodes& place() const { return place_; }

  // Velocities stand half a step behind places; the first step starts from rest.
  void advance(double dt) {
    BarNodes force(elements_ + 1, {0, 0});
    for (std::size_t e = 0; e < elements_; ++e) {
      const double x = place_[e + 1][0] - place_[e][0], y = place_[e + 1][1] - place_[e][1];
      const double length = std::hypot(x, y), strain = length / rest_ - 1;
      if (of_.one_way && strain < 0) continue;
      const double tension = of_.youngs_modulus * of_.area * strain / length;
      force[e][0] += tension * x;
      force[e][1] += tension * y;
      force[e + 1][0] -= tension * x;
      force[e + 1][1] -= tension * y;
    }
    const double since = 0.5 * (before_ + dt);
    for (std::size_t n = 1; n <= elements_; ++n) {
      velocity_[n][0] += since * force[n][0] / mass_[n];
      velocity_[n][1] += since * (force[n][1] / mass_[n] - of_.gravity);
      for (std::size_t d = 0; d < 2; ++d) place_[n][d] += dt * velocity_[n][d];
    }
    before_ = dt;
  }

 private:
  ElasticPendulumProblem of_;
  std::size_t elements_;
  double rest_ = 0, before_ = 0;
  BarNodes place_, velocity_;
  std::vector<double> mass_;
};

}  // namespace

std::vector<BarNodes> bar_pendulum(const ElasticPendulumProblem& problem, int elements,
                                   const std::vector<double>& times) {
  check_positive("density", problem.density);
  check_positive("area", problem.area);
  check_positive("youngs_modulus", problem.youngs_modulus);
  check_not_negative("mass", problem.mass);
  check({"elements", 0, 1, 1e6, false, false, "", ""}, elements);
  BarRow bars(problem, elements);
  std::vector<BarNodes> all;
  double time = 0;
  for (const double until : times) {
    check({"times", 0, time, rounding::infinity, false, true, "", ""}, until);
    const auto steps = static_cast<long>(std::ceil((until - time) / bars.longest_step()));
    for (long k = 0; k < steps; ++k) bars.advance((until - time) / static_cast<double>(steps));
    time = until;
    all.push_back(bars.place());
  }
  return all;
}

}  // namespace plumbline::reference
