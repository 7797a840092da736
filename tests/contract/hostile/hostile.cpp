// An integrator that does what none may, as the environment says: HOSTILE_LOAD while it is loaded, HOSTILE_NAME is its name,
// HOSTILE_MAKE when it is asked for what it is, HOSTILE_STEP in its step number HOSTILE_AT (1 if not given). Else it is `usl`.
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <thread>

#include "kernel/time_integrator.hpp"

namespace {

using namespace plumbline;

std::string asked(const char* variable, const char* otherwise = "") {
  const char* value = std::getenv(variable);
  return value ? value : otherwise;
}

struct Odd {};
struct Silent : std::exception {
  const char* what() const noexcept override { return nullptr; }
};

volatile bool forever = true;
void loop() {
  while (forever) {}
}

int use_up_the_stack(int depth) {
  volatile char frame[4096];
  frame[0] = static_cast<char>(depth);
  return depth < 0 ? 0 : use_up_the_stack(depth + 1) + frame[0];
}

void boom() { throw std::runtime_error("boom"); }
void throw_where_none_may() noexcept { boom(); }

// What ends a program, or does not let it end.
void misdo(const std::string& how) {
  if (how == "throw") throw std::runtime_error("boom \"in\"\n\xff");
  if (how == "throw-int") throw 7;
  if (how == "throw-odd") throw Odd();
  if (how == "throw-silent") throw Silent();
  if (how == "throw-noexcept") throw_where_none_may();
  if (how == "exit") std::exit(0);
  if (how == "quick-exit") std::quick_exit(0);
  if (how == "thread-exit") std::thread([] { std::exit(0); }).join();
  if (how == "_exit") ::_exit(0);
  if (how == "abort") std::abort();
  if (how == "terminate") std::terminate();
  if (how == "crash") *reinterpret_cast<volatile int*>(16) = 1;
  if (how == "overflow") use_up_the_stack(0);
  if (how == "kill") ::raise(SIGKILL);
  if (how == "loop") loop();
  if (how == "sleep") std::this_thread::sleep_for(std::chrono::hours(1));
}

void one_stage(Stages& mpm, double dt, unsigned which) {
  constexpr NodalVelocity velocities[] = {NodalVelocity::current, NodalVelocity::start, NodalVelocity::end,
                                          NodalVelocity::midpoint, NodalVelocity::remapped};
  const NodalVelocity velocity = velocities[which / 14 % 5];
  switch (which % 14) {
    case 0:
      return mpm.locate_points();
    case 1:
      return mpm.map_mass_and_momentum();
    case 2:
      return mpm.map_forces();
    case 3:
      return mpm.advance_momentum(dt);
    case 4:
      return mpm.move_points(dt, velocity);
    case 5:
      return mpm.drift_points(dt);
    case 6:
      return mpm.kick_points(dt);
    case 7:
      return mpm.map_momentum();
    case 8:
      return mpm.strain_points(dt, velocity);
    case 9:
      return mpm.evaluate_stress(velocity);
    case 10:
      return mpm.predict_stress(dt, velocity);
    case 11:
      return static_cast<void>(mpm.reverse_cooling());
    case 12:
      return mpm.return_transfer_loss();
    default:
      return mpm.set_state(mpm.state());
  }
}

// Stages in any order. What the engine refuses is passed over: the next is called all the same.
void any_order(Stages& mpm, double dt, unsigned seed) {
  std::minstd_rand random(seed);
  for (int k = 0; k < 12; ++k) {
    try {
      one_stage(mpm, dt, static_cast<unsigned>(random()));
    } catch (const std::logic_error&) {}
  }
}

class Hostile final : public TimeIntegrator {
 public:
  void step(Stages& mpm, double dt) override {
    const std::string how = asked("HOSTILE_STEP");
    if (++steps_ < std::atoi(asked("HOSTILE_AT", "1").c_str())) return good(mpm, dt);
    misdo(how);
    if (how == "nothing") return;
    if (how == "any-order")
      return any_order(mpm, dt,
                       static_cast<unsigned>(steps_) + static_cast<unsigned>(std::atoi(asked("HOSTILE_SEED").c_str())));
    if (how == "never-located") return without_places(mpm, dt);
    good(mpm, dt);
    State state = mpm.state();
    if (how == "nan") state.values.at(state.values.size() / 2) = std::numeric_limits<double>::quiet_NaN();
    if (how == "short-state") state.values.resize(3);
    if (how == "long-state") state.values.resize(2 * state.values.size());
    if (how == "nan" || how == "short-state" || how == "long-state") mpm.set_state(state);
    if (how == "long-rate") mpm.set_state(mpm.velocities_of(State{std::vector<double>(1000000)}));
  }
  std::vector<IntegratorParameter> parameters() override {
    const std::string how = asked("HOSTILE_MAKE");
    if (how == "throw-parameters") throw Odd();
    if (how == "null-parameter") return {{"hostile_number", nullptr, 0, 1, "points nowhere"}};
    if (how == "parameter-out-of-range") return {{"hostile_number", &number_, 2, 3, "is 0.5"}};
    if (how == "parameter-name") return {{"no\nname", &number_, 0, 1, "cannot be typed"}};
    return {};
  }
  std::vector<State*> memory() override {
    if (asked("HOSTILE_MAKE") == "null-memory") return {nullptr};
    return {};
  }
  Claims claims() const override {
    if (asked("HOSTILE_MAKE") == "exit-claims") std::exit(0);
    if (asked("HOSTILE_MAKE") == "loop-claims") loop();
    return {};
  }

 private:
  static void good(Stages& mpm, double dt) {
    mpm.locate_points();
    mpm.map_mass_and_momentum();
    mpm.map_forces();
    mpm.advance_momentum(dt);
    mpm.move_points(dt);
    mpm.update_stress(dt);
  }
  static void without_places(Stages& mpm, double dt) {
    mpm.map_mass_and_momentum();
    mpm.evaluate_stress(NodalVelocity::start);
    mpm.map_forces();
    mpm.advance_momentum(dt);
    mpm.move_points(dt);
    mpm.strain_points(dt, NodalVelocity::midpoint);
    mpm.return_transfer_loss();
  }

  int steps_ = 0;
  double number_ = 0.5;
};

std::unique_ptr<TimeIntegrator> make() {
  if (asked("HOSTILE_MAKE") == "null") return nullptr;
  if (asked("HOSTILE_MAKE") == "throw") throw std::runtime_error("cannot be made");
  return std::make_unique<Hostile>();
}

std::unique_ptr<TimeIntegrator> copy(const TimeIntegrator& now) {
  if (asked("HOSTILE_MAKE") == "null-copy") return nullptr;
  return std::make_unique<Hostile>(static_cast<const Hostile&>(now));
}

struct Registration {
  Registration() {
    const std::string how = asked("HOSTILE_LOAD");
    misdo(how);
    if (how == "at-exit") std::atexit([] { ::_exit(0); });
    const IntegratorEntry entry{asked("HOSTILE_NAME", "hostile"), "does what none may",
                                how == "bad-text" ? "\xff" : "nobody", make, copy};
    if (how != "nothing") RegisterIntegrator{entry};
    if (how == "twice") RegisterIntegrator{entry};
    if (how == "no-copy") RegisterIntegrator{{"hostile-without-copy", "", "", make, {}}};
  }
};
const Registration registration;

}  // namespace
