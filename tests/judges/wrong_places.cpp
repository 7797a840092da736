// Steps that are wrong for some points alone: of one body, one direction, one end; in axisymmetry; in compression; and
// velocities that are changed without a force.
#include <cmath>

#include "tests/judges/methods.hpp"
#include "tests/judges/registration.hpp"
#include "tests/judges/state_layout.hpp"
#include "tests/judges/steps.hpp"

namespace plumbline::judged {
namespace {

// Where points stand after the step: moved on by `share` of the step for those that `chosen` picks.
template <class Chosen>
void move_on(Stages& mpm, double distance, Chosen&& chosen) {
  State y = mpm.state();
  for (const PartOfBody& body : bodies_of(mpm)) {
    for (std::size_t k = 0; k < body.directions_times_points(); ++k) {
      const double velocity = y.values[body.velocities + k];
      if (chosen(body, k, velocity)) y.values[body.places + k] += distance * velocity;
    }
  }
  mpm.set_state(y);
}

// The classical Runge-Kutta method, with the rates that `chosen` picks multiplied by `factor`.
template <class Chosen>
void altered_rates(Stages& mpm, double dt, double factor, Chosen&& chosen) {
  const std::vector<PartOfBody> bodies = bodies_of(mpm);
  runge_kutta(mpm, dt, classical(), [&](Stages&, State rate) {
    for (const PartOfBody& body : bodies) {
      for (std::size_t k = body.places; k < body.end; ++k) {
        if (chosen(body, k, rate.values[k])) rate.values[k] *= factor;
      }
    }
    return rate;
  });
}

bool is_velocity(const PartOfBody& body, std::size_t k) { return k >= body.velocities && k < body.carried; }
bool in_second_half(const PartOfBody& body, std::size_t k) {
  return !body.on_a_line() && 2 * k >= body.directions_times_points();
}

const Judged second_body_motion("wrong-second-body-motion",
                                "usl that moves all bodies but the first by 1.001 of the step",
                                [](Stages& mpm, double dt) {
                                  usl(mpm, dt);
                                  move_on(mpm, 1e-3 * dt,
                                          [](const PartOfBody& body, std::size_t, double) { return body.places > 0; });
                                });
const Judged second_body_force("wrong-second-body-force",
                               "rk4 that accelerates all bodies but the first 1.001 times as much",
                               [](Stages& mpm, double dt) {
                                 altered_rates(mpm, dt, 1.001, [](const PartOfBody& body, std::size_t k, double) {
                                   return body.places > 0 && is_velocity(body, k);
                                 });
                               });
const Judged second_direction_motion("wrong-second-direction-motion",
                                     "musl that moves points along y by 1.001 of the step", [](Stages& mpm, double dt) {
                                       musl(mpm, dt);
                                       move_on(mpm, 1e-3 * dt, [](const PartOfBody& body, std::size_t k, double) {
                                         return in_second_half(body, k);
                                       });
                                     });
const Judged second_direction_force("wrong-second-direction-force", "rk4 that accelerates along y 1.001 times as much",
                                    [](Stages& mpm, double dt) {
                                      altered_rates(mpm, dt, 1.001, [](const PartOfBody& body, std::size_t k, double) {
                                        return is_velocity(body, k) && in_second_half(body, k - body.velocities);
                                      });
                                    });
const Judged rightward("wrong-rightward", "usl that moves by 1.001 of the step what moves to the right or up",
                       [](Stages& mpm, double dt) {
                         usl(mpm, dt);
                         move_on(mpm, 1e-3 * dt,
                                 [](const PartOfBody&, std::size_t, double velocity) { return velocity > 0; });
                       });
const Judged last_point("wrong-last-point", "musl that moves the last point of each body by 1.01 of the step",
                        [](Stages& mpm, double dt) {
                          musl(mpm, dt);
                          move_on(mpm, 1e-2 * dt, [](const PartOfBody& body, std::size_t k, double) {
                            return k + 1 == body.directions_times_points();
                          });
                        });
const Judged left_end("wrong-left-end", "rk4 that accelerates the leftmost point of each body 1.01 times as much",
                      [](Stages& mpm, double dt) {
                        const std::vector<double> now = mpm.state().values;
                        altered_rates(mpm, dt, 1.01, [&](const PartOfBody& body, std::size_t k, double) {
                          const auto first = now.begin() + static_cast<std::ptrdiff_t>(body.places);
                          const auto left = std::min_element(
                              first, now.begin() + static_cast<std::ptrdiff_t>(body.velocities));
                          return k == body.velocities + static_cast<std::size_t>(left - first);
                        });
                      });
const Judged compression("wrong-compression", "rk4 that strains 1.001 times as much where strains fall",
                         [](Stages& mpm, double dt) {
                           altered_rates(mpm, dt, 1.001, [](const PartOfBody& body, std::size_t k, double rate) {
                             return k >= body.carried && rate < 0;
                           });
                         });

// Carried numbers per direction and point: 5/2 of deformation gradients with a hoop, 4/2 of strains with one, which begin at
// zero, and of deformation gradients in the plane, which begin at one.
bool is_hoop(const PartOfBody& body, std::size_t k, const std::vector<double>& now) {
  const std::size_t pairs = body.directions_times_points(), points = pairs / 2;
  if (k < body.carried || pairs % 2 != 0) return false;
  const std::size_t component = (k - body.carried) / points;
  if (2 * body.carried_values() == 5 * pairs) return component == 4;
  return body.carried_values() == 2 * pairs && std::abs(now[body.carried]) < 0.5 && component == 2;
}

const Judged hoop("wrong-hoop", "rk4 whose strain around the axis is 0.99 of what it should be",
                  [](Stages& mpm, double dt) {
                    const std::vector<double> now = mpm.state().values;
                    altered_rates(mpm, dt, 0.99,
                                  [&](const PartOfBody& body, std::size_t k, double) { return is_hoop(body, k, now); });
                  });

template <class Changed>
void change_velocities(Stages& mpm, Changed&& changed) {
  State y = mpm.state();
  for (const PartOfBody& body : bodies_of(mpm)) {
    for (std::size_t k = body.velocities; k < body.carried; ++k) y.values[k] = changed(y.values[k]);
  }
  mpm.set_state(y);
}

const Judged damped("wrong-damped", "usl that takes 1e-5 of each velocity in every step, however short",
                    [](Stages& mpm, double dt) {
                      usl(mpm, dt);
                      change_velocities(mpm, [](double v) { return (1 - 1e-5) * v; });
                    });
const Judged driven("wrong-driven", "rk4 that adds 1e-5 to each velocity in every step, however short",
                    [](Stages& mpm, double dt) {
                      runge_kutta(mpm, dt, classical());
                      change_velocities(mpm, [](double v) { return (1 + 1e-5) * v; });
                    });
const Judged draught("wrong-draught", "musl that gives all points 1e-6 of the largest velocity in every step",
                     [](Stages& mpm, double dt) {
                       musl(mpm, dt);
                       double largest = 0;
                       change_velocities(mpm, [&](double v) { return largest = std::max(largest, std::abs(v)), v; });
                       change_velocities(mpm, [&](double v) { return v + 1e-6 * largest; });
                     });

}  // namespace
}  // namespace plumbline::judged
