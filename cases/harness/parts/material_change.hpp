// How fast points change that are strained.
#pragma once

#include "cases/harness/parts/material_waves.hpp"

namespace plumbline {

// Of what is read of points that are strained at a rate: by the difference from -dt to dt; of points that may flow one way and
// spring back the other forwards alone, by dt/2 and dt, with errors of dt^2 as well.
class Change {
 public:
  Change(const MaterialProbe& probe, const Straining& rate)
      : forwards_(probe.material().dissipates()),
        now_(probe),
        far_(probe.strained(rate, dt)),
        other_(probe.strained(rate, forwards_ ? dt / 2 : -dt)) {}

  // read: a number of a probe.
  template <class Read>
  double of(const Read& read) const {
    if (!forwards_) return (read(far_) - read(other_)) / (2 * dt);
    const double now = read(now_);  // differences from it: what does not change has no rounding
    return (4 * (read(other_) - now) - (read(far_) - now)) / dt;
  }

 private:
  static constexpr double dt = step_of_difference;
  bool forwards_;
  MaterialProbe now_, far_, other_;
};

}  // namespace plumbline
