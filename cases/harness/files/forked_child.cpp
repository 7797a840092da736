#include "cases/harness/files/forked_child.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <system_error>

namespace plumbline {
namespace {

void end_with_parent_and_quietly() {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) ::signal(signal, SIG_DFL);
  const rlimit none{0, 0};
  ::setrlimit(RLIMIT_CORE, &none);
  if (const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC); nowhere >= 0) ::dup2(nowhere, STDOUT_FILENO);
}

}  // namespace

ForkedChild::ForkedChild(const std::function<void()>& work) : process_(::fork()) {
  if (process_ < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (process_ > 0) return;
  end_with_parent_and_quietly();
  [&]() noexcept { work(); }();
  ::_exit(0);
}

ForkedChild::~ForkedChild() {
  if (process_ > 0) end();
}

bool ForkedChild::has_ended() {
  if (process_ > 0 && ::waitpid(process_, &status_, WNOHANG) == process_) process_ = 0;
  return process_ == 0;
}

void ForkedChild::wait() {
  while (process_ > 0 && ::waitpid(process_, &status_, 0) < 0 && errno == EINTR) {}
  process_ = 0;
}

void ForkedChild::end() {
  if (process_ > 0) ::kill(process_, SIGKILL);
  wait();
}

std::string ForkedChild::how() const {
  return WIFSIGNALED(status_) ? fmt::format("died of signal {} ({})", WTERMSIG(status_), ::strsignal(WTERMSIG(status_)))
                              : fmt::format("ended the program with exit status {}", WEXITSTATUS(status_));
}

}  // namespace plumbline
