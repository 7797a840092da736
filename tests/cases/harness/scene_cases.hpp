// The cases that run scenes; the others have trials.
#pragma once

#include <vector>

#include "cases/harness/description/case.hpp"

namespace plumbline {

inline std::vector<const Case*> scene_cases() {
  std::vector<const Case*> all;
  for (const Case* entry : cases()) {
    if (entry->trials.empty()) all.push_back(entry);
  }
  return all;
}

}  // namespace plumbline
