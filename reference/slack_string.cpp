#include "reference/slack_string.hpp"

#include "reference/argument.hpp"
#include "reference/circle.hpp"
#include "reference/elementary.hpp"

namespace plumbline::reference {

SlackString::SlackString(const SlackStringProblem& problem) : problem_(problem) {
  check_positive("youngs_modulus", problem.youngs_modulus);
  check_positive("area", problem.area);
  check_positive("length", problem.length);
  check_positive("mass", problem.mass);
  check_positive("gravity", problem.gravity);
  check_not_negative("slack", problem.slack);
  const Bounded g(problem.gravity), slack(problem.slack);
  stiffness_ = Bounded(problem.youngs_modulus) * problem.area / problem.length;
  omega_ = sqrt(stiffness_ / problem.mass);
  rest_ = Bounded(problem.mass) * g / stiffness_;
  if (problem.slack > 0) {
    speed_ = sqrt(Bounded(2) * g * slack);
    fall_ = sqrt(Bounded(2) * slack / g);
  }
  taut_ = Bounded(2) / omega_ * (pi - atan(speed_ * omega_ / g));
  period_ = Bounded(2) * fall_ + taut_;
}

Bounded SlackString::max_displacement() const {
  const Bounded swing = speed_ / omega_;
  return Bounded(problem_.slack) + rest_ + sqrt(rest_ * rest_ + swing * swing);
}

Bounded SlackString::max_tension() const {
  const Bounded swing = speed_ / omega_;
  return stiffness_ * (rest_ + sqrt(rest_ * rest_ + swing * swing));
}

// Before the start of a cycle the mass rises as it falls after it: the sign of the time is the sign of the velocity.
SlackString::State SlackString::falling(Bounded time) const {
  const Bounded g(problem_.gravity);
  return {Bounded(0.5) * g * time * time, g * time, 0.0};
}

SlackString::State SlackString::taut(Bounded since) const {
  const Bounded angle = omega_ * since, half = sin(angle / 2.0);
  Bounded stretch = Bounded(2) * rest_ * half * half + speed_ / omega_ * sin(angle);
  stretch.value = std::max(stretch.value, 0.0);
  return {Bounded(problem_.slack) + stretch, rest_ * omega_ * sin(angle) + speed_ * cos(angle), stretch};
}

SlackString::State SlackString::state(double time) const {
  check_not_negative("time", time);
  const double cycles = std::floor(time / period_.value);
  const Bounded phase = cycles == 0 ? Bounded(time) : Bounded(time) - Bounded(cycles) * period_;
  const Bounded to_next = period_ - phase;
  auto hulled = [](const State& a, const State& b) {
    return State{hull(a.displacement, b.displacement), hull(a.velocity, b.velocity), hull(a.stretch, b.stretch)};
  };
  const bool first_half = phase.value < to_next.value;
  const State slack = first_half ? falling(phase) : falling(-to_next);
  const Bounded from_start = first_half ? phase : to_next;
  if (certainly_below(from_start, fall_)) return slack;
  const State tight = taut(phase - fall_);
  if (certainly_below(fall_, from_start)) return tight;
  return from_start.value < fall_.value ? hulled(slack, tight) : hulled(tight, slack);
}

Bounded SlackString::displacement(double time) const { return state(time).displacement; }

Bounded SlackString::velocity(double time) const { return state(time).velocity; }

Bounded SlackString::tension(double time) const { return stiffness_ * state(time).stretch; }

Bounded SlackString::kinetic_energy(double time) const {
  const Bounded v = velocity(time);
  return Bounded(0.5) * problem_.mass * v * v;
}

Bounded SlackString::string_energy(double time) const {
  const Bounded stretch = state(time).stretch;
  return Bounded(0.5) * stiffness_ * stretch * stretch;
}

}  // namespace plumbline::reference
