// A run: a scene under a time integrator from 0 to t_end.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "kernel/inadmissible.hpp"
#include "kernel/ledger.hpp"
#include "kernel/mechanics.hpp"
#include "kernel/time_integrator.hpp"

namespace plumbline {

// The step: dt = cfl times the engine's step limit, or fixed.
struct StepControl {
  double cfl = 0.3;                               // > 0
  std::optional<double> dt;                       // s, > 0; overrides cfl
  int threads = 1;                                // >= 1; no result depends on it
  bool fusing = fuses_stages();                   // several stages in one pass, see engine/stage_queue.hpp
  std::map<std::string, double> parameters = {};  // of the integrator, by name; those of others may stand here too
};

// Everything a run is at one instant. Copy it to save a run; restoring it continues bitwise as if never interrupted.
struct Checkpoint {
  double time = 0;
  long step = 0;
  std::vector<Columns> points;  // of each body
  std::vector<std::vector<int>> ids, split_from;
  Ledger ledger;
  std::shared_ptr<const TimeIntegrator> integrator;  // with what it keeps from step to step
  // Engine::step_limit() of these points, which rounds with how they are parted into chunks: as they stood when they were last
  // located, which nobody can find again. Empty: it is found anew, as is right where points were changed.
  std::optional<double> step_limit = {};
};

class Simulation {
 public:
  // Throws std::invalid_argument for an unknown integrator, shape or transfer or a combination that cannot work.
  Simulation(Scene scene, const std::string& integrator, StepControl control);

  // Steps until `end` (s), the last step shortened to arrive there. after_step is called after each step.
  // Throws InadmissibleState with step and time set.
  void run_until(double end, const std::function<void(const Simulation&)>& after_step = {});

  // One step, no longer than `longest`.
  void step(double longest);

  const Scene& scene() const { return scene_; }
  const Ledger& ledger() const { return ledger_; }
  double time() const { return time_; }
  long steps() const { return step_; }
  long points() const;
  double last_dt() const { return last_dt_; }
  // The step that cfl = 1 stands for, s, as the points are now.
  double step_limit() const { return engine_->step_limit(); }
  // Densities and pressures where the points stand now.
  void refresh_density() { engine_->initialise(); }

  Checkpoint save() const;
  void restore(const Checkpoint& checkpoint);

 private:
  Scene scene_;
  Ledger ledger_;
  StepControl control_;
  std::function<std::unique_ptr<TimeIntegrator>(const TimeIntegrator&)> copy_integrator_;
  std::unique_ptr<TimeIntegrator> integrator_;
  std::unique_ptr<Engine> engine_;
  double time_ = 0, last_dt_ = 0;
  long step_ = 0;
  std::optional<double> restored_limit_ = {};  // of the step after a restart
};

}  // namespace plumbline
