// What becomes of the energy of a linear oscillation that nothing damps, over a hundred periods.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cases/harness/integrators/growth.hpp"
#include "cases/harness/integrators/integrator_gates.hpp"
#include "cases/harness/integrators/measured_limit.hpp"
#include "cases/harness/integrators/small_scenes.hpp"
#include "cases/harness/laboratory/oscillator.hpp"
#include "cases/harness/laboratory/wave.hpp"
#include "cases/harness/verdict/line_fit.hpp"
#include "kernel/simulation.hpp"

namespace plumbline {
namespace {

constexpr int periods = 100;
constexpr double energy_rounding = 1e-10;  // of the energy in a period, relative
constexpr double least_energy = 1e-30;     // below this an oscillation is gone

// The logarithm of the largest energy of each period, over that of the start.
using Peaks = std::vector<double>;

// The straight line through them, per period.
StraightLine trend_of(const Peaks& peaks) {
  if (peaks.size() < 3) return {1, 0, 0};  // beyond all numbers within three periods
  std::vector<FitPoint> points;
  for (const double peak : peaks) points.push_back({static_cast<double>(points.size()), peak});
  return fit_line(points);
}

// energy(): after each step of dt; a period has so many steps.
template <class Step>
Peaks peaks_of(double start, int steps_in_period, Step&& step_and_energy) {
  Peaks peaks;
  for (int period = 0; period < periods; ++period) {
    double peak = least_energy;
    for (int k = 0; k < steps_in_period; ++k) peak = std::max(peak, step_and_energy() / start);
    if (!std::isfinite(peak)) break;  // it has grown beyond all numbers: the periods until then tell
    peaks.push_back(std::log(peak));
  }
  return peaks;
}

// Half of the smaller of a limit and York's; of York's where no step is stable.
double half_of(double limit) { return 0.5 * std::min(limit > 0 ? limit : limit_of_york, limit_of_york); }

Peaks oscillator_peaks(const Subject& subject, double dt) {
  const auto integrator = subject.entry().make();
  set_parameters(*integrator, subject.choice().parameters);
  const int steps = static_cast<int>(std::ceil(2 * std::numbers::pi / dt));
  OneMass mass(0.6, 0.8, 0.0);
  return peaks_of(0.5, steps, [&] {
    integrator->step(mass, 2 * std::numbers::pi / steps);
    return 0.5 * (mass.displacement() * mass.displacement() + mass.velocity() * mass.velocity());
  });
}

// Half a wave on a bar of eight cells under FLIP, so small that positions are held.
Peaks bar_peaks(const Subject& subject) {
  if (auto missing = lacks(subject.entry(), "linear", "flip"); !missing.empty()) throw CannotWork(std::move(missing));
  constexpr int cells = 8;
  const StandingWave wave({"linear", "flip", 2}, cells, 1);
  const int steps = static_cast<int>(std::ceil(2 * cells / half_of(limit_on_bar(subject))));
  StepControl control;
  control.dt = 2.0 * cells / steps;
  control.parameters = subject.choice().parameters;
  Simulation run(wave.scene(), subject.name(), control);
  const auto energy = [&] {
    const Columns& points = run.scene().bodies[0].points;
    double sum = 0;
    for (int p = 0; p < points.points(); ++p) {
      const double v = points(column::velocity)[p] * 1e17, e = points(column::strain)[p] * 1e17;
      sum += 0.5 * (points(column::mass)[p] * v * v + points(column::volume)[p] * e * e);
    }
    return sum;
  };
  const double start = energy();
  return peaks_of(start, steps, [&] {
    run.step(2 * control.dt.value());
    return energy();
  });
}

const Peaks& peaks_on_oscillator(const Subject& subject) {
  return subject.once<Peaks>("energy/oscillator",
                             [&] { return oscillator_peaks(subject, half_of(limit_on_oscillator(subject))); });
}

Measured growth(const Peaks& peaks) {
  const StraightLine trend = trend_of(peaks);
  return plain(
      trend.slope / std::max(10 * trend.slope_error, energy_rounding),
      fmt::format("slope {:.3g} of the energy a period, standard error {:.2g}", trend.slope, trend.slope_error));
}

// What a closed box of gas gains or loses, over its kinetic energy at the start, where losses of maps are given back as heat.
Measured change_in_closed_box(const Subject& subject) {
  if (subject.traits().offers.count(Trait::returned_loss) == 0) {
    throw CannotWork({{Trait::returned_loss, "an energy that maps do not change", "integrator " + subject.name()}});
  }
  const SmallScene& small = small_scene("gas-filtered");
  const Scene scene = workable(small, subject.name());
  const Columns& points = scene.bodies[0].points;
  double kinetic = 0;
  for (int p = 0; p < points.points(); ++p) {
    kinetic += 0.5 * points(column::mass)[p] * points(column::velocity)[p] * points(column::velocity)[p];
  }
  return measured_limit({8, 4, 8}, [&](int steps) {
    StepControl control;
    control.dt = small.end / steps;
    control.parameters = subject.choice().parameters;
    Simulation run(scene, subject.name(), control);
    for (int k = 0; k < steps; ++k) run.step(small.end);
    const auto& energy = run.ledger().energy;
    return std::vector<double>{(energy.store() - energy.initial()) / kinetic};
  });
}

IntegratorGate growth_row(const std::string& problem, const std::string& what,
                          std::function<Measured(const Subject&)> measure) {
  return {"energy",
          gate_row(
              "energy", problem + "/growth",
              "slope of the logarithm of each period's largest energy, over 10 standard errors of it or 1e-10: " + what,
              {{}, 1.0}, Origin::theory,
              "an oscillation that nothing drives gains no energy in the mean; 1e-10 a period for rounding"),
          "the step amplifies: the velocity that strains is not the one with which forces do their work",
          std::move(measure), Effort::core};
}

// How far the peaks are from what was claimed: 1 is the most that scatter and rounding make of it.
Measured off_claim(EnergyBehaviour claim, const Peaks& peaks) {
  const StraightLine trend = trend_of(peaks);
  const double slope = trend.slope / std::max(10 * trend.slope_error, energy_rounding);
  if (claim == EnergyBehaviour::bounded) return plain(std::abs(slope));
  if (claim == EnergyBehaviour::decaying) return plain(slope + 2);  // a slope of -1 or less is told from none
  double off = 0;
  for (const double peak : peaks) off = std::max(off, std::abs(peak) / (periods * energy_rounding));
  return plain(off);
}

}  // namespace

std::vector<IntegratorGate> energy_gates(const Subject& subject) {
  std::vector<IntegratorGate> all{
      growth_row("oscillator", "one mass on a spring", [](const Subject& s) { return growth(peaks_on_oscillator(s)); }),
      growth_row("bar", "half a wave in a bar, positions held, nothing filtered",
                 [](const Subject& s) { return growth(bar_peaks(s)); }),
      {"energy",
       gate_row("energy", "closed-box",
                "change of the energy of gas between two walls, over its kinetic energy at the start, for dt -> 0",
                {{}, most_left_over}, Origin::theory,
                "walls do no work, and what maps take is given back as heat; 1e-5: a hundredth of one per mille"),
       "losses of maps are given back more than once, or not in full", change_in_closed_box}};
  all.back().gate.order = true;  // the extrapolation's interval is judged
  if (const auto claim = subject.claims().energy) {
    constexpr const char* names[] = {"conserved", "bounded", "decaying"};
    const std::string behaviour = names[static_cast<std::size_t>(*claim)];
    all.push_back({"energy",
                   gate_row("energy", "claimed/" + behaviour,
                            "how far the energy of an oscillator is from being " + behaviour + ", over rounding",
                            {{}, 1.0}, Origin::theory, "claimed by the integrator"),
                   "another scheme than the claim speaks of",
                   [claim](const Subject& s) { return off_claim(*claim, peaks_on_oscillator(s)); }, Effort::core});
  }
  return all;
}

}  // namespace plumbline
