#include "kernel/engine/stage_queue.hpp"

#include <algorithm>
#include <utility>

namespace plumbline {
namespace {

using Stage = StageCall::Stage;
using Calls = std::span<const StageCall>;

bool begins_with(const std::vector<Stage>& stages, Calls calls) {
  return calls.size() <= stages.size() &&
         std::equal(calls.begin(), calls.end(), stages.begin(),
                    [](const StageCall& call, Stage stage) { return call.stage == stage; });
}

// Whether the calls are the fusion's first ones.
bool may_become(const Fusion& fusion, Calls calls) { return begins_with(fusion.stages, calls) && fusion.holds(calls); }

// Whether call k, where it is there, is the points' strain over the step that moved or kicked them.
bool strains_with_midpoint(Calls calls, std::size_t k) {
  return calls.size() <= k || (calls[k].time == calls[0].time && calls[k].velocity == NodalVelocity::midpoint);
}

}  // namespace

// The stress at the half step and its forces; motion, strain and heat at the end of a step. [Leapfrog 2, 3] [EC-APIC 5, 6]
const std::vector<Fusion>& fusions() {
  static const std::vector<Fusion> all{
      {"predict stress, map forces",
       {Stage::predict_stress, Stage::map_forces},
       [](Calls calls) { return calls[0].velocity == NodalVelocity::start; },
       [](Engine& engine, Calls calls) { engine.predict_stress_and_map_forces(calls[0].time); },
       false},
      {"move, strain, heat",
       {Stage::move_points, Stage::strain_points, Stage::return_transfer_loss},
       [](Calls calls) { return calls[0].velocity == NodalVelocity::end && strains_with_midpoint(calls, 1); },
       [](Engine& engine, Calls calls) { engine.finish_points(calls[0].time, {}); },
       true},
      {"kick, drift, strain, heat",
       {Stage::kick_points, Stage::drift_points, Stage::strain_points, Stage::return_transfer_loss},
       [](Calls calls) { return strains_with_midpoint(calls, 2); },
       [](Engine& engine, Calls calls) { engine.finish_points(calls[0].time, calls[1].time); },
       true}};
  return all;
}

void StageCall::run(Engine& engine) const {
  switch (stage) {
    case Stage::predict_stress:
      return engine.predict_stress(time, velocity);
    case Stage::map_forces:
      return engine.map_forces();
    case Stage::move_points:
      return engine.move_points(time, velocity);
    case Stage::kick_points:
      return engine.kick_points(time);
    case Stage::strain_points:
      return engine.strain_points(time, velocity);
    case Stage::return_transfer_loss:
      return engine.return_transfer_loss();
    case Stage::drift_points:
      return engine.drift_points(time);
  }
}

void StageQueue::add(const StageCall& call) {
  if (!fusing_) return call.run(engine_);
  waiting_.calls.at(waiting_.count++) = call;
  for (const Fusion& fusion : fusions()) {
    if (!may_become(fusion, waiting_.all())) continue;
    if (waiting_.count < fusion.stages.size() || fusion.drops_weights) return;
    return fusion.run(engine_, std::exchange(waiting_, {}).all());
  }
  // What waited becomes no fusion with this call, which may begin one of its own.
  if (--waiting_.count == 0) return call.run(engine_);
  run_waiting();
  add(call);
}

void StageQueue::end_step() {
  for (const Fusion& fusion : fusions()) {
    if (waiting_.count != fusion.stages.size() || !may_become(fusion, waiting_.all())) continue;
    return fusion.run(engine_, std::exchange(waiting_, {}).all());
  }
  run_waiting();
}

void StageQueue::run_waiting() const {
  const Waiting calls = std::exchange(waiting_, {});
  for (const StageCall& call : calls.all()) call.run(engine_);
}

bool& fuses_stages() {
  static bool fuses = true;
  return fuses;
}

void take_step(TimeIntegrator& integrator, Engine& engine, double dt, bool fusing) {
  StageQueue stages(engine, fusing);
  integrator.step(stages, dt);
  stages.end_step();
}

}  // namespace plumbline
