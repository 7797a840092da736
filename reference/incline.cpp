#include "reference/incline.hpp"

#include "reference/argument.hpp"

namespace plumbline::reference {

Incline::Incline(const InclineProblem& problem) : problem_(problem) {
  check_not_negative("slope", problem.slope);
  check_not_negative("friction", problem.friction);
  check_not_negative("rise", problem.rise);
  check_positive("gravity", problem.gravity);
}

Bounded Incline::across() const {
  const Bounded slope(problem_.slope);
  return Bounded(problem_.gravity) / sqrt(Bounded(1) + slope * slope);
}
Bounded Incline::along() const { return across() * problem_.slope; }

Bounded Incline::block_acceleration() const {  // [Goldstein 1.4]
  if (problem_.slope <= problem_.friction) return 0;
  return across() * (Bounded(problem_.slope) - problem_.friction);
}

Bounded Incline::disk_acceleration() const {  // m a = m g sin - F, (m R^2/2) w' = F R; rolling w' R = a, F = m g sin/3
  return disk_rolls() ? Bounded(2) / 3 * along() : block_acceleration();
}

Bounded Incline::disk_spin_up() const {
  return disk_rolls() ? disk_acceleration() : Bounded(2) * problem_.friction * across();
}

Bounded Incline::velocity_time(double time) const {
  check_not_negative("time", time);
  const Bounded rise(problem_.rise);
  if (time >= problem_.rise) return Bounded(time) - Bounded(0.5) * rise;
  const Bounded s = Bounded(time) / rise;
  return rise * s * s * s * (Bounded(1) - Bounded(0.5) * s);
}

Bounded Incline::way_time(double time) const {
  check_not_negative("time", time);
  const Bounded rise(problem_.rise), t(time);
  if (time >= problem_.rise) return Bounded(3) / 20 * rise * rise + Bounded(0.5) * t * (t - rise);
  const Bounded s = t / rise;
  return rise * rise * s * s * s * s * (Bounded(0.25) - s / 10);
}

Bounded Incline::block_friction_work(double time) const {  // the integral of mu g cos f a T1, T1' = f
  const Bounded t1 = velocity_time(time);
  return Bounded(0.5) * problem_.friction * across() * block_acceleration() * t1 * t1;
}

}  // namespace plumbline::reference
