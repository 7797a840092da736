// What a problem says of itself whose measures, or most of them, are made of the final state alone: any program's final
// state can be judged by them.
#pragma once

#include <string>
#include <vector>

#include "cases/harness/description/case.hpp"

namespace plumbline {

// To be inherited beside Problem. A problem without it is judged by what its run was like on the way.
class JudgedAtEnd {
 public:
  virtual ~JudgedAtEnd() = default;
  // Measures that are made of what Problem::observe() saw: a final state does not have them.
  virtual std::vector<std::string> seen_on_the_way() const { return {}; }
};

// The measures that a final state has: all but those seen on the way.
std::vector<Measure> measures_at_end(const Problem& problem, const Simulation& simulation);

// The measures of the start as it stands, taken for the end: the errors of doing nothing.
std::vector<Measure> measures_of_start(const Problem& problem, const Settings& settings);

}  // namespace plumbline
