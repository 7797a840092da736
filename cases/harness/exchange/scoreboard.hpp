// Many programs' final states of many starts, scored beside the default scheme from the same starts.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cases/harness/exchange/score.hpp"
#include "cases/harness/exchange/score_folder.hpp"
#include "cases/harness/exchange/start_file.hpp"
#include "cases/harness/results/documents.hpp"
#include "cases/harness/verify/verification.hpp"

namespace plumbline {

inline constexpr int scoreboard_format = 1;

// What came of a program on one start.
enum class Outcome {
  scored,
  missing,     // no result, and no adapter was run
  damaged,     // a result that is not what it should be
  mismatched,  // a result of another case, problem, mesh or time
  failed,      // the adapter ended without a result
  late         // it was ended because its time was up
};
std::string_view name(Outcome outcome);

struct Entry {
  Outcome outcome = Outcome::missing;
  std::string reason;             // empty where scored
  std::optional<double> seconds;  // wall time where the result states it, else where an adapter was timed
  bool timed_adapter = false;     // the latter
};

struct ProgramScore {
  std::string program;         // the name of its folder
  std::vector<Entry> entries;  // one a start of the problem
  std::optional<Score> score;  // of all results that can be scored; its levels are those entries
  std::string reason;          // why results that can be scored are no series; else empty

  // The level of an entry: nothing where it is not scored.
  const StudyLevel* level(int cells) const;
};

// The starts of a case that differ in their mesh alone.
struct ProblemScores {
  const Case* entry = nullptr;
  std::vector<Start> starts;  // from coarse to fine
  std::string measure;        // the one that stands for the case
  StudyResult own;            // the default scheme from the same starts, a level each
  std::vector<ProgramScore> programs;
};

struct Scoreboard {
  std::vector<ProblemScores> problems;
  struct Refused {
    std::string start, reason;
  };
  std::vector<Refused> refused;     // starts that nothing can be scored by
  std::vector<std::string> strays;  // results, "PROGRAM/FILE", that belong to no start
};

// Scores what the folder holds; patience: s that reading a result may take. Runs of the default scheme come from the store or go there, `threads` at a time. Whatever is
// wrong with a start or a result is an entry; throws FileError for a folder that cannot be read or written, Interrupted.
Scoreboard make_scoreboard(const ScoreFolder& folder, double patience, int threads, const Progress& progress,
                           RunStore& store);

// Error of a measure at a level over another's; nothing where either has none, or the other's is 0.
std::optional<double> error_ratio(const std::string& measure, const StudyLevel* level, const StudyLevel* other);

// All verdicts, and an INVALID for each start, result or series that could not be scored.
std::vector<Verdict> verdicts(const Scoreboard& board);

// The definition `scoreboard` of the schema.
Json scoreboard_document(const Scoreboard& board, const Provenance& provenance);

}  // namespace plumbline
