#include "cases/commands/child_process.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <system_error>
#include <thread>
#include <utility>

extern char** environ;

namespace plumbline {
namespace {

void require(int error, const char* what) {
  if (error != 0) throw std::system_error(error, std::generic_category(), what);
}

struct Actions {
  Actions() { require(posix_spawn_file_actions_init(&all), "posix_spawn_file_actions_init"); }
  ~Actions() { posix_spawn_file_actions_destroy(&all); }
  Actions(const Actions&) = delete;
  Actions& operator=(const Actions&) = delete;
  posix_spawn_file_actions_t all;
};

}  // namespace

ChildProcess::ChildProcess(const std::vector<std::string>& words) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) require(errno, "pipe");
  out_ = ends[0];
  int error = 0;
  {
    const Actions actions;
    posix_spawn_file_actions_t* all = const_cast<posix_spawn_file_actions_t*>(&actions.all);
    posix_spawn_file_actions_addopen(all, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(all, ends[1], STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(all, ends[1], STDERR_FILENO);
    std::vector<char*> arguments;
    std::string name = "plumbline";
    arguments.push_back(name.data());
    std::vector<std::string> copies = words;
    for (std::string& word : copies) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    error = posix_spawn(&process_, "/proc/self/exe", all, nullptr, arguments.data(), environ);
  }
  ::close(ends[1]);
  if (error != 0) {
    process_ = -1;
    ::close(out_);
    require(error, "cannot start a process");
  }
}

ChildProcess::ChildProcess(ChildProcess&& other) noexcept
    : process_(std::exchange(other.process_, -1)),
      out_(std::exchange(other.out_, -1)),
      rest_(std::move(other.rest_)) {}

ChildProcess& ChildProcess::operator=(ChildProcess&& other) noexcept {
  std::swap(process_, other.process_);
  std::swap(out_, other.out_);
  std::swap(rest_, other.rest_);
  return *this;
}

void ChildProcess::ask_to_end() const {
  if (process_ > 0) ::kill(process_, SIGTERM);
}

ChildProcess::~ChildProcess() {
  if (process_ > 0) {
    ask_to_end();
    const auto patience = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (::waitpid(process_, nullptr, WNOHANG) == 0) {
      if (std::chrono::steady_clock::now() > patience) ::kill(process_, SIGKILL);
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  }
  if (out_ >= 0) ::close(out_);
}

bool ChildProcess::read(std::vector<std::string>& lines) {
  char buffer[4096];
  const ssize_t count = ::read(out_, buffer, sizeof buffer);
  if (count < 0 && errno == EINTR) return true;
  if (count > 0) rest_.append(buffer, static_cast<std::size_t>(count));
  std::size_t start = 0;
  for (std::size_t end = rest_.find('\n'); end != std::string::npos; end = rest_.find('\n', start)) {
    lines.push_back(rest_.substr(start, end - start));
    start = end + 1;
  }
  rest_.erase(0, start);
  if (count <= 0 && !rest_.empty()) lines.push_back(std::exchange(rest_, {}));
  return count > 0;
}

int ChildProcess::wait() {
  int status = 0;
  while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {}
  process_ = -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

void end_with_parent(pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (::getppid() != parent) ::raise(SIGTERM);  // it ended before the line above
}

}  // namespace plumbline
