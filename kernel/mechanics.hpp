// The engine behind the stages: chosen once per run by geometry, shape and transfer.
#pragma once

#include <memory>

#include "kernel/ledger.hpp"
#include "kernel/scene.hpp"
#include "kernel/stages.hpp"

namespace plumbline {

struct EngineOptions {
  bool keep_loss = false;               // points carry what the maps took, for return_transfer_loss()
  bool evaluates_stress_first = false;  // see IntegratorTraits
  int threads = 1;                      // >= 1; no result depends on it
};

class Engine : public Stages {
 public:
  // Several stages in one pass over the points; see fusions() (engine/stage_queue.hpp).
  // predict_stress(ahead), map_forces:
  virtual void predict_stress_and_map_forces(double ahead) = 0;
  // move_points, strain_points with the midpoint velocity, return_transfer_loss:
  virtual void move_and_heat_points(double dt) = 0;
  // The same with kick_points in place of move_points, and drift_points(drift) at the end:
  virtual void kick_heat_and_drift_points(double dt, double drift) = 0;

  // Initial densities and stresses, with strain rates zero.
  virtual void initialise() = 0;
  // Everything that the ledger's identity compares, summed from the points.
  virtual Totals totals() const = 0;
  // Densities and pressures by the scene's method where the points stand now, for measures.
  virtual void refresh_density() = 0;
  // Throws InadmissibleState if any point is.
  virtual void check() const = 0;
  // Upper limit of a stable step for Courant number 1, s: h / max(c_p + |v_p|), also h^2 / (2 dim diffusivity).
  virtual double step_limit() const = 0;
  // Time at the start of the next step, s.
  virtual void set_time(double time) = 0;
  // To be called after columns were set from outside to what they were at `time`, s.
  virtual void points_changed(double time) = 0;
  // To be called after points were put behind those of some body.
  virtual void points_added() = 0;
};

// An engine on `scene`, booking into `ledger`; both must outlive it. Throws std::invalid_argument for an unknown shape or
// transfer.
std::unique_ptr<Engine> make_engine(Scene& scene, Ledger& ledger, const EngineOptions& options);

}  // namespace plumbline
