#include "cases/harness/run/guarded_integrator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <mutex>
#include <utility>

#include "cases/harness/files/errors.hpp"
#include "cases/harness/files/json_text.hpp"
#include "kernel/inadmissible.hpp"
#include "kernel/step_under_way.hpp"

namespace plumbline {
namespace {

constexpr long between_counts = 256;  // steps; scenes grow slowly

std::mutex guard;
std::deque<WatchedCall>& watched_calls() {
  static auto* all = new std::deque<WatchedCall>;  // never destroyed: exit() asks for it
  return *all;
}
thread_local WatchedCall* mine = nullptr;

// A thread's place in the list. One that ends in a call, as by exit(), leaves it there.
class Place {
 public:
  Place() {
    const std::lock_guard lock(guard);
    for (WatchedCall& call : watched_calls()) {
      if (!mine && !call.taken) mine = &call;
    }
    if (!mine) mine = &watched_calls().emplace_back();
    mine->taken = true;
  }
  ~Place() {
    if (!mine->integrator) mine->taken = false;
  }
  Place(const Place&) = delete;
  Place& operator=(const Place&) = delete;
};

WatchedCall& own_call() {
  static thread_local const Place place;
  return *mine;
}

struct Original {
  IntegratorEntry entry;
  std::string refusal;
};

// Which call of an integrator is made.
struct Call {
  const char* name;
  long step = 0;
  double time = 0;
  std::size_t numbers = 0;
};

// Result of work(), watched.
template <class Work>
auto watched(const Original& original, const Call& call, Work&& work) -> decltype(work()) {
  WatchedCall& here = own_call();
  struct Under {
    ~Under() { of.integrator = before; }
    WatchedCall& of;
    const char* before;
  } const under{here, here.integrator};
  here.call.store(call.name, std::memory_order_relaxed);
  here.step.store(call.step, std::memory_order_relaxed);
  here.time.store(call.time, std::memory_order_relaxed);
  here.numbers.store(call.numbers, std::memory_order_relaxed);
  here.begun.store(here.begun.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
  here.integrator = original.entry.name.c_str();
  const auto misbehaves = [&](const std::string& did) {
    return MisbehavingIntegrator(original.entry.name, did, call.name, call.step, call.time);
  };
  try {
    return work();
  } catch (const InadmissibleState&) {
    throw;
  } catch (const Interrupted&) {
    throw;
  } catch (const MisbehavingIntegrator&) {
    throw;
  } catch (...) {
    throw misbehaves(what_was_thrown());
  }
}

class Guarded final : public TimeIntegrator {
 public:
  // `integrator`: null where the original is refused.
  Guarded(const Original& original, std::unique_ptr<TimeIntegrator> integrator)
      : original_(original),
        integrator_(std::move(integrator)) {}

  // A copy of it takes the count of its steps along.
  Guarded(const Guarded& other, std::unique_ptr<TimeIntegrator> integrator)
      : original_(other.original_),
        integrator_(std::move(integrator)),
        steps_(other.steps_),
        time_(other.time_),
        numbers_(other.numbers_) {}

  void step(Stages& mpm, double dt) override {
    const StepUnderWay run = step_under_way();
    const Call call{"step", run.step > 0 ? run.step : steps_ + 1, run.step > 0 ? run.time : time_, numbers_};
    if (!integrator_) {
      throw MisbehavingIntegrator(original_.entry.name, original_.refusal, call.name, call.step, call.time);
    }
    if (steps_ % between_counts == 0) numbers_ = mpm.state().values.size();
    ++steps_;
    time_ += dt;
    watched(original_, call, [&] {
      integrator_->step(mpm, dt);
      mpm.end_step();
    });
  }

  std::vector<IntegratorParameter> parameters() override {
    return listed("parameters", &TimeIntegrator::parameters, "named a parameter without a value",
                  [](const IntegratorParameter& parameter) { return parameter.value != nullptr; });
  }

  std::vector<State*> memory() override {
    return listed("memory", &TimeIntegrator::memory, "named a state that is none",
                  [](const State* state) { return state != nullptr; });
  }

  std::vector<double*> kept() override {
    return listed("kept", &TimeIntegrator::kept, "named a number that is none",
                  [](const double* number) { return number != nullptr; });
  }

  Claims claims() const override {
    if (!integrator_) return {};
    return watched(original_, {"claims"}, [&] { return integrator_->claims(); });
  }

  std::unique_ptr<TimeIntegrator> copy() const {
    if (!integrator_) return std::make_unique<Guarded>(*this, nullptr);
    auto made = watched(original_, {"copy"}, [&] { return original_.entry.copy(*integrator_); });
    if (!made) misbehave("copy", "made nothing");
    return std::make_unique<Guarded>(*this, std::move(made));
  }

 private:
  [[noreturn]] void misbehave(const char* call, const char* did) const {
    throw MisbehavingIntegrator(original_.entry.name, did, call, 0, 0);
  }

  // What the integrator lists of itself. `did`: what it did if one entry is none.
  template <class Entry, class IsOne>
  std::vector<Entry> listed(const char* call, std::vector<Entry> (TimeIntegrator::*list)(), const char* did,
                            IsOne is_one) {
    if (!integrator_) return {};
    return watched(original_, {call}, [&] {
      std::vector<Entry> all = (integrator_.get()->*list)();
      if (!std::all_of(all.begin(), all.end(), is_one)) misbehave(call, did);
      return all;
    });
  }

  const Original& original_;
  std::unique_ptr<TimeIntegrator> integrator_;
  long steps_ = 0;
  double time_ = 0;
  std::size_t numbers_ = 0;
};

std::unique_ptr<TimeIntegrator> make_guarded(const Original& original) {
  if (!original.refusal.empty()) return std::make_unique<Guarded>(original, nullptr);
  auto made = watched(original, {"make"}, [&] { return original.entry.make(); });
  if (!made) throw MisbehavingIntegrator(original.entry.name, "made nothing", "make", 0, 0);
  return std::make_unique<Guarded>(original, std::move(made));
}

}  // namespace

MisbehavingIntegrator::MisbehavingIntegrator(const std::string& name, const std::string& did, const std::string& call,
                                             long step_number, double step_time)
    : integrator(name),
      reason(fmt::format("integrator {} {}{}", name, did, step_number > 0 ? "" : " in " + call + "()")),
      step(step_number),
      time(step_time),
      text_(step_number > 0 ? fmt::format("{} in step {}, t = {:.6g} s", reason, step, time) : reason) {}

std::string what_was_thrown() {
  constexpr std::size_t longest = 500;
  try {
    throw;
  } catch (const std::exception& error) {
    const char* what = error.what();
    std::string text = valid_utf8(std::string(what ? what : "").substr(0, longest));
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c >= 0 && c < ' '; }, ' ');
    return "threw std::exception: " + text;
  } catch (...) {
    return "threw what is no std::exception";
  }
}

const WatchedCall* call_of_this_thread() { return mine; }

void for_calls_under_way(const std::function<void(const WatchedCall&)>& look) {
  const std::lock_guard lock(guard);
  for (const WatchedCall& call : watched_calls()) {
    if (call.integrator) look(call);
  }
}

IntegratorEntry guarded(const IntegratorEntry& entry, const std::string& refusal) {
  static auto* originals = new std::deque<Original>;  // never destroyed: integrators and calls refer to them
  const Original& original = originals->emplace_back(Original{entry, refusal});
  IntegratorEntry behind = entry;
  behind.make = [&original] { return make_guarded(original); };
  behind.copy = [](const TimeIntegrator& now) { return static_cast<const Guarded&>(now).copy(); };
  return behind;
}

}  // namespace plumbline
