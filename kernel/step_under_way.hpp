// Which step of a simulation a thread is in, for whoever has to say where an integrator went wrong.
#pragma once

namespace plumbline {

struct StepUnderWay {
  long step = 0;    // 0: none
  double time = 0;  // of its start, s
};

// Of this thread.
inline StepUnderWay& step_under_way() {
  static thread_local StepUnderWay here;
  return here;
}

// Says for as long as it lives that the thread is in a step.
class InStep {
 public:
  InStep(long step, double time) { step_under_way() = {step, time}; }
  ~InStep() { step_under_way() = {}; }
  InStep(const InStep&) = delete;
  InStep& operator=(const InStep&) = delete;
};

}  // namespace plumbline
