#include "cases/harness/commands/run_checkpoints.hpp"

#include <filesystem>

#include "cases/harness/files/errors.hpp"
#include "cases/harness/files/text_file.hpp"
#include "cases/harness/results/fingerprint.hpp"

namespace plumbline {
namespace {

constexpr double seconds_between = 30;  // where --every does not say

void require_name(const char* option, const std::optional<std::string>& file) {
  if (file && file->empty())
    throw UsageError(option, "", "a file's name", {}, std::string(option) + " wants a file's name");
}

[[noreturn]] void refuse(const std::string& file, const std::string& key, const std::string& given,
                         const std::string& kept) {
  throw UsageError(
      key, given, kept, {},
      fmt::format("{} = {}: the run in {} has {}; a resumed run takes its case, scheme and settings from the "
                  "file, and they cannot be changed",
                  key, given, file, kept));
}

// What another process has left half-written beside the file when it was killed.
void remove_abandoned_beside(const std::string& file) {
  const std::filesystem::path folder = std::filesystem::path(file).parent_path();
  remove_abandoned(folder.empty() ? "." : folder.string());
}

}  // namespace

void add_checkpoint_options(const Arguments& command, CheckpointOptions& options) {
  command.option("--checkpoint", options.file,
                 "keep the state of the run in this file, so that --resume can go on from it; whole or not at all");
  command.option(
      "--every", options.every,
      fmt::format("steps from one checkpoint to the next; without it one is kept about every {} s", seconds_between));
  command.option("--resume", options.resume,
                 "go on from a checkpoint, to the same bits: case, scheme and settings come from the file; its "
                 "checkpoints go on as before unless --checkpoint or --every say otherwise");
}

RunCheckpoints::RunCheckpoints(const CheckpointOptions& options) : options_(options) {
  require_name("--checkpoint", options.file);
  require_name("--resume", options.resume);
  if (options.every && *options.every < 1) {
    throw UsageError("--every", std::to_string(*options.every), "[1, inf)", {},
                     fmt::format("--every {}: a number of steps in [1, inf) is wanted", *options.every));
  }
  if (options.every && !options.file && !options.resume) {
    throw UsageError(
        "--every", std::to_string(*options.every), "with --checkpoint or --resume", {"--checkpoint"},
        fmt::format("--every {} needs --checkpoint FILE: nothing says where the states go", *options.every));
  }
  if (options.resume) {
    begun_ = read_checkpoint(*options.resume);
    require_same_code(*begun_, *options.resume);
    every_ = begun_->every;
  }
  if (options.every) every_ = *options.every;
  file_ = options.file.value_or(options.resume.value_or(""));
  if (file_.empty()) return;
  remove_abandoned_beside(file_);
  if (!options.file) written_step_ = begun_->state.step;
}

std::optional<RunChoice> RunCheckpoints::resumed() const {
  if (!begun_) return std::nullopt;
  return RunChoice{&find_case(begun_->case_name), begun_->scheme, settings_of(*begun_, *options_.resume),
                   begun_->frames};
}

void RunCheckpoints::refuse_other_choices(const CommonOptions& options, const RunChoice& resumed,
                                          const std::optional<std::string>& case_name, std::optional<int> cells,
                                          std::optional<int> frames) const {
  const std::string &file = *options_.resume, own = resumed.entry->name;
  const auto compare = [&](const std::string& key, const std::string& given, const std::string& kept) {
    if (given != kept) refuse(file, key, given, kept);
  };
  if (case_name) compare("case", *case_name, own);
  for (const std::string& scheme : options.schemes) compare("--scheme", scheme, resumed.scheme);
  for (const std::string& integrator : options.integrators) {
    compare("--integrator", integrator, resumed.settings.text("integrator"));
    compare("--scheme", "default", resumed.scheme);
  }
  if (cells) compare("--cells", std::to_string(*cells), to_text(resumed.settings["cells"]));
  if (frames) compare("--frames", std::to_string(*frames), std::to_string(resumed.frames.count));
  for (const std::string& assignment : options.settings) {
    Settings with = resumed.settings;
    with.set_text(assignment, own);
    const std::string key = assignment.substr(0, assignment.find('='));
    if (!(with == resumed.settings)) refuse(file, key, to_text(with[key]), to_text(resumed.settings[key]));
  }
}

bool RunCheckpoints::due(long step) const {
  if (step == written_step_) return false;
  if (written_step_ < 0) return true;
  if (every_ > 0) return step % every_ == 0;
  return std::chrono::steady_clock::now() - written_at_ >= std::chrono::duration<double>(seconds_between);
}

RunStates RunCheckpoints::states(const RunChoice& choice) {
  RunStates states;
  states.from = from();
  if (file_.empty()) return states;
  written_at_ = std::chrono::steady_clock::now();
  states.wanted = [this](const Simulation& now) { return due(now.steps()); };
  states.keep = [this, choice](const RunState& state) {
    write_checkpoint(file_, {choice.entry->name, choice.scheme, choice.settings.canonical(), fingerprint(*choice.entry),
                             build_in_words(), choice.frames, every_, state});
    written_step_ = state.step;
    written_at_ = std::chrono::steady_clock::now();
  };
  return states;
}

}  // namespace plumbline
