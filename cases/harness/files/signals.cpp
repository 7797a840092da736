#include "cases/harness/files/signals.hpp"

#include <sys/time.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstring>

#include "cases/harness/files/errors.hpp"

namespace plumbline {
namespace {

volatile std::sig_atomic_t arrived_signal = 0;
std::atomic<int> children = 0;
char temporary_file[4096] = "";
std::atomic<bool> has_temporary_file = false;
static_assert(std::atomic<int>::is_always_lock_free && std::atomic<bool>::is_always_lock_free, "read by handlers");

// Handlers call only what POSIX allows them.
extern "C" void note_signal(int signal_number) {
  if (arrived_signal != 0) {
    std::signal(signal_number, SIG_DFL);
    std::raise(signal_number);  // delivered when this handler returns
    return;
  }
  arrived_signal = signal_number;
  const auto microseconds = static_cast<suseconds_t>(signal_patience * 1e6);
  const itimerval once_and_again{{0, microseconds}, {0, microseconds}};
  ::setitimer(ITIMER_REAL, &once_and_again, nullptr);
}

extern "C" void end_now(int) {
  if (arrived_signal == 0 || children > 0) return;
  if (has_temporary_file) ::unlink(temporary_file);
  constexpr char words[] = "plumbline: interrupted, nothing is left half-written\n";
  if (::write(STDERR_FILENO, words, sizeof words - 1) < 0) ::_exit(128 + arrived_signal);
  ::_exit(128 + arrived_signal);
}

}  // namespace

void end_runs_on_signals() {
  std::signal(SIGALRM, end_now);
  std::signal(SIGINT, note_signal);
  std::signal(SIGTERM, note_signal);
  std::signal(SIGXFSZ, SIG_IGN);  // a file at its limit is then an error like a full disk, and is told
}

void throw_if_interrupted() {
  if (arrived_signal != 0) throw Interrupted(arrived_signal);
}

void being_written(const char* temporary) {
  has_temporary_file = false;  // a name half copied may be another file's
  const std::size_t length = std::strlen(temporary);
  if (length == 0 || length >= sizeof temporary_file) return;
  std::memcpy(temporary_file, temporary, length + 1);
  has_temporary_file = true;
}

HasChildren::HasChildren() { ++children; }
HasChildren::~HasChildren() { --children; }

}  // namespace plumbline
