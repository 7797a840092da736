#include "cases/harness/commands/child_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <system_error>
#include <thread>
#include <utility>

#include "cases/harness/files/errors.hpp"
#include "cases/harness/files/signals.hpp"

extern char** environ;

namespace plumbline {
namespace {

using Clock = std::chrono::steady_clock;
constexpr auto pause = std::chrono::milliseconds(2);  // between two looks at a process

// Waits for the process; its exit status, or 128 and its signal.
int status_of(pid_t process) {
  int status = 0;
  while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {}
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

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

struct Attributes {
  Attributes() { require(posix_spawnattr_init(&all), "posix_spawnattr_init"); }
  ~Attributes() { posix_spawnattr_destroy(&all); }
  Attributes(const Attributes&) = delete;
  Attributes& operator=(const Attributes&) = delete;
  posix_spawnattr_t all;
};

// Pointers to the words, as an argument list ends.
std::vector<char*> arguments_of(std::vector<std::string>& words) {
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  return arguments;
}

// A process that leads a group of its own. Until it has been waited for, its number is given to no other.
class Group {
 public:
  explicit Group(pid_t leader) : leader_(leader) {}
  ~Group() {
    if (leader_ > 0) end();
  }
  Group(const Group&) = delete;
  Group& operator=(const Group&) = delete;

  bool has_ended() const {
    siginfo_t found{};
    return ::waitid(P_PID, static_cast<id_t>(leader_), &found, WEXITED | WNOHANG | WNOWAIT) == 0 && found.si_pid != 0;
  }

  // Asks a leader that is still there to end, and kills what is left of the group after two seconds. How the leader ended.
  int end() {
    if (!has_ended()) ::kill(-leader_, SIGTERM);
    const auto patience = Clock::now() + std::chrono::seconds(2);
    while (!has_ended() && Clock::now() < patience) std::this_thread::sleep_for(pause);
    ::kill(-leader_, SIGKILL);
    return status_of(std::exchange(leader_, -1));
  }

 private:
  HasChildren that_end_first_;
  pid_t leader_;
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
    std::vector<std::string> copies{"plumbline"};
    copies.insert(copies.end(), words.begin(), words.end());
    error = posix_spawn(&process_, "/proc/self/exe", all, nullptr, arguments_of(copies).data(), environ);
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
    const auto patience = Clock::now() + std::chrono::seconds(20);
    while (::waitpid(process_, nullptr, WNOHANG) == 0) {
      if (Clock::now() > patience) ::kill(process_, SIGKILL);
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

int ChildProcess::wait() { return status_of(std::exchange(process_, -1)); }

ProgramEnd run_program(const std::vector<std::string>& words, const std::string& log, double timeout) {
  const Actions actions;
  posix_spawn_file_actions_t* all = const_cast<posix_spawn_file_actions_t*>(&actions.all);
  posix_spawn_file_actions_addopen(all, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(all, STDOUT_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_APPEND, 0666);
  posix_spawn_file_actions_adddup2(all, STDOUT_FILENO, STDERR_FILENO);
  const Attributes attributes;
  posix_spawnattr_t* own_group = const_cast<posix_spawnattr_t*>(&attributes.all);
  posix_spawnattr_setflags(own_group, POSIX_SPAWN_SETPGROUP);
  posix_spawnattr_setpgroup(own_group, 0);
  std::vector<std::string> copies = words;
  pid_t leader = -1;
  const auto begun = Clock::now();
  require(posix_spawn(&leader, words.front().c_str(), all, own_group, arguments_of(copies).data(), environ),
          words.front().c_str());
  Group group(leader);
  const auto elapsed = [&] { return std::chrono::duration<double>(Clock::now() - begun).count(); };
  while (!group.has_ended() && elapsed() < timeout) {
    throw_if_interrupted();
    std::this_thread::sleep_for(pause);
  }
  ProgramEnd end;
  end.late = !group.has_ended();
  end.seconds = elapsed();
  end.status = group.end();
  return end;
}

std::string end_text(int status, const std::string& last_words) {
  std::string text = status > 128 ? fmt::format("ended by signal {} ({})", status - 128, ::strsignal(status - 128))
                                  : fmt::format("exit status {}", status);
  if (!last_words.empty()) text += ": " + last_words;
  return text;
}

void end_with_parent(pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (::getppid() != parent) ::raise(SIGTERM);  // it ended before the line above
}

}  // namespace plumbline
