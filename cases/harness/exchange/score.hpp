// Final states of another program, judged by the norms and gates of a case.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cases/harness/exchange/foreign_file.hpp"
#include "cases/harness/judge/gates.hpp"

namespace plumbline {

// A gate of the case that says nothing about another program's final states, and why.
struct NotJudged {
  std::string id, reason;
};

struct Score {
  StudyResult study;  // a level for each file, from coarse to fine; its scheme is "foreign:<program>"
  std::string program, version;
  std::optional<std::string> declared;  // the case's study whose problem this is
  std::vector<JudgedGate> gates;
  std::vector<NotJudged> not_judged;
  std::vector<std::string> files;  // as given, in the order of the levels
};

// One file, or a refinement series of one program. `typed`: --set of the export, as far as it is not the mesh. Throws
// UsageError if the call does not fit the files (another case, problem, end time, program; a mesh twice; a case that is
// judged on the way), FileError for what a file holds or where reading it takes longer than `patience`, s.
Score score(const Case& entry, const std::vector<std::string>& files, const std::vector<std::string>& typed,
            double patience = default_patience);

// The gates that read one level alone; of a single file, all.
std::vector<JudgedGate> gates_of_level(const Score& score, const StudyLevel& at);

}  // namespace plumbline
