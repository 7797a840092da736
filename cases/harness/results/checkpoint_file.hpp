// A run under way in a file: what was chosen, by which code, and its state.
#pragma once

#include <cstdint>
#include <string>

#include "cases/harness/run/experiment.hpp"

namespace plumbline {

struct CheckpointFile {
  std::string case_name, scheme;
  std::string settings;     // Settings::canonical()
  std::string fingerprint;  // of the code that makes the run; cases/harness/results/fingerprint.hpp
  std::string build;        // that code in words: version and commit
  FrameRequest frames = {};
  std::int64_t every = 0;  // steps from one checkpoint to the next; 0: by the clock
  RunState state = {};
};

// Puts the file in its place whole and on disk; until then the one that was there stays. Throws FileError.
void write_checkpoint(const std::string& path, const CheckpointFile& checkpoint);

// Throws FileError for a file that is missing, damaged, of a newer version or no checkpoint.
CheckpointFile read_checkpoint(const std::string& path);

// The choices of the run. Throws FileError where this program does not have the case or does not know a key or value.
Settings settings_of(const CheckpointFile& checkpoint, const std::string& path);

// Throws FileError, which names both, unless this code is the one that the run was begun with.
void require_same_code(const CheckpointFile& checkpoint, const std::string& path);

// This program in words, as in CheckpointFile::build.
std::string build_in_words();

}  // namespace plumbline
