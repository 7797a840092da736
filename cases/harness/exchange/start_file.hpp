// Reads an exported start: which problem it is, and what the default scheme needs to start from the same points.
#pragma once

#include <string>
#include <vector>

#include "cases/harness/description/case.hpp"

namespace plumbline {

struct Start {
  std::string name;                // of its file, without folders
  const Case* entry = nullptr;     // one that can be scored
  int cells = 0;                   // > 0
  std::vector<std::string> typed;  // "key=value": physics and placing of the points where it is not the default's

  // Of the default scheme from this start.
  Settings settings() const;
};

// Throws FileError for a file that is no start, UsageError for one of a case that is unknown here or cannot be scored, or of
// physics that this version has not.
Start read_start(const std::string& path);

}  // namespace plumbline
