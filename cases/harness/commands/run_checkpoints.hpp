// What run offers against being killed: --checkpoint, --every and --resume.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include "cases/harness/commands/command.hpp"
#include "cases/harness/results/checkpoint_file.hpp"

namespace plumbline {

struct CheckpointOptions {
  std::optional<std::string> file, resume;
  std::optional<std::int64_t> every;  // steps
};
void add_checkpoint_options(const Arguments& command, CheckpointOptions& options);

// What to run.
struct RunChoice {
  const Case* entry;
  std::string scheme;
  Settings settings;
  FrameRequest frames;
};

// The checkpoints of one run: the one it begins with, if any, and those that it leaves.
class RunCheckpoints {
 public:
  // Reads the checkpoint to resume. Throws UsageError for options that cannot be, FileError.
  explicit RunCheckpoints(const CheckpointOptions& options);

  // The run in the checkpoint; nothing if a new one is wanted.
  std::optional<RunChoice> resumed() const;
  // Throws UsageError, which names the key, if something else than the checkpoint's was chosen.
  void refuse_other_choices(const CommonOptions& options, const RunChoice& resumed,
                            const std::optional<std::string>& case_name, std::optional<int> cells,
                            std::optional<int> frames) const;

  // To be handed to the run; this must outlive it. The first state is kept at once, so that a file that cannot be written is
  // found before the work.
  RunStates states(const RunChoice& choice);
  // Where the run goes on; null: it is a new one.
  const RunState* from() const { return begun_ ? &begun_->state : nullptr; }
  const std::string& resumed_file() const { return *options_.resume; }

 private:
  bool due(long step) const;

  CheckpointOptions options_;
  std::optional<CheckpointFile> begun_;
  std::string file_;        // where they go; empty: nowhere
  std::int64_t every_ = 0;  // steps; 0: by the clock
  long written_step_ = -1;
  std::chrono::steady_clock::time_point written_at_ = {};
};

}  // namespace plumbline
