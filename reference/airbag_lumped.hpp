#pragma once
// A rigid flat probe flies at a gas-filled bag that lies on a plate (York, section 6.3), with the bag and its gas
// lumped into one pressure: adiabatic ideal gas, p V^gamma constant, in an InextensibleBag that takes at each gap the
// shape of largest volume. With x the way since first touch, D = V0 - V the volume pressed out, and the pressure p_a
// outside:
//   m x'' = -(p - p_a) pi b^2,   W(D) = p0 V0/(gamma - 1) ((1 - D/V0)^(1 - gamma) - 1) - p_a D = m (v0^2 - v^2)/2.
// No gravity (York has none). The motion is symmetric about the largest displacement: the probe leaves as fast as it
// came.
//
// What it bounds. Let a bag start with the same gas (p0, V0), let its meridian never get longer than this one, let no
// energy come in but the probe's. However it is shaped, whatever moves in it and whatever is lost to heat in the gas,
// its volume at a gap is at most V(H), and gas of that energy content needs at least W(D): so max_displacement is an
// upper bound for the displacement of the probe, its rebound_speed one for the rebound, and at each gap its speed is
// one for the speed. A skin that stretches is covered with the meridian as long as it gets, if the energy it held at
// first counts with the probe's.
// What it does not bound. Time, force and pressure: the inertia of skin and gas makes a real force higher at first and
// swing later, hoop stiffness raises it, stretch and losses lower it. Leaks and heat lost to the outside are outside.
#include <vector>

#include "reference/bounded.hpp"
#include "reference/inextensible_bag.hpp"

namespace plumbline::reference {

/// SI units; all > 0 but those that say otherwise. Defaults: York's Cyl-200 with the physical pressure. As he computed
/// it, with the gauge pressure taken as absolute: pressure 4000, ambient_pressure 0. His Cyl-500: 8.05 kg, 0.25 m, 4.70
/// m/s.
struct AirbagProblem {
  double mass = 6.03;
  double probe_radius = 0.1;
  double speed = 3.9;                // at first touch
  double meridian = 0.71689571;      // of the skin from pole to pole; that of York's outline (section 6.3)
  double height = 0;                 // gap at first touch; 0: that of the untouched bag. Lower: pressed before
  double gamma = 1.4;                // > 1
  double pressure = 105325;          // absolute, in the bag at first touch, > ambient_pressure
  double ambient_pressure = 101325;  // >= 0
  double gas_volume = 0;             // for displacement_limit() alone: >= 0, at most start_volume(); 0: start_volume()
};

struct AirbagState {
  Bounded displacement, velocity;  // of the probe, towards the plate
  Bounded force;                   // on the probe, away from the plate
  Bounded pressure;                // absolute
  Bounded volume;
  Bounded plate_radius, equator;  // contact with the plate, largest radius
};

class AirbagLumped {
 public:
  /// Throws ParameterError with the key of a value out of range; with "speed" if the bag would close around the side of
  /// the probe, or be pressed flat, before the probe is stopped, or if the blow is too light for double precision.
  explicit AirbagLumped(const AirbagProblem& problem = {});

  const AirbagProblem& problem() const { return problem_; }
  const InextensibleBag& bag() const { return bag_; }
  Bounded start_height() const { return start_height_; }
  Bounded start_volume() const { return start_volume_; }
  Bounded energy() const;  // of the probe before
  Bounded max_displacement() const { return turn_; }
  Bounded time_of_max() const { return times_.back(); }
  /// Upper bound for the displacement of a probe on a bag that does not fill start_volume() at first touch, because its
  /// hoops hold it in another shape: its gas has `pressure` in `gas_volume`, and could expand as well as be pressed.
  Bounded displacement_limit() const { return limit_; }
  Bounded contact_duration() const;  // 2 time_of_max
  Bounded peak_force() const;        // these at the largest displacement
  Bounded peak_pressure() const;     // absolute
  Bounded least_volume() const;
  Bounded rebound_speed() const { return problem_.speed; }

  /// Quasi-static, at a displacement from 0 to the largest: force, pressure, volume, shape, speed on the way in.
  AirbagState at_displacement(Bounded displacement) const;
  /// Work of the probe up to that displacement.
  Bounded work(Bounded displacement) const;
  /// time >= 0 since first touch; after contact_duration() the probe flies back freely.
  AirbagState at(double time) const;

 private:
  Bounded pressed_out(Bounded displacement) const;
  Bounded pressure_at(Bounded out) const;
  Bounded compression(Bounded out) const { return compression(out, start_volume_); }
  Bounded compression(Bounded out, Bounded from) const;
  Bounded where_stopped(Bounded gas) const;
  void find_turn();
  void tabulate_times();
  Bounded place(double angle) const;
  Bounded speed(double angle) const;
  Bounded rate(double angle) const;
  double angle_at(double time, Bounded& missed) const;
  AirbagState moving(double time, double doubt) const;
  AirbagState flying(double time) const;

  AirbagProblem problem_;
  InextensibleBag bag_;
  Bounded start_height_, start_volume_;
  Bounded turn_, turn_work_, limit_;
  double energy_error_ = 0;     // of turn_work_, that of the motion integrated, relative to energy()
  std::vector<double> angles_;  // x = turn sin^2(angle): knots from 0 to pi/2
  std::vector<Bounded> times_;  // at the knots
};

}  // namespace plumbline::reference
