// What may not matter to a step: where it is begun again, on how many threads, towards which side, along which axis.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cases/harness/integrators/integrator_gates.hpp"
#include "cases/harness/integrators/measured_limit.hpp"
#include "cases/harness/integrators/pairs.hpp"
#include "cases/harness/laboratory/oscillator.hpp"
#include "cases/harness/run/simulation_state.hpp"
#include "kernel/simulation.hpp"

namespace plumbline {
namespace {

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = a.size() == b.size() ? 0 : HUGE_VAL;
  for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k) {
    largest = larger(largest, std::abs(a[k] - b[k]));
  }
  return largest;
}

StepControl control_of(const Subject& subject, double dt, int threads = 1) {
  StepControl control;
  control.dt = dt;
  control.threads = threads;
  control.parameters = subject.choice().parameters;
  return control;
}

// Positions, then velocities, after so many steps of dt.
std::vector<double> places_and_velocities(const Scene& scene) {
  std::vector<double> all = column_by_number(scene, column::position);
  const std::vector<double> velocities = column_by_number(scene, column::velocity);
  all.insert(all.end(), velocities.begin(), velocities.end());
  return all;
}

std::vector<double> stepped(const Subject& subject, Scene scene, double dt, int steps, int threads = 1) {
  Simulation run(std::move(scene), subject.name(), control_of(subject, dt, threads));
  for (int k = 0; k < steps; ++k) run.step(dt);
  return places_and_velocities(run.scene());
}

constexpr double usual_step = 0.1;  // h/c
constexpr int usual_steps = 16;

Measured repeated(const Subject& subject) {
  const Scene scene = workable(with_some_maps(small_scene("plate"), subject.name()), subject.name());
  return plain(largest_difference(stepped(subject, scene, usual_step, usual_steps),
                                  stepped(subject, scene, usual_step, usual_steps)));
}

// Enough points that two threads share them.
Measured over_threads(const Subject& subject) {
  constexpr int copies = 15;
  Scene scene = workable(with_some_maps(small_scene("gas-plane"), subject.name()), subject.name());
  Body& body = scene.bodies[0];
  const int n = body.points.points();
  std::vector<int> of;
  for (int copy = 1; copy < copies; ++copy) {
    for (int p = 0; p < n; ++p) of.push_back(p);
  }
  body.points.append_copies(of);
  const int width = scene.grid.cells[0];
  scene.grid.cells[0] *= copies;
  for (int p = n; p < copies * n; ++p) {
    body.id.push_back(p);
    body.points(column::position)[p] += width * (p / n);
  }
  return plain(
      largest_difference(stepped(subject, scene, usual_step, 4, 1), stepped(subject, scene, usual_step, 4, 2)));
}

// As from a file: all that the new run has of the old one is numbers with names.
Measured restarted(const Subject& subject) {
  const Scene scene = workable(with_some_maps(small_scene("plate"), subject.name()), subject.name());
  Simulation whole(scene, subject.name(), control_of(subject, usual_step));
  for (int k = 0; k < usual_steps / 2; ++k) whole.step(usual_step);
  Archive writing;
  archive_simulation(writing, whole, subject.name());
  const Archive::Table half_way = writing.take();
  for (int k = 0; k < usual_steps / 2; ++k) whole.step(usual_step);
  Simulation again(scene, subject.name(), control_of(subject, usual_step));
  Archive reading(half_way);
  archive_simulation(reading, again, subject.name());
  for (int k = 0; k < usual_steps / 2; ++k) again.step(usual_step);
  return plain(largest_difference(places_and_velocities(whole.scene()), places_and_velocities(again.scene())));
}

// The same step over and over from the same state, what memory() names put back with it.
Measured remembered(const Subject& subject) {
  constexpr int times = 64;
  const Scene scene = workable(with_some_maps(small_scene("bar"), subject.name()), subject.name());
  StepMap map(scene, {}, subject.choice(), Positions::moving, usual_step);
  const std::vector<double> start = map.state();
  map.step();
  const std::vector<double> first = map.state();
  double largest = 0;
  for (int k = 0; k < times; ++k) {
    map.set_state(start);
    map.step();
    largest = larger(largest, largest_difference(map.state(), first));
  }
  return plain(largest);
}

// Over the largest distance that a point moves.
Measured in_a_mirror(const Subject& subject) {
  const SmallScene small = with_some_maps(small_scene("plate"), subject.name());
  const Scene scene = workable(small, subject.name());
  std::vector<double> there = state_at_end(small, scene, subject.choice(), usual_steps);
  const std::vector<double> mirror = state_at_end(small, mirrored(scene), subject.choice(), usual_steps);
  double scale = 0;
  for (const double value : there) scale = larger(scale, std::abs(value));
  const std::size_t n = scene.bodies[0].id.size();
  for (std::size_t k = 0; k < n; ++k) {
    there[k] = -there[k];                  // the distance along x
    there[2 * n + k] = -there[2 * n + k];  // the velocity along x
  }
  return plain(largest_difference(there, mirror) / scale);
}

