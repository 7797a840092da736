// A run in its file, bit for bit, for the program that made it to take up again.
#pragma once

#include <optional>
#include <string>

#include "cases/harness/files/hdf5_file.hpp"
#include "cases/harness/run/experiment.hpp"

namespace plumbline {

// How a run was made, beside what came of it.
struct Making {
  FrameRequest frames = {};
  double elapsed_s = 0;  // set-up, stepping and measures
};

// True if frames that were kept for one request serve the other, too.
bool serves(const FrameRequest& kept, const FrameRequest& wanted);

// Writes /restore, to be read together with /ledger and /profile. Frames are not restored: no number depends on them.
void write_restore(Hdf5Writer& file, const RunResult& run, const std::string& fingerprint, const Making& making);

// What /restore says before anything else is read.
struct Stored {
  std::string fingerprint;
  Making making;
};
// Nothing if the file has no /restore of this version; FileError if it cannot be read.
std::optional<Stored> read_stored(const Hdf5Reader& file);

// The run as it was. FileError if a part is missing or has changed.
RunResult read_restore(const Hdf5Reader& file);

// The settings of a case that Settings::canonical() has written. Throws UsageError for what the case does not have.
Settings restored_settings(const std::string& case_name, const std::string& canonical);

}  // namespace plumbline
