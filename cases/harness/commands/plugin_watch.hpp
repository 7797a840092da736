// What keeps an integrator of a plug-in from ending the program in silence, or from never ending it.
#pragma once

#include <memory>
#include <optional>
#include <string>

namespace plumbline {

// How long a call of an integrator may take, s, where no limit was given: `shortest_limit`, and for a step `per_number` for each
// number of the state that it advances. That is ten times what the longest step of a built-in integrator takes, an implicit
// midpoint of 20 corrections by 120 iterations of three rates of change, at 0.3 us a number and rate.
inline constexpr double shortest_limit = 60, per_number = 20 * 120 * 3 * 0.3e-6 * 10;

// While one lives, a call of a plug-in's integrator (cases/harness/run/guarded_integrator.hpp) that takes too long, calls exit() or
// std::terminate(), or raises SIGSEGV, SIGBUS, SIGFPE, SIGILL or SIGABRT ends the program with exit status 3 and says on standard
// error, and where asked as JSON on standard output, which integrator did what in which step. So does exit() outside of a call.
// What calls _exit() or raises SIGKILL cannot be told apart from an end of the program's own. One at a time.
class PluginWatch {
 public:
  // `limit`: s, of each call; none: as above.
  PluginWatch(std::optional<double> limit, bool json_on_stdout);
  ~PluginWatch();
  PluginWatch(const PluginWatch&) = delete;
  PluginWatch& operator=(const PluginWatch&) = delete;

 private:
  struct Watchman;
  std::unique_ptr<Watchman> watchman_;
};

}  // namespace plumbline
