#include "cases/harness/results/checkpoint_file.hpp"

#include <fmt/format.h>

#include <fstream>

#include "cases/harness/files/errors.hpp"
#include "cases/harness/files/hdf5_file.hpp"
#include "cases/harness/files/json_text.hpp"
#include "cases/harness/results/documents.hpp"
#include "cases/harness/results/fingerprint.hpp"
#include "cases/harness/results/provenance.hpp"
#include "cases/harness/results/restore.hpp"

namespace plumbline {
namespace {

constexpr int checkpoint_format = 1;
constexpr const char* about_path = "/checkpoint";
constexpr const char* numbers_group = "/state/";

Json about(const CheckpointFile& checkpoint) {
  Json names = Json::array();
  for (const auto& [name, values] : checkpoint.state.numbers) names.push_back(name);
  return {{"checkpoint", checkpoint_format},
          {"case", checkpoint.case_name},
          {"scheme", checkpoint.scheme},
          {"settings", checkpoint.settings},
          {"fingerprint", checkpoint.fingerprint},
          {"build", checkpoint.build},
          {"frames", {checkpoint.frames.count, checkpoint.frames.most_points}},
          {"every", checkpoint.every},
          {"step", checkpoint.state.step},
          {"time", checkpoint.state.time},
          {"wall_s", checkpoint.state.wall_s},
          {"numbers", names}};
}

// HDF5 is shown no file that others may have damaged.
void require_seal(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string start(10, '\0');
  if (!file.read(start.data(), 10)) throw FileError(path, path + ": cannot be read, or is empty");
  if (start != "plumbline:") throw FileError(path, path + ": holds no checkpoint of a run");
}

CheckpointFile from_parts(const Hdf5Reader& file, const Json& parts) {
  CheckpointFile checkpoint;
  checkpoint.case_name = parts.at("case");
  checkpoint.scheme = parts.at("scheme");
  checkpoint.settings = parts.at("settings");
  checkpoint.fingerprint = parts.at("fingerprint");
  checkpoint.build = parts.at("build");
  checkpoint.frames = {parts.at("frames").at(0), parts.at("frames").at(1)};
  checkpoint.every = parts.at("every");
  checkpoint.state.step = parts.at("step");
  checkpoint.state.time = parts.at("time");
  checkpoint.state.wall_s = parts.at("wall_s");
  for (const std::string name : parts.at("numbers")) {
    checkpoint.state.numbers[name] = file.numbers(numbers_group + name);
  }
  return checkpoint;
}

}  // namespace

void write_checkpoint(const std::string& path, const CheckpointFile& checkpoint) {
  Hdf5Writer file(path);
  file.attribute("/", "kind", "checkpoint");
  file.text(about_path, json_text(about(checkpoint)));
  for (const auto& [name, values] : checkpoint.state.numbers) file.numbers(numbers_group + name, values);
  file.commit(Hdf5Writer::Flush::to_disk);
}

CheckpointFile read_checkpoint(const std::string& path) {
  require_seal(path);
  const Hdf5Reader file(path);
  if (!file.has(about_path)) throw FileError(path, path + ": holds no checkpoint of a run");
  try {
    const Json parts = parse_json(file.text(about_path));
    const int format = parts.at("checkpoint");
    if (format > checkpoint_format)
      throw FileError(path, fmt::format("{}: a checkpoint of format {}, made by a newer version", path, format));
    return from_parts(file, parts);
  } catch (const Json::exception& error) {
    throw FileError(path, fmt::format("{}: {} is damaged: {}", path, about_path, fault_of(error)));
  }
}

Settings settings_of(const CheckpointFile& checkpoint, const std::string& path) {
  try {
    Settings settings = restored_settings(checkpoint.case_name, checkpoint.settings);
    if (settings.canonical() == checkpoint.settings) return settings;
    throw FileError(path, fmt::format("{}: its settings are not those of {}", path, checkpoint.case_name));
  } catch (const UsageError& error) {
    throw FileError(path, fmt::format("{}: of a run that this program does not know: {}", path, error.what()));
  }
}

void require_same_code(const CheckpointFile& checkpoint, const std::string& path) {
  std::string own;
  try {
    own = fingerprint(find_case(checkpoint.case_name));
  } catch (const UsageError& error) {
    throw FileError(path, fmt::format("{}: of a run that this program does not know: {}", path, error.what()));
  }
  if (own == checkpoint.fingerprint) return;
  throw FileError(path, fmt::format("{}: begun with other code, {} ({}); this program is {} ({}). A run goes on to the "
                                    "same numbers only under the code that began it, with the plug-ins that it had",
                                    path, checkpoint.build, checkpoint.fingerprint, build_in_words(), own));
}

std::string build_in_words() {
  const Provenance build = build_provenance();
  return fmt::format("plumbline {}, {}{}", build.version, build.git.empty() ? "no git" : build.git,
                     build.dirty ? ", modified" : "");
}

}  // namespace plumbline
