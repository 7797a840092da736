// A copy of this process for work that may not come back: files and plug-ins of others.
#pragma once

#include <sys/types.h>

#include <functional>
#include <string>

namespace plumbline {

// Ended with this object and with this process, if not before.
class ForkedChild {
 public:
  // The child does `work`, then ends with exit status 0; an exception ends it. It leaves no core and writes nothing to standard
  // output. Throws std::system_error where no process can be had.
  explicit ForkedChild(const std::function<void()>& work);
  ~ForkedChild();
  ForkedChild(const ForkedChild&) = delete;
  ForkedChild& operator=(const ForkedChild&) = delete;

  // Whether it has ended by itself, or was ended.
  bool has_ended();
  // Waits for a child that is about to end.
  void wait();
  void end();
  // Of one that has ended: "died of signal 11 (Segmentation fault)".
  std::string how() const;

 private:
  pid_t process_ = 0;  // 0: it has ended
  int status_ = 0;
};

}  // namespace plumbline
