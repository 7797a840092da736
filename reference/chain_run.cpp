#include "reference/chain_run.hpp"

#include <gsl/gsl_errno.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "reference/gsl_owned.hpp"
#include "reference/root.hpp"

namespace plumbline::reference {

struct ChainRun::System {
  ChainSettings settings;
  std::size_t nodes;
  gsl_odeiv2_system equations;
  Owned<gsl_odeiv2_step> step;
  Owned<gsl_odeiv2_control> control;
  Owned<gsl_odeiv2_evolve> evolve;

  explicit System(const ChainSettings& s)
      : settings(s),
        nodes(static_cast<std::size_t>(s.elements)),
        equations{&rate, nullptr, 4 * nodes, this},
        step(gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk8pd, 4 * nodes)),
        control(gsl_odeiv2_control_y_new(s.tolerance, 0)),
        evolve(gsl_odeiv2_evolve_alloc(4 * nodes)) {}
  System(const System&) = delete;
  System& operator=(const System&) = delete;

  /// Of node k, counted from 1 below the support, over the mass of the end.
  double mass(std::size_t k) const {
    const double element = settings.mass_ratio / settings.elements;
    return k == nodes ? 1 + 0.5 * element : element;
  }

  /// Pull of the element above node k on it, and its tension; y as in ChainRun::state_.
  double pull(const double y[], std::size_t k, double& along_x, double& along_y) const {
    const double above_x = k > 1 ? y[2 * k - 4] : 0, above_y = k > 1 ? y[2 * k - 3] : 0;
    const double dx = above_x - y[2 * k - 2], dy = above_y - y[2 * k - 1], length = std::hypot(dx, dy);
    double tension = settings.stiffness * (length * settings.elements - 1);  // E A (l/l0 - 1) (York, section 5.7)
    if (settings.one_way && tension < 0) tension = 0;
    along_x = tension * dx / length;
    along_y = tension * dy / length;
    return tension;
  }

  static int rate(double, const double y[], double dydt[], void* at) {
    const System& self = *static_cast<const System*>(at);
    const std::size_t velocities = 2 * self.nodes;
    double below_x = 0, below_y = 0;
    for (std::size_t k = self.nodes; k >= 1; --k) {
      double above_x = 0, above_y = 0;
      self.pull(y, k, above_x, above_y);
      const std::size_t x = 2 * k - 2;
      dydt[x] = y[velocities + x];
      dydt[x + 1] = y[velocities + x + 1];
      dydt[velocities + x] = (above_x - below_x) / self.mass(k);
      dydt[velocities + x + 1] = (above_y - below_y) / self.mass(k) - 1;
      below_x = above_x;
      below_y = above_y;
    }
    return GSL_SUCCESS;
  }
};

ChainRun::ChainRun(const ChainSettings& settings) : system_(std::make_unique<System>(settings)) {
  const std::size_t nodes = system_->nodes;
  state_.assign(4 * nodes, 0);
  for (std::size_t k = 1; k <= nodes; ++k) {
    state_[2 * k - 2] = settings.end_x * static_cast<double>(k) / settings.elements;
    state_[2 * k - 1] = settings.end_y * static_cast<double>(k) / settings.elements;
  }
  // the passage of a sound wave through an element
  step_ = std::sqrt(settings.mass_ratio / settings.stiffness) / settings.elements;
}

ChainRun::~ChainRun() = default;

void ChainRun::advance_to(double time) {
  gsl_odeiv2_evolve_reset(system_->evolve.get());
  gsl_odeiv2_step_reset(system_->step.get());
  while (time_ < time) {
    double step = step_;
    const int status = gsl_odeiv2_evolve_apply(system_->evolve.get(), system_->control.get(), system_->step.get(),
                                               &system_->equations, &time_, time, &step, state_.data());
    if (status != GSL_SUCCESS || !std::isfinite(state_[0])) throw std::domain_error("ChainRun: no step succeeds");
    if (time_ < time || step > step_) step_ = step;  // the last step before `time` may have been cut short
  }
}

double ChainRun::turning(bool swing) const { return swing ? x() * velocity_y() - y() * velocity_x() : velocity_y(); }

void ChainRun::advance_to_turn(bool swing) {
  const double stride = swing ? 0.05 : std::min(0.05, 0.1 / std::sqrt(system_->settings.stiffness));
  advance_to(time_ + 0.1 * stride);  // away from the last turn, or from rest
  const double sign = turning(swing) < 0 ? -1 : 1, latest = time_ + 1000;
  while (time_ < latest) {
    const double before = time_, step = step_;
    const std::vector<double> start = state_;
    auto past = [&](double time) {
      time_ = before;
      step_ = step;
      state_ = start;
      advance_to(time);
      return -sign * turning(swing);
    };
    if (past(before + stride) > 0) {
      past(brent_root(past, before, before + stride));
      return;
    }
  }
  throw std::domain_error("ChainRun: the motion does not turn");
}

double ChainRun::x() const { return state_[2 * system_->nodes - 2]; }
double ChainRun::y() const { return state_[2 * system_->nodes - 1]; }
double ChainRun::velocity_x() const { return state_[4 * system_->nodes - 2]; }
double ChainRun::velocity_y() const { return state_[4 * system_->nodes - 1]; }

double ChainRun::support_tension() const {
  double x = 0, y = 0;
  return system_->pull(state_.data(), 1, x, y);
}

double ChainRun::kinetic() const {
  double sum = 0;
  for (std::size_t k = 1; k <= system_->nodes; ++k) {
    const double vx = state_[2 * (system_->nodes + k) - 2], vy = state_[2 * (system_->nodes + k) - 1];
    sum += 0.5 * system_->mass(k) * (vx * vx + vy * vy);
  }
  return sum;
}

double ChainRun::elastic() const {
  double sum = 0, x = 0, y = 0;
  for (std::size_t k = 1; k <= system_->nodes; ++k) {
    const double tension = system_->pull(state_.data(), k, x, y);
    sum += 0.5 * tension * tension / (system_->settings.stiffness * system_->settings.elements);
  }
  return sum;
}

double ChainRun::potential() const {
  double sum = 0;
  for (std::size_t k = 1; k <= system_->nodes; ++k) sum += system_->mass(k) * state_[2 * k - 1];
  return sum;
}

}  // namespace plumbline::reference
