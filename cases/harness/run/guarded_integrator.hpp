// Integrators of plug-ins at arm's length: whatever one throws becomes an error that names it, the step and the time, and
// who looks from another thread, from a signal handler or from exit() can tell which step is under way.
#pragma once

#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <string>

#include "kernel/time_integrator.hpp"

namespace plumbline {

// What stands as the field of a run that an integrator's misbehaviour stopped.
inline constexpr const char* misbehaviour_field = "integrator";

// An integrator did what none may. No runtime_error: where one of those is a finding, this is none.
struct MisbehavingIntegrator : std::exception {
  // `did`: "threw std::exception: boom". `call`: of TimeIntegrator; `step_number` and `step_time` (s) of the start, 0 elsewhere.
  MisbehavingIntegrator(const std::string& name, const std::string& did, const std::string& call, long step_number,
                        double step_time);
  const char* what() const noexcept override { return text_.c_str(); }

  std::string integrator, reason;  // reason: what() without step and time
  long step = 0;
  double time = 0;

 private:
  std::string text_;
};

// "threw std::exception: boom": of the exception that is being handled, in UTF-8, on one line, of 500 bytes of its text at most.
std::string what_was_thrown();

// What a thread lets an integrator of a plug-in do, as others may read it at any time.
struct WatchedCall {
  // Its name, which outlives the program's work; null: nothing is under way.
  std::atomic<const char*> integrator = nullptr;
  std::atomic<const char*> call = "";    // of TimeIntegrator
  std::atomic<long> step = 0;            // 0: no step
  std::atomic<double> time = 0;          // of its start, s
  std::atomic<std::size_t> numbers = 0;  // of the state that the step advances
  std::atomic<unsigned long> begun = 0;  // calls that this thread has begun
  std::atomic<bool> taken = false;       // by a thread
};

// Of this thread; null before its first call. Safe in a signal handler.
const WatchedCall* call_of_this_thread();

// Calls look(call) for every thread that is in one, and for those that have ended in one.
void for_calls_under_way(const std::function<void(const WatchedCall&)>& look);

// The entry behind a guard. What its integrators throw becomes MisbehavingIntegrator, but for InadmissibleState and
// Interrupted; so do a null pointer of make, copy, memory, kept or a parameter. `refusal`, if any: what the integrator did when it
// was tried, for which its steps are not called; each throws that at once.
IntegratorEntry guarded(const IntegratorEntry& entry, const std::string& refusal = {});

}  // namespace plumbline
