#include "reference/airbag_lumped.hpp"

#include <algorithm>

#include "reference/argument.hpp"
#include "reference/elementary.hpp"
#include "reference/exponential.hpp"
#include "reference/quadrature.hpp"
#include "reference/root.hpp"

namespace plumbline::reference {
namespace {

constexpr int panels = 4;          // of the time to the edge of the probe, and from there to the turn
constexpr double faintest = 1e-6;  // relative bound of the displacement
const double quarter_turn = std::acos(0.0);

const AirbagProblem& checked(const AirbagProblem& p) {
  check_positive("mass", p.mass);
  check_positive("speed", p.speed);
  check_not_negative("height", p.height);
  check({"gamma", 0, 1, rounding::infinity, true, true, "", ""}, p.gamma);
  check_not_negative("ambient_pressure", p.ambient_pressure);
  check_not_negative("gas_volume", p.gas_volume);
  check_finite("pressure", p.pressure);
  if (!(p.pressure > p.ambient_pressure)) throw ParameterError("pressure", p.pressure, "above the ambient pressure");
  return p;
}

}  // namespace

AirbagLumped::AirbagLumped(const AirbagProblem& problem)
    : problem_(checked(problem)),
      bag_(problem.meridian, problem.probe_radius) {
  start_height_ = problem.height == 0 ? bag_.free_height() : Bounded(problem.height);
  if (certainly_below(bag_.free_height(), start_height_) || start_height_.value <= bag_.least_height())
    throw ParameterError("height", problem.height, "0, or from the least height to that of the untouched bag");
  start_volume_ = problem.height == 0 ? bag_.free_volume() : bag_.at(start_height_).volume;
  find_turn();
  limit_ = problem.gas_volume == 0 ? turn_ : where_stopped(problem.gas_volume);
  tabulate_times();
}

Bounded AirbagLumped::energy() const { return Bounded(0.5) * problem_.mass * problem_.speed * problem_.speed; }

Bounded AirbagLumped::pressed_out(Bounded displacement) const {
  Bounded out = start_volume_ - bag_.at(start_height_ - displacement).volume;
  out.value = std::max(0.0, out.value);
  return out;
}

/// Absolute; the bound takes the largest slope, as p grows faster with D the larger D is.
Bounded AirbagLumped::pressure_at(Bounded out) const {
  const Bounded left = Bounded(1) - out / start_volume_;
  return Bounded(problem_.pressure) * pow(left, -problem_.gamma);
}

/// W(D) of gas that has p0 in the volume `from`, at the exact D first: what D is uncertain by counts with p - p_a, not
/// with both pressures.
Bounded AirbagLumped::compression(Bounded out, Bounded from) const {
  const Bounded exact(out.value), share = exact / from, power = Bounded(problem_.gamma) - 1.0;
  const Bounded stored = Bounded(problem_.pressure) * from / power * expm1(power * share * log1m_over(share));
  Bounded work = stored - Bounded(problem_.ambient_pressure) * exact;
  const Bounded pressure = Bounded(problem_.pressure) * pow(Bounded(1) - out / from, -problem_.gamma);
  const Bounded pushed = pressure - problem_.ambient_pressure;
  work.bound = (work.bound + highest(abs(pushed)) * out.bound) * rounding::inflate;
  return work;
}

Bounded AirbagLumped::work(Bounded displacement) const { return compression(pressed_out(displacement)); }

/// The displacement at which gas of that volume at first touch, in the bag of largest volume, has taken all energy up.
/// Where it is slack at first, W falls and then rises: it is below zero until it rises, so the root is one all the
/// same.
Bounded AirbagLumped::where_stopped(Bounded gas) const {
  const double most = (start_height_.value - bag_.least_height()) * (1 - 1e-12);
  auto f = [&](double x) { return compression(gas - bag_.at(start_height_ - Bounded(x)).volume, gas) - energy(); };
  auto value = [&](double x) { return f(x).value; };
  if (!certainly_below(0.0, f(most)))
    throw ParameterError("speed", problem_.speed, "less: the bag would close around the probe or be pressed flat");
  const double guess = brent_root(value, 0, most), near = guess * (1 - 1e-4);
  return enclose_root(f, guess, (value(guess) - value(near)) / (guess - near), 0, most);
}

void AirbagLumped::find_turn() {
  if (certainly_below(start_volume_, problem_.gas_volume))
    throw ParameterError("gas_volume", problem_.gas_volume, "at most what the bag holds at first touch");
  turn_ = where_stopped(start_volume_);
  if (!(turn_.bound < faintest * turn_.value))
    throw ParameterError("speed", problem_.speed, "more: what so light a blow presses out is lost in rounding");
  turn_work_ = work(turn_.value);
  energy_error_ = highest(abs(turn_work_ - energy())) / energy().value;
}

AirbagState AirbagLumped::at_displacement(Bounded displacement) const {
  const double margin = turn_.bound + rounding::unit * turn_.value;
  if (!(displacement.value >= 0) || (turn_.value > 0 && !(displacement.value <= turn_.value + margin)))
    throw ParameterError("displacement", displacement.value, "from 0 to max_displacement()");
  const BagShape shape = bag_.at(start_height_ - displacement);
  Bounded out = start_volume_ - shape.volume;
  out.value = std::max(0.0, out.value);
  AirbagState state;
  state.displacement = displacement;
  state.velocity = sqrt(Bounded(2) * (energy() - compression(out)) / problem_.mass);
  state.pressure = pressure_at(out);
  state.force = (state.pressure - problem_.ambient_pressure) * shape.pressed_area;
  state.volume = shape.volume;
  state.plate_radius = shape.plate_radius;
  state.equator = shape.equator;
  return state;
}

// x = turn sin^2(angle) makes the time a smooth function of the angle: the speed falls like the cosine at the turn, and
// x = 0, where the bag is first touched, is a root of the half integer powers of the shape. What is integrated turns at
// the value of turn_, exactly: its energy is turn_work_.
Bounded AirbagLumped::place(double angle) const {
  const Bounded sine = sin(Bounded(angle));
  return Bounded(turn_.value) * sine * sine;
}

Bounded AirbagLumped::speed(double angle) const {
  return sqrt(Bounded(2) * (turn_work_ - work(place(angle))) / problem_.mass);
}

Bounded AirbagLumped::rate(double angle) const { return Bounded(turn_.value) * sin(Bounded(2) * angle) / speed(angle); }

void AirbagLumped::tabulate_times() {
  const double to_edge = (start_height_.value - bag_.edge_height()) / turn_.value;
  const bool split = to_edge > 1e-6 && to_edge < 1 - 1e-6;
  const double edge = split ? std::asin(std::sqrt(to_edge)) : quarter_turn;
  for (int i = 0; i <= panels; ++i) angles_.push_back(edge * i / panels);
  for (int i = 1; split && i <= panels; ++i) angles_.push_back(edge + (quarter_turn - edge) * i / panels);
  auto f = [this](double angle) { return rate(angle); };
  times_.push_back(0.0);
  for (std::size_t i = 1; i < angles_.size(); ++i)
    times_.push_back(times_.back() + integrate(f, angles_[i - 1], angles_[i]));
  // By dimensions, t grows with the power 1/(n + 1) - 1/2 of the energy where the force does with the power n of x.
  for (Bounded& time : times_) time.bound += energy_error_ * time.value;
}

Bounded AirbagLumped::contact_duration() const { return Bounded(2) * time_of_max(); }
Bounded AirbagLumped::peak_force() const { return at_displacement(turn_).force; }
Bounded AirbagLumped::peak_pressure() const { return at_displacement(turn_).pressure; }
Bounded AirbagLumped::least_volume() const { return at_displacement(turn_).volume; }

/// Newton's method from the knot before; `missed` is the time at the angle less the time asked for.
double AirbagLumped::angle_at(double time, Bounded& missed) const {
  std::size_t i = 0;
  while (i + 2 < angles_.size() && times_[i + 1].value <= time) ++i;
  const double low = angles_[i], high = angles_[i + 1];
  auto f = [this](double angle) { return rate(angle); };
  double angle = low + (high - low) * std::min(1.0, (time - times_[i].value) / (times_[i + 1] - times_[i]).value);
  if (i == 0) angle = std::min(high, std::sqrt(time * problem_.speed / turn_.value));
  for (int n = 0; n < 12; ++n) {
    missed = times_[i] + integrate(f, low, angle) - time;
    const double next = std::clamp(angle - missed.value / rate(angle).value, 0.5 * (low + angle), high);
    if (std::abs(missed.value) <= missed.bound || next == angle) break;
    angle = next;
  }
  return angle;
}

/// On the way in, at a time that is in doubt by so much.
AirbagState AirbagLumped::moving(double time, double doubt) const {
  if (time <= 0) return at_displacement({0.0, problem_.speed * (doubt - time)});
  Bounded missed;
  const double angle = time < times_.back().value ? angle_at(time, missed) : quarter_turn;
  if (angle == quarter_turn) missed = times_.back() - time;
  const double late = highest(abs(missed)) + doubt, slowing = peak_force().value / problem_.mass;
  const Bounded here = speed(angle);
  Bounded x = place(angle);
  x.bound += (highest(here) + slowing * late) * late + energy_error_ * x.value + turn_.bound;
  AirbagState state = at_displacement(x);
  state.velocity = here;
  state.velocity.bound += slowing * late + energy_error_ * problem_.speed;
  return state;
}

AirbagState AirbagLumped::flying(double time) const {
  AirbagState state = at_displacement(0.0);
  state.displacement = Bounded(problem_.speed) * (contact_duration() - time);
  state.velocity = -Bounded(problem_.speed);
  const bool sure = certainly_below(contact_duration(), time);
  state.force = sure ? Bounded(0) : hull(0.0, state.force);
  return state;
}

AirbagState AirbagLumped::at(double time) const {
  check_not_negative("time", time);
  const Bounded duration = contact_duration();
  if (time > duration.value) return flying(time);
  if (time <= time_of_max().value) return moving(time, 0);
  AirbagState state = moving(duration.value - time, duration.bound + rounding::unit * duration.value);
  state.velocity = -state.velocity;
  return state;
}

}  // namespace plumbline::reference
