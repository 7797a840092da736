// What the switches stand for that ci/judging/systematic.py puts into the sources of the built-in integrators.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "kernel/time_integrator.hpp"

namespace plumbline::switched {

// The change that is on in the step under way, by its number; a place's changes are numbered one after the other.
inline thread_local int active = 0;

// Of a number given to a stage.
inline double factor(int first) { return active == first ? 0.999 : active == first + 1 ? 1.001 : 1; }

// How often a stage is called.
inline int repeats(int first) { return active == first ? 0 : active == first + 1 ? 2 : 1; }

// A state that a call returns: times 0.999, times 1.001, or zero.
template <class Call>
State scaled(int first, Call&& call) {
  return (active == first + 2 ? 0 : factor(first)) * call();
}

// A state that a call returns, or zero.
template <class Call>
State kept(int first, Call&& call) {
  return (active == first ? 0 : 1) * call();
}

// What a call answers: false where it is left out; of two calls whether any says so.
template <class Call>
bool answer(int first, Call&& call) {
  bool any = false;
  for (int left = repeats(first); left > 0; --left) any = call() || any;
  return any;
}

// An integrator with one of its changes on. Users choose nothing: the keys are those of the original.
template <class Original>
class Changed final : public Original {
 public:
  explicit Changed(int number) : number_(number) {}
  void step(Stages& mpm, double dt) override {
    active = number_;
    Original::step(mpm, dt);
  }
  std::vector<IntegratorParameter> parameters() override { return {}; }

 private:
  int number_;
};

struct ChangeEntry {
  int number;
  std::string name, title;
};

template <class Original>
struct Registered {
  explicit Registered(const std::vector<ChangeEntry>& changes) {
    for (const ChangeEntry& change : changes) {
      RegisterIntegrator({change.name, change.title, "ci/judging/systematic.py",
                          [number = change.number] { return std::make_unique<Changed<Original>>(number); },
                          [](const TimeIntegrator& now) {
                            return std::make_unique<Changed<Original>>(static_cast<const Changed<Original>&>(now));
                          }});
    }
  }
};

}  // namespace plumbline::switched
