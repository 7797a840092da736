// The limit of the time step: as the step's own spectral radius predicts it, and as runs show it.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cases/harness/laboratory/amplification.hpp"

namespace plumbline {

// A step whose spectral radius is at most this counts as stable.
inline constexpr double stable_radius = 1 + 1e-6;

// Steps to try, in units of the scene's time; ascending.
struct Scan {
  double low = 0.05, high = 4;  // > 0
  int steps = 32;               // >= 2, evenly spaced in the logarithm
  // From the smallest step on, up to the first that grows: intervals of stable steps beyond are not looked for.
  bool first_limit_only = false;
  std::vector<double> values() const;
};

// Steps from `low` to `high` are stable. high: infinite where the last step of the scan is stable. low: 0 where the first is.
struct StableInterval {
  double low = 0, high = 0;
};

struct Growth {
  double dt = 0, per_step = 0;
  WaveNumber theta{};
};

// What the step itself says.
struct Prediction {
  std::vector<StableInterval> stable;
  std::vector<Growth> growth;  // over the scan
  Differences differences;     // of the step that was tried first, the largest of a whole scan
  double tail = 0;
  int reach = 0, unknowns = 0;
  bool always_stable() const { return stable.size() == 1 && stable[0].low == 0 && stable[0].high > 1e300; }
  bool always_unstable() const { return stable.empty(); }
  // The first step beyond which not all smaller ones are stable; 0: none is.
  double limit() const { return !stable.empty() && stable[0].low == 0 ? stable[0].high : 0; }
};

// A problem as the laboratory sees it: its patch of a given extent, and how it is stepped.
struct Experiment {
  std::function<Patch(const Extent&)> patch;
  IntegratorChoice integrator;
  Positions positions = Positions::frozen;
  int least_reach = 2, most_reach = 96;  // periods that one step may reach
};

// Spectral radii over the scan, and every limit between by bisection to a relative width of `width`. Throws
// std::runtime_error where a step reaches further than Experiment::most_reach, or its state does not repeat.
Prediction predict(const Experiment& experiment, const Scan& scan, double width = 1e-9);

// The same of any step by its growth alone: the largest spectral radius at a step, and the wave that has it. `hints`: waves
// that grow at steps nearby.
using GrowthOfStep = std::function<Growth(double dt, const std::vector<WaveNumber>& hints)>;
Prediction predict(const GrowthOfStep& growth, const Scan& scan, double width = 1e-9);

// How many periods a step of dt (units of the scene's time) reaches. Explicit steps reach a few, implicit ones all.
inline constexpr int far_reach = 16;  // beyond what explicit steps reach
int reach_of_step(const Experiment& experiment, double dt);

// The spectral radius at one step (units of the scene's time) and the wave that has it.
Growth worst_growth(const Experiment& experiment, double dt);

// Spectral radii at one step (units of the scene's time) of waves along the first direction of the lattice.
std::vector<double> radii_over_waves(const Experiment& experiment, double dt, const std::vector<double>& thetas);

// How runs are looked at.
struct Watch {
  int core = 24;        // periods that run, in each direction of the lattice
  int steps = 2000;     // of each run
  double width = 2e-3;  // relative, of the brackets
  double perturbation = 1e-8;
  // A perturbation has grown when it is so many times its size, or still grows at the end. A drift that is linear in time
  // grows by less than 1e-3 a step by then.
  double grown = 1e4, grown_slowly = 30, slowest = 1e-3;
  unsigned long seed = 1;
};

// A limit between two steps that were run: a run of `stable_side` keeps a perturbation small, one of the other does not.
struct Bracket {
  double low = 0, high = 0;
  bool stable_below = true;
};

struct Observation {
  std::vector<Bracket> brackets;
  std::vector<Growth> growth;  // per step, over the scan
  bool always_stable = false, always_unstable = false;
};

// Runs of the perturbed patch, periods repeated after every step. `reach` as predict() found it.
Observation observe(const Experiment& experiment, const Scan& scan, const Watch& watch, int reach);

// Growth per step of a perturbation in one run; infinite where the run stops on an inadmissible state at once.
struct Run {
  double growth = 1;     // per step, over the last third
  double amplified = 1;  // largest size over that at the start
  bool unstable = false;
};
// Follows the size of a perturbation from step to step. Where it grows, but is not large at the end, the run goes on for up
// to four times its steps: slow growth takes its time.
class GrowthInRun {
 public:
  explicit GrowthInRun(const Watch& watch) : watch_(watch), last_(watch.steps) {}
  // The size after one more step, over that at the start; whether another step is wanted.
  bool goes_on(double size);
  const Run& run() const { return run_; }

 private:
  Watch watch_;
  Run run_;
  int done_ = 0, last_, since_ = 0;
  double from_ = 0;
};

Run run_perturbed(const Experiment& experiment, const Watch& watch, int reach, double dt);

// Scan and bisection of any kind of run.
Observation observe(const std::function<Run(double dt)>& run, const Scan& scan, const Watch& watch);

}  // namespace plumbline
