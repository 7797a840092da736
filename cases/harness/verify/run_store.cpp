#include "cases/harness/verify/run_store.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>

#include "cases/harness/files/input_file.hpp"
#include "cases/harness/files/json_text.hpp"
#include "cases/harness/results/fingerprint.hpp"
#include "cases/harness/verify/verification.hpp"

namespace plumbline {

Provenance provenance_of(const Case& entry, Provenance provenance) {
  if (const std::string found = code_fingerprint(); !found.empty()) provenance.fingerprint = fingerprint(entry);
  return provenance;
}

RunStore::RunStore(const ResultsFolder& folder, Provenance provenance, bool reuse)
    : folder_(folder),
      provenance_(std::move(provenance)),
      reuse_(reuse) {}

// Reads of a file; nothing if it is not there, or not whole.
template <class Read>
auto RunStore::guarded(const std::string& file, Read read) -> decltype(read()) {
  if (!is_there(folder_.path() + "/" + file)) return std::nullopt;
  try {
    return read();
  } catch (const std::exception& error) {
    // A notice that cannot be written stops no run.
    if (told_.insert(file).second)
      std::fputs(fmt::format("plumbline: not used again: {}\n", valid_utf8(error.what())).c_str(), stderr);
    return std::nullopt;
  }
}

std::optional<Stored> RunStore::stored(const std::string& file) {
  return guarded(file, [&]() -> std::optional<Stored> { return folder_.read_stored(file); });
}

bool RunStore::holds(const Case& entry, const std::string& file, const FrameRequest& frames) {
  if (!reuse_) return false;
  const std::string wanted = provenance(entry).fingerprint;
  const std::optional<Stored> there = stored(file);
  return there && !wanted.empty() && there->fingerprint == wanted && serves(there->making.frames, frames);
}

std::optional<RunResult> RunStore::take(const Case& entry, const std::string& file, const FrameRequest& frames) {
  if (!holds(entry, file, frames)) return std::nullopt;
  const std::string wanted = provenance(entry).fingerprint;
  auto run = guarded(file, [&] { return folder_.read_run(file, wanted); });
  if (run) ++reused_;
  return run;
}

double RunStore::known_seconds(const std::string& file) {
  const std::optional<Stored> there = stored(file);
  return there ? there->making.elapsed_s : -1;
}

void RunStore::keep(const Case& entry, const RunResult& run, const Making& making) {
  ++made_;
  if (making.frames.count == 0 && with_frames_.count(run.file) > 0) return;
  if (making.frames.count > 0) with_frames_.insert(run.file);
  folder_.write_run(run, {}, provenance(entry), making);
}

RunResult make_run(const Case& entry, const std::string& scheme, const Settings& settings, const FrameRequest& frames,
                   Making& making, int threads, const RunStates& states) {
  const auto start = std::chrono::steady_clock::now();
  RunResult run = run_experiment(entry, scheme, settings, threads, frames, states);
  run.scheme = result_scheme(entry, scheme, settings);
  run.file = ResultsFolder::run_name(run);
  making = {frames, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count()};
  return run;
}

}  // namespace plumbline
