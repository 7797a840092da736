#include "cases/harness/commands/adapters.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "cases/harness/commands/child_process.hpp"
#include "cases/harness/files/json_text.hpp"

namespace plumbline {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_words = 300;

bool is_name(const std::string& text) {
  const auto fits = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || std::strchr("._+-", c);
  };
  return !text.empty() && text.front() != '.' && std::all_of(text.begin(), text.end(), fits);
}

// The last line of a log that says anything.
std::string last_words(const std::string& log) {
  std::ifstream in(log, std::ios::binary);
  std::string last;
  for (std::string line; std::getline(in, line);) {
    if (line.find_first_not_of(" \t\r") != std::string::npos) last = line.substr(0, longest_words);
  }
  return valid_utf8(last);
}

AdapterEnd judged(const ProgramEnd& end, bool has_result, double timeout, const std::string& log) {
  if (end.late) return {AdapterEnd::How::late, fmt::format("not done after {:g} s", timeout), end.seconds};
  if (end.status == 0 && has_result) return {AdapterEnd::How::written, "", end.seconds};
  const char* found = end.status == 0 ? "no result was written, " : "";
  return {AdapterEnd::How::failed, found + end_text(end.status, last_words(log)), end.seconds};
}

// Removes the result unless the adapter ends well, also where a signal keeps it from ending.
class Pending {
 public:
  explicit Pending(std::string result) : result_(std::move(result)) {}
  ~Pending() {
    std::error_code ignored;
    if (!result_.empty()) fs::remove(result_, ignored);
  }
  Pending(const Pending&) = delete;
  Pending& operator=(const Pending&) = delete;
  void keep() { result_.clear(); }

 private:
  std::string result_;
};

AdapterEnd run_on(const Adapter& adapter, const ScoreFolder& folder, const std::string& start, double timeout) {
  folder.clear(adapter.name, start);
  const std::string result = fs::absolute(folder.result(adapter.name, start)).string();
  const std::string log = folder.log(adapter.name, start);
  Pending pending(result);
  AdapterEnd end;
  try {
    const std::vector<std::string> words{adapter.path, fs::absolute(folder.start(start)).string(), result};
    const ProgramEnd ended = run_program(words, log, timeout);
    end = judged(ended, fs::exists(result), timeout, log);
  } catch (const std::system_error& error) {
    end = {AdapterEnd::How::failed, fmt::format("it cannot be started: {}", error.code().message()), 0};
  }
  if (end.how == AdapterEnd::How::written) pending.keep();
  folder.write_end(adapter.name, start, end);
  return end;
}

}  // namespace

Adapter adapter_from(const std::string& typed) {
  const std::size_t equals = typed.find('=');
  const std::string name = typed.substr(0, equals), path = equals < typed.size() ? typed.substr(equals + 1) : "";
  if (!is_name(name) || path.empty()) {
    throw UsageError("--run", typed, "NAME=PATH, the name of letters, digits and ._+-", {},
                     fmt::format("--run {}: NAME=PATH is wanted, the name of letters, digits and ._+-", typed));
  }
  if (!fs::is_regular_file(path) || ::access(path.c_str(), X_OK) != 0) {
    throw UsageError("--run", typed, "NAME=PATH, an executable file", {},
                     fmt::format("--run {}: {} is not a file that can be executed", typed, path));
  }
  return {name, fs::absolute(path).string()};
}

void run_adapter(const Adapter& adapter, const ScoreFolder& folder, double timeout, const Output& out) {
  folder.add_program(adapter.name);
  for (const std::string& start : folder.starts()) {
    const AdapterEnd end = run_on(adapter, folder, start, timeout);
    out.line("{} {}: {:.3g} s{}{}", adapter.name, start, end.seconds, end.reason.empty() ? "" : ", ", end.reason);
  }
}

}  // namespace plumbline
