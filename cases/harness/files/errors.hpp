// What a user can get wrong, as errors that name it.
#pragma once

#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

#include "kernel/traits.hpp"

namespace plumbline {

inline constexpr int exit_red = 1, exit_usage = 2, exit_stopped = 3, exit_files = 4;

// The call is wrong: unknown name or key, value out of range, impossible combination. Exit status 2.
struct UsageError : std::runtime_error {
  UsageError(std::string key_, std::string value_, std::string allowed_, std::vector<std::string> nearest_,
             const std::string& message)
      : std::runtime_error(message),
        key(std::move(key_)),
        value(std::move(value_)),
        allowed(std::move(allowed_)),
        nearest(std::move(nearest_)) {}
  std::string key, value, allowed;
  std::vector<std::string> nearest;
};

// Parts that cannot work together: what is missing of which.
struct MissingTraits : UsageError {
  MissingTraits(const std::string& key_, const std::string& value_, const std::string& allowed_,
                const std::string& with, std::vector<Lack> missing)
      : UsageError(key_, value_, allowed_, {},
                   key_ + "=" + value_ + " cannot work with " + with + ": " + CannotWork(missing).what()),
        lacks(std::move(missing)) {}
  std::vector<Lack> lacks;
};

// Unreadable, not writable, damaged or newer files. Exit status 4.
struct FileError : std::runtime_error {
  FileError(std::string path_, const std::string& message) : std::runtime_error(message), path(std::move(path_)) {}
  std::string path;
};

// SIGINT or SIGTERM arrived. No runtime_error: where one of those is a finding, this is none.
struct Interrupted : std::exception {
  explicit Interrupted(int signal_number) : signal(signal_number) {}
  const char* what() const noexcept override { return "interrupted"; }
  int signal;
};

// An unknown name among known ones: the message offers the nearest. `what`: "case", "key of sod", ...
UsageError unknown_name(const std::string& what, const std::string& value, const std::vector<std::string>& known);

}  // namespace plumbline
