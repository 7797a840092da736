#include "cases/harness/commands/plugin_watch.hpp"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <iterator>
#include <map>
#include <memory>
#include <mutex>
#include <thread>

#include "cases/harness/files/errors.hpp"
#include "cases/harness/run/guarded_integrator.hpp"

namespace plumbline {
namespace {

constexpr int fatal_signals[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};
struct sigaction actions_before[std::size(fatal_signals)];  // what was done on them
std::terminate_handler terminate_before = nullptr;

std::size_t at(int signal) {
  return static_cast<std::size_t>(std::find(std::begin(fatal_signals), std::end(fatal_signals), signal) -
                                  std::begin(fatal_signals));
}

std::atomic<bool> armed = false, json = false;
std::atomic_flag said = ATOMIC_FLAG_INIT;

void print(int to, const char* text) {
  for (std::size_t left = std::strlen(text); left > 0;) {
    const ssize_t count = ::write(to, text, left);
    if (count <= 0) return;
    text += count;
    left -= static_cast<std::size_t>(count);
  }
}

// Text within JSON without an escape: what is no printable ASCII, a quote or a backslash becomes an apostrophe.
void copy_plain(char* to, std::size_t size, const char* from) {
  std::size_t k = 0;
  for (; from[k] && k + 1 < size; ++k) {
    to[k] = from[k] < ' ' || from[k] > '~' || from[k] == '"' || from[k] == '\\' ? '\'' : from[k];
  }
  to[k] = '\0';
}

// Ends the program. Also called in signal handlers, with memory in disorder: nothing is allocated, no lock is taken. `call`: null
// if none is under way; `did`: "called exit".
[[noreturn]] void give_up(const WatchedCall* call, const char* did) {
  if (said.test_and_set()) {
    while (true) ::pause();  // another thread ends the program
  }
  const char* integrator = call ? call->integrator.load() : nullptr;
  char name[64] = "", action[512], message[1024], document[1536];
  copy_plain(action, sizeof action, did);
  if (integrator) copy_plain(name, sizeof name, integrator);
  if (!integrator) {
    std::snprintf(message, sizeof message, "a plug-in %s outside of its integrators' calls", action);
  } else if (call->step > 0) {
    std::snprintf(message, sizeof message, "integrator %s %s in step %ld, t = %.6g s", name, action, call->step.load(),
                  call->time.load());
  } else {
    std::snprintf(message, sizeof message, "integrator %s %s in %s()", name, action, call->call.load());
  }
  print(STDERR_FILENO, "plumbline: ");
  print(STDERR_FILENO, message);
  print(STDERR_FILENO, "\n");
  if (json) {
    std::snprintf(
        document, sizeof document,
        "{\"error\":{\"key\":\"integrator\",\"value\":\"%s\",\"allowed\":null,\"nearest\":[],\"message\":\"%s\"}}\n",
        name, message);
    print(STDOUT_FILENO, document);
  }
  ::_exit(exit_stopped);
}

// What was printed before is not lost, unless another thread is printing for ever.
void flush_output() {
  if (::ftrylockfile(stdout) != 0) return;
  std::fflush(stdout);
  ::funlockfile(stdout);
}

// A thread's own objects are gone when exit() asks: calls of all threads count.
void give_up_at_exit() {
  if (!armed) return;
  flush_output();
  for_calls_under_way([](const WatchedCall& call) { give_up(&call, "called exit"); });
  give_up(nullptr, "called exit");
}

// Called before whatever plug-ins do at the program's end, since it is registered after they were loaded: that is left out, for it
// could change the status.
void at_exit(int status, void*) {
  give_up_at_exit();
  std::fflush(nullptr);
  ::_exit(status);
}

// Each call of exit() takes a handler off the list: there is one for every thread that may call it while another is ending the
// program, or that call would end it with its own status.
bool register_at_exit() {
  constexpr int threads = 1024;
  bool registered = true;
  for (int k = 0; k < threads && registered; ++k)
    registered = ::on_exit(at_exit, nullptr) == 0 && std::at_quick_exit(give_up_at_exit) == 0;
  return registered;
}

[[noreturn]] void at_terminate() {
  const WatchedCall* call = call_of_this_thread();
  const std::string did = std::current_exception() ? what_was_thrown() + " where nothing may be thrown"
                                                   : "called std::terminate";
  flush_output();
  give_up(call && call->integrator ? call : nullptr, did.c_str());
}

// Outside of the integrators' calls the signal is the program's own, and does what it would have done.
extern "C" void at_fatal_signal(int signal) {
  const WatchedCall* call = call_of_this_thread();
  if (!armed || !call || !call->integrator) {
    ::sigaction(signal, &actions_before[at(signal)], nullptr);
    ::raise(signal);
    return;
  }
  char did[64];
  std::snprintf(did, sizeof did, "raised signal %d (%s)", signal, ::sigabbrev_np(signal) ? ::sigabbrev_np(signal) : "");
  give_up(call, did);
}

}  // namespace

// Looks at the calls under way. A time is counted by its own looks: one in which the program was stopped is none.
struct PluginWatch::Watchman {
  explicit Watchman(std::optional<double> longest)
      : limit(longest),
        between(std::min(1.0, longest ? *longest / 10 : 1.0)),
        thread([this] { watch(); }) {}
  ~Watchman() {
    {
      const std::lock_guard lock(guard);
      over = true;
    }
    wake.notify_one();
    thread.join();
  }

  void watch() {
    using Clock = std::chrono::steady_clock;
    struct Seen {
      unsigned long begun = 0;
      double age = 0;  // s
    };
    std::map<const WatchedCall*, Seen> all;
    auto last = Clock::now();
    std::unique_lock lock(guard);
    while (!wake.wait_for(lock, std::chrono::duration<double>(between), [this] { return over; })) {
      const auto now = Clock::now();
      const double passed = std::min(2 * between, std::chrono::duration<double>(now - last).count());
      last = now;
      for_calls_under_way([&](const WatchedCall& call) {
        Seen& seen = all[&call];
        if (seen.begun != call.begun) seen = {call.begun, 0};
        seen.age += passed;
        const double longest = limit ? *limit : shortest_limit + per_number * static_cast<double>(call.numbers.load());
        if (seen.age < longest || call.begun != seen.begun) return;
        char did[64];
        std::snprintf(did, sizeof did, "did not return within %.6g s", longest);
        flush_output();
        give_up(&call, did);
      });
    }
  }

  std::optional<double> limit;
  double between;  // looks, s
  std::mutex guard;
  std::condition_variable wake;
  bool over = false;
  std::thread thread;
};

PluginWatch::PluginWatch(std::optional<double> limit, bool json_on_stdout)
    : watchman_(std::make_unique<Watchman>(limit)) {
  static const bool registered = register_at_exit();
  json = json_on_stdout;
  armed = registered;
  terminate_before = std::set_terminate(at_terminate);
  // A stack of its own for the handler: a step may have used up this thread's.
  static char stack[1 << 16];
  const stack_t own{stack, 0, sizeof stack};
  ::sigaltstack(&own, nullptr);
  struct sigaction told {};
  told.sa_handler = at_fatal_signal;
  told.sa_flags = SA_ONSTACK;  // kept: another thread may meet a signal while the first is told
  for (const int signal : fatal_signals) ::sigaction(signal, &told, &actions_before[at(signal)]);
}

PluginWatch::~PluginWatch() {
  armed = false;
  std::set_terminate(terminate_before);
  for (const int signal : fatal_signals) ::sigaction(signal, &actions_before[at(signal)], nullptr);
}

}  // namespace plumbline
