// Children of this program: itself again, whose output is read line by line, and programs of others.
#pragma once

#include <sys/types.h>
#include <string>
#include <vector>

namespace plumbline {

class ChildProcess {
 public:
  // Starts this very program with the words. Standard output and error go to one pipe, standard input is empty. Throws
  // std::system_error.
  explicit ChildProcess(const std::vector<std::string>& words);
  ~ChildProcess();  // ends it, if it has not been waited for
  ChildProcess(ChildProcess&& other) noexcept;
  ChildProcess& operator=(ChildProcess&& other) noexcept;

  int descriptor() const { return out_; }  // to poll for output
  // The whole lines that have come since; false once its output has ended. Blocks if there is nothing to read.
  bool read(std::vector<std::string>& lines);
  // Its exit status, or 128 and its signal. Blocks until it has ended.
  int wait();
  // Asks it to end, as the signal does: it leaves nothing half-written.
  void ask_to_end() const;

 private:
  pid_t process_ = -1;
  int out_ = -1;
  std::string rest_;
};

// How a program of somebody else's ended.
struct ProgramEnd {
  int status = 0;      // exit status, or 128 and its signal
  bool late = false;   // it was ended because its time was up
  double seconds = 0;  // wall time
};
// Runs the program `words[0]` (a path) and waits for its end, `timeout` seconds at most. Its standard input is empty, output and
// errors go to the file `log`. It has a process group of its own: what it started ends with it. Throws std::system_error where
// it cannot be started, Interrupted.
ProgramEnd run_program(const std::vector<std::string>& words, const std::string& log, double timeout);

// How a child ended, for people: its exit status (or 128 and its signal) and the last that it said, if anything.
std::string end_text(int status, const std::string& last_words);

// Lets the system end this process when its parent ends, however that does. `parent`: the parent's process number.
void end_with_parent(pid_t parent);

}  // namespace plumbline
