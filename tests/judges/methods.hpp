// Methods of lines from their coefficients, and splitting methods from the two flows that they compose.
#pragma once

#include <algorithm>
#include <functional>
#include <vector>

#include "kernel/stages.hpp"

namespace plumbline::judged {

// Explicit Runge-Kutta: the rows of a below the diagonal, the first one empty; the weights b.
struct Tableau {
  std::vector<std::vector<double>> a;
  std::vector<double> b;
};

// What is made of each rate before it is used.
using Altered = std::function<State(Stages& mpm, State rate)>;

inline void runge_kutta(Stages& mpm, double dt, const Tableau& of, const Altered& altered = {}) {
  const State y = mpm.state();
  std::vector<State> rates;
  for (const std::vector<double>& row : of.a) {
    State at = y;
    for (std::size_t j = 0; j < row.size(); ++j) at += dt * row[j] * rates[j];
    if (!row.empty()) mpm.set_state(at);
    rates.push_back(altered ? altered(mpm, mpm.rate()) : mpm.rate());
  }
  State end = y;
  for (std::size_t j = 0; j < rates.size(); ++j) end += dt * of.b[j] * rates[j];
  mpm.set_state(end);
}

inline const Tableau& classical() {
  static const Tableau rk4{{{}, {0.5}, {0, 0.5}, {0, 0, 1}}, {1.0 / 6, 2.0 / 6, 2.0 / 6, 1.0 / 6}};
  return rk4;
}

inline const Tableau& kutta3() {
  static const Tableau third{{{}, {0.5}, {-1, 2}}, {1.0 / 6, 4.0 / 6, 1.0 / 6}};
  return third;
}

// Explicit, beta = 0: of second order for gamma = 1/2, below which oscillations grow and above which they decay.
inline void newmark(Stages& mpm, double dt, double gamma) {
  const State y = mpm.state(), accelerations = mpm.velocities_of(mpm.rate());
  mpm.set_state(y + dt / 2 * accelerations);
  const State moving = mpm.rate();
  mpm.set_state(y + dt * (moving + -1.0 * mpm.velocities_of(moving)));
  const State moved = mpm.state(), later = mpm.velocities_of(mpm.rate());
  mpm.set_state(moved + (1 - gamma) * dt * accelerations + gamma * dt * later);
}

// Velocities change by the forces of where points stand; these and the strains stay.
inline void kick(Stages& mpm, double dt) {
  mpm.locate_points();
  mpm.map_mass_and_momentum();
  mpm.evaluate_stress(NodalVelocity::start);
  mpm.map_forces();
  mpm.advance_momentum(dt);
  mpm.kick_points(dt);
}

// Places and strains change by the velocities of the nodes; those of the points stay, where no transfer filters them.
inline void drift(Stages& mpm, double dt) {
  mpm.locate_points();
  mpm.map_mass_and_momentum();
  mpm.map_forces();
  mpm.advance_momentum(0.0);
  mpm.move_points(dt);
  mpm.strain_points(dt, NodalVelocity::end);
}

// Drifts and kicks in turns, a drift first, by these shares of the step; zero: none.
inline void split(Stages& mpm, double dt, const std::vector<double>& shares) {
  for (std::size_t k = 0; k < shares.size(); ++k) {
    if (shares[k] != 0) (k % 2 == 0 ? drift : kick)(mpm, shares[k] * dt);
  }
}

// Shares of half drift, kick, half drift, over the given parts of the step one after the other.
inline std::vector<double> composed(const std::vector<double>& parts) {
  std::vector<double> shares{0};
  for (const double part : parts) {
    shares.back() += part / 2;
    shares.push_back(part);
    shares.push_back(part / 2);
  }
  return shares;
}

// Slopes of earlier steps, the newest first. A method of several steps starts from a history that Kutta's third-order method
// finds by going back.
class History {
 public:
  explicit History(std::size_t length) : slopes_(length) {}

  // (number of earlier slopes) + 1 of them: that of now and those of steps of dt before. Keeps them for the next step.
  std::vector<State> with_now(Stages& mpm, double dt) {
    const State y = mpm.state();
    std::vector<State> all{mpm.rate()};
    if (slopes_.front().values.size() != y.values.size()) {
      for (State& slope : slopes_) {
        runge_kutta(mpm, -dt, kutta3());
        slope = mpm.rate();
      }
      mpm.set_state(y);
    }
    all.insert(all.end(), slopes_.begin(), slopes_.end());
    std::copy(all.begin(), all.end() - 1, slopes_.begin());
    return all;
  }

  std::vector<State*> memory() {
    std::vector<State*> all;
    for (State& slope : slopes_) all.push_back(&slope);
    return all;
  }

 private:
  std::vector<State> slopes_;
};

inline void adams_bashforth(Stages& mpm, double dt, History& history, const std::vector<double>& weights) {
  State y = mpm.state();
  const std::vector<State> slopes = history.with_now(mpm, dt);
  for (std::size_t k = 0; k < slopes.size(); ++k) y += dt * weights[k] * slopes[k];
  mpm.set_state(y);
}

}  // namespace plumbline::judged
