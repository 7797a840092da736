// Runs of a results folder: those that the same code has made already, and new ones as they finish.
#pragma once

#include <optional>
#include <set>
#include <string>

#include "cases/harness/results/results.hpp"

namespace plumbline {

// `provenance` with the fingerprint of what the case depends on; as it is where the build has told none.
Provenance provenance_of(const Case& entry, Provenance provenance);

class RunStore {
 public:
  // `reuse`: whether runs are taken from the folder. The folder must outlive this.
  RunStore(const ResultsFolder& folder, Provenance provenance, bool reuse);

  const ResultsFolder& folder() const { return folder_; }
  Provenance provenance(const Case& entry) const { return provenance_of(entry, provenance_); }
  bool reuses() const { return reuse_; }
  int reused() const { return reused_; }
  int made() const { return made_; }

  // The stored run of this file with all its numbers, if the same code made it and with frames that serve. A file that is
  // damaged or of a newer version is none, and is said on standard error, once. Not for several threads at once.
  std::optional<RunResult> take(const Case& entry, const std::string& file, const FrameRequest& frames = {});
  // Whether take() would find one, by its first lines alone.
  bool holds(const Case& entry, const std::string& file, const FrameRequest& frames = {});
  // What it took to make it, s; negative if no program of whatever version has left word.
  double known_seconds(const std::string& file);

  // Stores a run that has just been made, unless it was stored with frames and now comes without. Not for several threads
  // at once.
  void keep(const Case& entry, const RunResult& run, const Making& making);

 private:
  std::optional<Stored> stored(const std::string& file);
  template <class Read>
  auto guarded(const std::string& file, Read read) -> decltype(read());

  const ResultsFolder& folder_;
  Provenance provenance_;
  bool reuse_;
  int reused_ = 0, made_ = 0;
  std::set<std::string> with_frames_, told_;
};

// Runs it and gives it the name of its file; nothing is stored.
RunResult make_run(const Case& entry, const std::string& scheme, const Settings& settings, const FrameRequest& frames,
                   Making& making, int threads = 1, const RunStates& states = {});

}  // namespace plumbline
