// What an integrator says, as one list: stages wait until it is clear whether the engine knows one pass over the points for
// several of them. Integrators see the unfused vocabulary alone.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "kernel/mechanics.hpp"
#include "kernel/time_integrator.hpp"

namespace plumbline {

// A stage that may wait, with its arguments. Those that return something, or that no fusion holds, are never in a list.
struct StageCall {
  enum class Stage {
    predict_stress,
    map_forces,
    move_points,
    kick_points,
    strain_points,
    return_transfer_loss,
    drift_points
  };
  Stage stage = Stage::predict_stress;
  double time = 0;  // s: dt, or how far ahead
  NodalVelocity velocity = NodalVelocity::current;

  void run(Engine& engine) const;
};

// Stages in a row that the engine does in one pass, with the numbers of the single stages to rounding.
struct Fusion {
  const char* name;
  std::vector<StageCall::Stage> stages;
  bool (*holds)(std::span<const StageCall> calls);  // of as many calls as are there; their stages are those above
  void (*run)(Engine& engine, std::span<const StageCall> calls);
  bool drops_weights;  // after it no stage may follow in the step but locate_points()
};
const std::vector<Fusion>& fusions();

// Passes stages on to an engine, fused where the table of fusions says so. The last of them may wait until end_step().
class StageQueue final : public Stages {
 public:
  // fusing false: every stage by itself, at once. `engine` must outlive this.
  explicit StageQueue(Engine& engine, bool fusing = true) : engine_(engine), fusing_(fusing) {}

  void end_step() override;

  void locate_points() override {
    end_step();
    engine_.locate_points();
  }
  void map_mass_and_momentum() override { settled().map_mass_and_momentum(); }
  void map_forces() override { add({StageCall::Stage::map_forces}); }
  void advance_momentum(double dt) override { settled().advance_momentum(dt); }
  void move_points(double dt, NodalVelocity carrying) override { add({StageCall::Stage::move_points, dt, carrying}); }
  void drift_points(double dt) override { add({StageCall::Stage::drift_points, dt}); }
  void kick_points(double dt) override { add({StageCall::Stage::kick_points, dt}); }
  void map_momentum() override { settled().map_momentum(); }
  void strain_points(double dt, NodalVelocity velocity) override {
    add({StageCall::Stage::strain_points, dt, velocity});
  }
  void evaluate_stress(NodalVelocity velocity) override { settled().evaluate_stress(velocity); }
  void predict_stress(double ahead, NodalVelocity velocity) override {
    add({StageCall::Stage::predict_stress, ahead, velocity});
  }
  bool reverse_cooling() override { return settled().reverse_cooling(); }
  void return_transfer_loss() override { add({StageCall::Stage::return_transfer_loss}); }
  State state() const override { return settled().state(); }
  void set_state(const State& state) override { settled().set_state(state); }
  State rate() override { return settled().rate(); }
  State velocities_of(State state) const override { return engine_.velocities_of(std::move(state)); }

 private:
  void add(const StageCall& call);
  void run_waiting() const;
  // The engine once nothing waits any longer.
  Engine& settled() const {
    run_waiting();
    return engine_;
  }

  // At most as many as the longest fusion has, and the one that ends the waiting.
  struct Waiting {
    std::array<StageCall, 5> calls;
    std::size_t count = 0;
    std::span<const StageCall> all() const { return {calls.data(), count}; }
  };

  Engine& engine_;
  bool fusing_;
  mutable Waiting waiting_;
};

// One step of dt, s.
void take_step(TimeIntegrator& integrator, Engine& engine, double dt, bool fusing = fuses_stages());

}  // namespace plumbline
