// SIGINT and SIGTERM: the first ends the work under way within a second, wherever the program is; the second at once.
#pragma once

namespace plumbline {

// Installs the handlers. Work that looks by throw_if_interrupted() ends by itself; what does not, as a set-up, a reference or a
// measure, is ended after `signal_patience`, with the exit status that a signal has, 128 and its number, and no file half-written.
inline constexpr double signal_patience = 0.7;  // s
void end_runs_on_signals();

// Throws Interrupted if one has arrived.
void throw_if_interrupted();

// The file that this process is writing under a temporary name, for what ends it to remove; "" when it is whole. At most 4095
// bytes of the name are kept, and of files that threads write at once the last.
void being_written(const char* temporary);

// While one lives, this process has children to end before itself, and is not ended after `signal_patience`.
class HasChildren {
 public:
  HasChildren();
  ~HasChildren();
  HasChildren(const HasChildren&) = delete;
  HasChildren& operator=(const HasChildren&) = delete;
};

}  // namespace plumbline
