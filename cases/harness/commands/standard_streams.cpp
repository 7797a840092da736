#include "cases/harness/commands/standard_streams.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <iostream>
#include <system_error>

#include "cases/harness/files/errors.hpp"
#include "cases/harness/files/json_text.hpp"

namespace plumbline {
namespace {

int output_error = 0;  // the first that writing to standard output met

}  // namespace

void open_standard_streams() {
  // A descriptor that is opened takes the lowest free number. Of standard output it cannot be written to.
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(stream, F_GETFD) >= 0) continue;
    if (::open("/dev/null", stream == STDERR_FILENO ? O_WRONLY : O_RDONLY) != stream) ::_exit(exit_files);
  }
}

void print_text(std::FILE* stream, const std::string& anything) {
  const std::string text = valid_utf8(anything);
  const bool whole = std::fwrite(text.data(), 1, text.size(), stream) == text.size();
  if (!whole && stream == stdout && output_error == 0) output_error = errno;
}

int after_output(int status) {
  std::cout.flush();  // CLI11 prints help there
  const bool lost = std::fflush(stdout) != 0 || std::ferror(stdout) != 0 || !std::cout;
  if (lost && output_error == 0) output_error = errno;
  if (!lost && output_error == 0) return status;
  print_text(stderr, fmt::format("plumbline: standard output cannot be written: {}\n",
                                 std::generic_category().message(output_error)));
  return exit_files;
}

}  // namespace plumbline
