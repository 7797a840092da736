#include "reference/swing.hpp"

#include <gsl/gsl_errno.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "reference/gsl_owned.hpp"
#include "reference/root.hpp"

namespace plumbline::reference {

struct Swing::Stepper {
  double kappa = 0;
  bool carries = true;  // the string pulls (or pushes)
  gsl_odeiv2_system system{&rate, nullptr, 4, this};
  Owned<gsl_odeiv2_step> step{gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk8pd, 4)};

  Stepper() = default;
  Stepper(const Stepper&) = delete;
  Stepper& operator=(const Stepper&) = delete;

  static int rate(double, const double y[], double dydt[], void* at) {
    const Stepper& self = *static_cast<const Stepper*>(at);
    const double length = 1 + y[0] / self.kappa, stretching = y[1] / self.kappa;
    const double pull = self.carries ? y[0] : 0;
    dydt[0] = y[1];
    dydt[1] = self.kappa * (length * y[3] * y[3] + std::cos(y[2]) - pull);
    dydt[2] = y[3];
    dydt[3] = -(std::sin(y[2]) + 2 * stretching * y[3]) / length;
    return GSL_SUCCESS;
  }
};

Swing::Swing(double kappa, bool one_way, SwingState start, double step)
    : stepper_(std::make_unique<Stepper>()),
      step_(step),
      one_way_(one_way),
      taut_(!one_way || start[0] >= 0),
      state_(start) {
  stepper_->kappa = kappa;
  stepper_->carries = taut_;
}

Swing::~Swing() = default;

SwingState Swing::after(double step) const {
  SwingState y = state_, error;
  gsl_odeiv2_step_reset(stepper_->step.get());
  gsl_odeiv2_step_apply(stepper_->step.get(), time_, step, y.data(), error.data(), nullptr, nullptr, &stepper_->system);
  for (double value : y) {
    if (!std::isfinite(value)) throw std::domain_error("Swing: the integration left the finite numbers");
  }
  return y;
}

/// Where sign times the component rises through zero between two steps from here; `low` where it is there already.
double Swing::root(int index, double low, double high, double sign) const {
  auto f = [&](double step) { return sign * after(step)[static_cast<std::size_t>(index)]; };
  if (!(f(low) < 0)) return low;
  if (!(f(high) > 0)) return high;
  return brent_root(f, low, high);
}

/// The step at which the string stops or begins to carry, at most `step`; larger than it if none does. A visit to the
/// other side within the step shows by the rate of s changing its sign.
double Swing::until_change_of_string(double step, const SwingState& end) const {
  const double never = 2 * step, side = taut_ ? 1 : -1;
  double low = 0, high = step, there = side * end[0];
  if (side * state_[1] < 0 && side * end[1] > 0) {  // nearest to the other side in between
    const double middle = root(1, 0, step, side), nearest = side * after(middle)[0];
    if (nearest < 0) {
      high = middle;
      there = nearest;
    }
  }
  if (!(there < 0)) return never;
  if (side * state_[0] <= 0) {  // starts on the border: away from it first, unless it turns here
    if (!(side * state_[1] > 0)) return 0;
    low = root(1, 0, high, -side);
  }
  return root(0, low, high, -side);
}

Swing::Plan Swing::plan(double longest) const {
  const double step = std::min(step_, longest);
  const SwingState end = after(step);
  if (!one_way_) return {step, false, end};
  const double change = until_change_of_string(step, end);
  if (change > step) return {step, false, end};
  SwingState there = after(change);
  there[0] = 0;
  return {change, true, there};
}

void Swing::take(const Plan& plan) {
  state_ = plan.end;
  time_ += plan.step;
  ++steps_;
  if (plan.changes_string) taut_ = !taut_;
  stepper_->carries = taut_;
}

void Swing::advance_to(double time) {
  while (time_ < time) {
    const double left = time - time_;
    const Plan next = plan(left);
    take(next);
    if (next.step == left) time_ = time;
  }
}

void Swing::advance_to_change(int index) {
  const auto i = static_cast<std::size_t>(index);
  double sign = state_[i];
  while (true) {
    const Plan next = plan(step_);
    const double ahead = next.end[i];
    if (sign * ahead < 0) {
      const double to_root = root(index, 0, next.step, ahead > 0 ? 1 : -1);
      take({to_root, false, after(to_root)});
      state_[i] = 0;
      return;
    }
    if (sign == 0) sign = ahead;
    take(next);
  }
}

}  // namespace plumbline::reference
