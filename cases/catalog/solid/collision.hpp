// What is watched of bodies that meet, and what is asked of it.
#pragma once

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "cases/harness/judge/gates.hpp"
#include "kernel/simulation.hpp"

namespace plumbline {

class Archive;
class Settings;

// Mass (kg), place (m) and velocity (m/s) of a body's centre of mass; components beyond dim are 0.
struct BodyMotion {
  double mass = 0;
  std::array<double, 3> position{}, velocity{};
};
BodyMotion motion_of(const Body& body, int dim);

// Largest and smallest coordinate of a body's points along d, m.
double highest_point(const Body& body, int d);
double lowest_point(const Body& body, int d);

// How many spacings of its points further up than face to face a body starts on another that it is to press: where points repel each
// other, by all of their reach; else a little deeper, so that rows of points touch wherever they stand along: by more than
// 1 - sqrt(3)/2.
double spacings_apart(const Settings& settings);

// What contact has taken so far, less what pairs of points hold of it, of bodies that started without, J.
double friction_work(const Simulation& simulation);

// The largest rise of the energy of all points (kinetic with its affine part, elastic, internal) in one step, and how
// high it ever stood, both over the energy at the start.
class EnergyWatch {
 public:
  void observe(const Simulation& simulation);
  void history(Archive& archive);
  double largest_rise() const { return rise_; }  // 0 if it never rose
  double highest() const { return highest_; }
  double kept() const { return last_ / start_; }

 private:
  bool started_ = false;
  double start_ = 0, last_ = 0, rise_ = 0, highest_ = 1;
};

// Largest deviation of the total momentum along d from that of the start, over sum m |v| of the start.
class MomentumWatch {
 public:
  explicit MomentumWatch(int d) : d_(static_cast<std::size_t>(d)) {}
  void observe(const Simulation& simulation);
  void history(Archive& archive);
  double largest_error() const { return error_; }

 private:
  std::size_t d_;
  double error_ = 0;
};

// When a body got its momentum along d from another: the interval of a steady push with the same times at which 0.5 %,
// half and 99.5 % of the impulse have been given. Interpolated, so that it knows no steps.
class PushWatch {
 public:
  PushWatch(int d, double start_momentum) : d_(d), times_{0}, momenta_{start_momentum} {}
  void observe(const Body& body, int dim, double time);
  // The same from a history of a momentum.
  void observe(double time, double momentum);
  void history(Archive& archive);

  double start() const { return beyond(time_of(edge)); }  // NaN if nothing was given
  double end() const { return beyond(time_of(1 - edge)); }
  double duration() const { return end() - start(); }
  // When this share of the impulse until the end had been given for the first time.
  double time_of(double share) const;

 private:
  static constexpr double edge = 0.005;
  double beyond(double time) const { return time + (time - time_of(0.5)) * edge / (0.5 - edge); }
  int d_;
  std::vector<double> times_, momenta_;
};

// The values of a measure, level by level. Throws std::runtime_error where a run does not have it, or there is no run.
std::vector<double> values_of(const StudyResult& study, const std::string& measure);
// The least rise from one of at least two values to the next.
double least_rise(const std::vector<double>& values);

// What the midpoint step promises of linear elastic bodies, by the measures energy_rise and momentum_error.
std::vector<CaseGate> conservation_gates(const std::string& study, const std::vector<double>& levels,
                                         Tier tier = Tier::quick);

}  // namespace plumbline
