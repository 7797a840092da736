#include "reference/bar_impact.hpp"

#include "reference/argument.hpp"

namespace plumbline::reference {
namespace {

/// From the contact on: both bars without the gap, on [0, 2 L].
BarRiemannProblem joined(const BarImpactProblem& p) {
  BarRiemannProblem pair;
  pair.youngs_modulus = p.youngs_modulus;
  pair.density = p.density;
  pair.area = p.area;
  pair.length = 2 * p.length;
  pair.pieces = {{0, p.velocity_left, 0}, {p.length, p.velocity_right, 0}};
  return pair;
}

BarImpactProblem checked(const BarImpactProblem& p) {
  check_positive("length", p.length);
  check_finite("left", p.left);
  check_not_negative("gap", p.gap);
  check_finite("velocity_left", p.velocity_left);
  check_finite("velocity_right", p.velocity_right);
  if (!(p.velocity_left > p.velocity_right)) {
    throw ParameterError("velocity_left", p.velocity_left, "above velocity_right");
  }
  return p;
}

BarState hulled(const BarState& a, const BarState& b) {
  return {hull(a.displacement, b.displacement), hull(a.velocity, b.velocity), hull(a.stress, b.stress)};
}

}  // namespace

BarImpact::BarImpact(const BarImpactProblem& problem) : problem_(checked(problem)), joined_(joined(problem)) {
  touch_ = Bounded(problem.gap) / (Bounded(problem.velocity_left) - problem.velocity_right);
  if (problem.gap == 0) touch_ = 0.0;
  lasts_ = joined_.transit_time();
}

Bounded BarImpact::contact_stress() const {
  const Bounded closing = Bounded(problem_.velocity_left) - problem_.velocity_right;
  return -(Bounded(0.5) * joined_.impedance() * closing);
}

Bounded BarImpact::velocity_after(ImpactBar bar) const {
  return bar == ImpactBar::left ? problem_.velocity_right : problem_.velocity_left;
}

Bounded BarImpact::centre_of_mass_velocity() const {
  return Bounded(0.5) * (Bounded(problem_.velocity_left) + problem_.velocity_right);
}

BarState BarImpact::before(ImpactBar bar, Bounded time) const {
  const double v = bar == ImpactBar::left ? problem_.velocity_left : problem_.velocity_right;
  return {Bounded(v) * time, v, 0.0};
}

BarState BarImpact::during(ImpactBar bar, Bounded place, Bounded since) const {
  BarState state = joined_.state(place, since);
  state.displacement = state.displacement + before(bar, touch_).displacement;
  return state;
}

// In the time 2 L/c of the contact each particle sees both invariants of the whole pair pass: it moves by the mean.
BarState BarImpact::after(ImpactBar bar, Bounded since) const {
  const Bounded moved = before(bar, touch_).displacement + centre_of_mass_velocity() * lasts_;
  return {moved + velocity_after(bar) * since, velocity_after(bar), 0.0};
}

BarState BarImpact::state(ImpactBar bar, double x, double time) const {
  const double L = problem_.length, least = bar == ImpactBar::left ? 0 : L;
  Bounded place = Bounded(x) - problem_.left;
  if (bar == ImpactBar::right) place = place - problem_.gap;
  const double margin = place.bound + 4 * rounding::unit * (std::abs(problem_.left) + problem_.gap + L);
  if (!(place.value >= least - margin && place.value <= least + L + margin)) {
    throw ParameterError("position", x, "inside the bar");
  }
  return at(bar, place, time);
}

BarState BarImpact::state_from_contact(ImpactBar bar, double distance, double time) const {
  check_within("distance", distance, 0, problem_.length);
  const Bounded L(problem_.length);
  return at(bar, bar == ImpactBar::left ? L - distance : L + distance, time);
}

BarState BarImpact::at(ImpactBar bar, Bounded place, double time) const {
  check_not_negative("time", time);
  const Bounded since = Bounded(time) - touch_, left = since - lasts_;
  if (certainly_below(since, 0.0)) return before(bar, time);
  if (certainly_below(0.0, left)) return after(bar, left);
  const Bounded clipped(std::max(0.0, since.value), since.bound);
  const BarState touching = during(bar, place, clipped);
  if (certainly_below(0.0, since) && certainly_below(left, 0.0)) return touching;
  return since.value < lasts_.value / 2 ? hulled(touching, before(bar, time)) : hulled(touching, after(bar, left));
}

Bounded BarImpact::strain_energy(double time) const {
  check_not_negative("time", time);
  const Bounded since = Bounded(time) - touch_, left = lasts_ - since;
  const double spent = std::min(since.value, left.value), margin = std::max(since.bound, left.bound);
  if (!(spent + margin > 0)) return 0.0;
  const Bounded running(std::max(0.0, spent), margin);  // the fronts run out and back
  const Bounded volume = Bounded(2) * problem_.area * wave_speed() * running;
  return Bounded(0.5) * contact_stress() * contact_stress() / problem_.youngs_modulus * volume;
}

Bounded BarImpact::kinetic_energy(double time) const { return joined_.energy() - strain_energy(time); }

}  // namespace plumbline::reference
