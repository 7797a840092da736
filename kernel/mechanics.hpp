// The engine behind the stages: chosen once per run by geometry, shape and transfer.
#pragma once

#include <memory>
#include <optional>

#include "kernel/stages.hpp"
#include "kernel/survey.hpp"

namespace plumbline {

// How an engine serves an integrator: what its step was seen to do, see IntegratorTraits.
struct EngineOptions {
  bool keep_loss = false;               // points carry what the maps took, for return_transfer_loss()
  bool evaluates_stress_first = false;  // stresses need not follow sorted points
  bool keeps_order = false;             // states name points by their place
  int threads = 1;                      // >= 1; no result depends on it
};

class Engine : public Stages {
 public:
  // Several stages in one pass over the points; see fusions() (engine/stage_queue.hpp).
  // predict_stress(ahead), map_forces:
  virtual void predict_stress_and_map_forces(double ahead) = 0;
  // move_points, strain_points with the midpoint velocity, return_transfer_loss; with a drift, in s, kick_points and
  // drift_points(drift) in place of move_points. No later stage of the step may use the weights.
  virtual void finish_points(double dt, std::optional<double> drift) = 0;

  // Locates the points, and finds densities and stresses with strain rates zero: at the start of a run, and for measures.
  virtual void initialise() = 0;
  // Of the points as they are now.
  virtual const Survey& survey() const = 0;
  // Everything that the ledger's identity compares, summed from the points.
  const Totals& totals() const { return survey().totals; }
  double step_limit() const { return survey().step_limit; }
  // Time at the start of the next step, s.
  virtual void set_time(double time) = 0;
  // To be called after points were put behind those of some body, or columns set from outside: to what they were at `time`,
  // s, if that is another than now.
  virtual void points_changed(std::optional<double> time = {}) = 0;
};

// Whether steps fuse stages where nothing else is said: true until somebody sets it, before any step of the process.
bool& fuses_stages();

// An engine on `scene`, booking into `ledger`; both must outlive it. Throws std::invalid_argument for an unknown shape or
// transfer.
std::unique_ptr<Engine> make_engine(Scene& scene, Ledger& ledger, const EngineOptions& options);

}  // namespace plumbline