Measured along_other_axes(const Subject& subject) {
  const SmallScene small = with_some_maps(small_scene("plate"), subject.name());
  const Scene scene = workable(small, subject.name()), turned = with_axes_exchanged(scene);
  const std::size_t n = scene.bodies[0].id.size();
  return measured_limit({8, 3, 8}, [&](int count) {
    std::vector<double> one = state_at_end(small, scene, subject.choice(), count);
    std::vector<double> other = state_at_end(small, turned, subject.choice(), count);
    double scale = 0;
    for (const double value : one) scale = larger(scale, std::abs(value));
    for (const std::size_t first : {std::size_t{0}, 2 * n}) {
      std::swap_ranges(other.begin() + static_cast<std::ptrdiff_t>(first),
                       other.begin() + static_cast<std::ptrdiff_t>(first + n),
                       other.begin() + static_cast<std::ptrdiff_t>(first + n));
    }
    for (std::size_t k = 0; k < one.size(); ++k) one[k] = (one[k] - other[k]) / scale;
    return one;
  });
}

// How much a uniform motion of the whole changes the motion of a free bar of `cells` cells within itself, over the largest
// distance that it moves there.
double change_by_motion(const SmallScene& small, const Scene& at_rest, const IntegratorChoice& integrator) {
  constexpr double common = 0.2;
  Scene moving = at_rest;
  for (Body& body : moving.bodies) {
    for (int p = 0; p < body.points.points(); ++p) body.points(column::velocity)[p] += common;
  }
  const int count = 8 * at_rest.grid.cells[0];
  const std::vector<double> rest = state_at_end(small, at_rest, integrator, count);
  std::vector<double> moved = state_at_end(small, moving, integrator, count);
  double largest = 0, scale = 0;
  for (std::size_t k = 0; k < rest.size() / 2; ++k) {
    largest = larger(largest, std::abs(moved[k] - common * small.end - rest[k]));
    scale = larger(scale, std::abs(rest[k]));
  }
  return largest / scale;
}

Measured in_motion(const Subject& subject) {
  const SmallScene small = with_some_maps(small_scene("free-bar"), subject.name());
  const Scene scene = workable(small, subject.name());
  const double mine = change_by_motion(small, scene, subject.choice());
  const double theirs = change_by_motion(small, scene, yardstick(subject, scene));
  return plain(mine / theirs,
               fmt::format("{:.3g} of the largest distance, the consistent integrator {:.3g}", mine, theirs));
}

Measured taken_back(const Subject& subject) {
  const auto integrator = subject.entry().make();
  set_parameters(*integrator, subject.choice().parameters);
  OneMass mass(0.6, 0.8, 0.0);
  integrator->step(mass, 0.3);
  integrator->step(mass, -0.3);
  return plain(std::hypot(mass.displacement() - 0.6, mass.velocity() - 0.8));
}

constexpr const char* hidden =
    "state that is kept between steps and that neither memory() nor kept() names, or a random number";

IntegratorGate bits(const std::string& name, const std::string& what, const std::string& why, const std::string& causes,
                    std::function<Measured(const Subject&)> measure) {
  return {"invariance",
          gate_row("invariance", name, "largest difference of any number: " + what, {{}, 0.0}, Origin::identity, why),
          causes, std::move(measure)};
}

}  // namespace

std::vector<IntegratorGate> invariance_gates(const Subject& subject) {
  constexpr const char* sided = "a direction, a side or a part of the points is treated unlike the others";
  std::vector<IntegratorGate> all{
      bits("repeat", "the same run twice", "a run is determined by its start", hidden, repeated),
      bits("threads", "on one thread and on two", "no result depends on threads",
           "work that depends on an order of points", over_threads),
      bits("restart", "saved and restored half-way", "a run that is taken up again goes on bit for bit", hidden,
           restarted),
      bits("memory", "the same step 64 times from the same state", "the state and what memory() names determine a step",
           hidden, remembered),
      {"invariance",
       gate_row("invariance", "mirror", "largest difference from the mirror image, over the largest distance moved",
                {{}, 1e-10}, Origin::theory,
                "equations have no preferred side; 1e-10 for roundings of sums in another order"),
       sided, in_a_mirror},
      {"invariance",
       gate_row(
           "invariance", "axes", "difference with exchanged axes for dt -> 0, over the largest distance moved",
           {{}, most_left_over}, Origin::theory,
           "equations have no preferred axis, and steps that take one after the other show it to some order of dt"),
       sided, along_other_axes},
      {"invariance",
       gate_row("invariance", "motion",
                "what a uniform motion changes within a free bar, over what it changes with a consistent integrator",
                {{}, 2.0}, Origin::regression,
                "a grid at rest is felt by every scheme: twice as much as by the other is allowed"),
       "velocities are used that are not those of the points, or not of the same instant", in_motion}};
  all[5].gate.order = true;  // the extrapolation's interval is judged
  if (subject.claims().reversible) {
    all.push_back(
        {"invariance",
         gate_row("invariance", "claimed/reversible", "what a step back of an oscillator leaves of a step forth",
                  {{}, 1e-13}, Origin::theory, "claimed by the integrator; 1e-13 for rounding"),
         "another scheme than the claim speaks of", taken_back, Effort::core});
  }
  return all;
}

}  // namespace plumbline
