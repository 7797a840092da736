// The steps that most of the corpus is made from, stage by stage, with factors that a right step has at one.
#pragma once

#include "kernel/stages.hpp"

namespace plumbline::judged {

// What strain, velocity and place change by, over what they should change by.
struct Factors {
  double strain = 1, force = 1, motion = 1;
};

inline void map_and_accelerate(Stages& mpm, double dt) {
  mpm.locate_points();
  mpm.map_mass_and_momentum();
  mpm.map_forces();
  mpm.advance_momentum(dt);
}

inline void musl(Stages& mpm, double dt, const Factors& by = {}) {
  map_and_accelerate(mpm, by.force * dt);
  mpm.move_points(by.motion * dt);
  mpm.map_momentum();
  mpm.update_stress(by.strain * dt);
}

inline void usl(Stages& mpm, double dt, const Factors& by = {}) {
  map_and_accelerate(mpm, by.force * dt);
  mpm.move_points(by.motion * dt);
  mpm.update_stress(by.strain * dt);
}

inline void usf(Stages& mpm, double dt, const Factors& by = {}) {
  mpm.locate_points();
  mpm.map_mass_and_momentum();
  mpm.update_stress(by.strain * dt);
  mpm.map_forces();
  mpm.advance_momentum(by.force * dt);
  mpm.move_points(by.motion * dt);
}

// first, last: the share of the strain before and after the momentum update.
inline void usavg(Stages& mpm, double dt, double first, double last, const Factors& by = {}) {
  mpm.locate_points();
  mpm.map_mass_and_momentum();
  mpm.update_stress(first * dt);
  mpm.map_forces();
  mpm.advance_momentum(by.force * dt);
  mpm.move_points(by.motion * dt);
  mpm.map_momentum();
  mpm.update_stress(last * dt);
}

inline void midpoint(Stages& mpm, double dt, const Factors& by = {}) {
  map_and_accelerate(mpm, dt);
  mpm.predict_stress(dt / 2, NodalVelocity::midpoint);
  mpm.map_forces();
  mpm.advance_momentum(by.force * dt);
  mpm.move_points(by.motion * dt, NodalVelocity::midpoint);
  mpm.update_stress(by.strain * dt, NodalVelocity::midpoint);
}

// first, last: the share of the drift before and after the kick. The stress is the one of `ahead` steps later.
inline void leapfrog(Stages& mpm, double dt, double first, double ahead, double last, const Factors& by = {}) {
  mpm.drift_points(first * dt);
  mpm.locate_points();
  mpm.map_mass_and_momentum();
  mpm.predict_stress(ahead * dt);
  mpm.map_forces();
  mpm.advance_momentum(by.force * dt);
  mpm.kick_points(dt);
  mpm.drift_points(last * dt);
  mpm.strain_points(dt, NodalVelocity::midpoint);
  mpm.return_transfer_loss();
}

// The same with the last stages one by one; losses: how often what the maps took is given back.
inline void leapfrog_apart(Stages& mpm, double dt, int losses, const Factors& by = {}) {
  mpm.drift_points(dt / 2);
  mpm.locate_points();
  mpm.map_mass_and_momentum();
  mpm.predict_stress(dt / 2);
  mpm.map_forces();
  mpm.advance_momentum(by.force * dt);
  mpm.kick_points(dt);
  mpm.strain_points(by.strain * dt, NodalVelocity::midpoint);
  for (int k = 0; k < losses; ++k) mpm.return_transfer_loss();
  mpm.drift_points(dt / 2);
}

}  // namespace plumbline::judged
