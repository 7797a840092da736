// Recording what gates measure: cases/regressions.json from the results of `plumbline verify --json`.
#pragma once

#include <string>
#include <vector>

#include "cases/harness/compare/tolerances.hpp"
#include "cases/harness/judge/regressions.hpp"

namespace plumbline {

// The recorded values with those of a verification's document: gates without one get theirs, gates whose value left its range
// get a new one with this date and reason, all others keep theirs, so that small changes do not add up unseen. Gates of a study
// that was judged and that are no more lose theirs. Throws UsageError where --set was given or a value moved and `why` is
// empty, and FileError naming `file` for what is no document of verify.
std::vector<RecordedValue> recorded_from(const std::vector<RecordedValue>& before, const Json& verification,
                                         const std::string& file, const std::string& why);

// The document of `verify` in a file; FileError.
Json read_verification(const std::string& file);

// Gates of the quick tier without a recorded value, and recorded values of no gate; each message says what to call.
std::vector<Discrepancy> unrecorded(const std::vector<const Case*>& entries, const std::vector<RecordedValue>& values);

std::vector<RecordedValue> read_regressions(const std::string& file);                       // FileError
void write_regressions(const std::string& file, const std::vector<RecordedValue>& values);  // whole or not at all

}  // namespace plumbline
