#include "cases/harness/exchange/score_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <stdexcept>

#include "cases/harness/files/errors.hpp"
#include "cases/harness/files/input_file.hpp"
#include "cases/harness/files/json_text.hpp"
#include "cases/harness/files/text_file.hpp"

namespace plumbline {
namespace {

namespace fs = std::filesystem;

constexpr std::array<const char*, 3> ways{"written", "failed", "late"};  // by AdapterEnd::How

enum class Listed { files, folders };

// Names in a folder, in order; none if it is not there. Hidden ones are left out.
std::vector<std::string> names_in(const std::string& folder, Listed wanted) {
  std::vector<std::string> names;
  try {
    if (!fs::exists(folder)) return names;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
      const std::string name = entry.path().filename().string();
      const bool fits = wanted == Listed::folders ? entry.is_directory() : entry.path().extension() == ".h5";
      if (fits && name.front() != '.') names.push_back(name);
    }
  } catch (const fs::filesystem_error& error) {
    throw FileError(folder, fmt::format("{}: cannot be read: {}", folder, error.code().message()));
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string with_ending(const std::string& file, const char* ending) {
  return fs::path(file).replace_extension(ending).string();
}

}  // namespace

ScoreFolder::ScoreFolder(std::string path) : path_(std::move(path)) {
  std::error_code error;
  if (!fs::is_directory(path_, error)) {
    throw UsageError("DIR", path_, "a folder", {}, fmt::format("{}: not a folder", path_));
  }
  starts_ = names_in(path_ + "/cases", Listed::files);
  if (starts_.empty()) {
    throw UsageError("DIR", path_, "a folder with cases/NAME.h5", {},
                     fmt::format("{0}: no starts in {0}/cases; `plumbline export CASE --output {0}/cases/NAME.h5` "
                                 "writes one",
                                 path_));
  }
}

std::vector<std::string> ScoreFolder::programs() const { return names_in(path_ + "/programs", Listed::folders); }

std::vector<std::string> ScoreFolder::strays(const std::string& program) const {
  std::vector<std::string> names = names_in(path_ + "/programs/" + program, Listed::files);
  std::erase_if(names,
                [&](const std::string& name) { return std::binary_search(starts_.begin(), starts_.end(), name); });
  return names;
}

std::string ScoreFolder::start(const std::string& name) const { return path_ + "/cases/" + name; }

std::string ScoreFolder::result(const std::string& program, const std::string& start) const {
  return path_ + "/programs/" + program + "/" + start;
}

std::string ScoreFolder::log(const std::string& program, const std::string& start) const {
  return with_ending(result(program, start), ".log");
}

std::string ScoreFolder::end(const std::string& program, const std::string& start) const {
  return with_ending(result(program, start), ".json");
}

void ScoreFolder::add_program(const std::string& program) const {
  const std::string folder = path_ + "/programs/" + program;
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw FileError(folder, fmt::format("{}: cannot be made: {}", folder, error.message()));
}

void ScoreFolder::clear(const std::string& program, const std::string& start) const {
  for (const std::string& file : {result(program, start), log(program, start), end(program, start)}) {
    std::error_code error;
    fs::remove(file, error);
    if (error) throw FileError(file, fmt::format("{}: cannot be removed: {}", file, error.message()));
  }
}

void ScoreFolder::write_end(const std::string& program, const std::string& start, const AdapterEnd& ended) const {
  const Json document{
      {"end", ways[static_cast<std::size_t>(ended.how)]}, {"reason", ended.reason}, {"seconds", ended.seconds}};
  write_text_file(end(program, start), json_text(document, 1) + "\n");
}

std::optional<AdapterEnd> ScoreFolder::read_end(const std::string& program, const std::string& start) const {
  const std::string file = end(program, start);
  std::error_code none;
  if (!fs::exists(file, none)) return std::nullopt;
  const std::string content = read_text_file(file);
  try {
    const Json document = parse_json(content);
    const auto* const way = std::find(ways.begin(), ways.end(), document.at("end").get<std::string>());
    if (way == ways.end()) throw std::out_of_range(R"("end" is none of written, failed, late)");
    return AdapterEnd{static_cast<AdapterEnd::How>(way - ways.begin()), document.at("reason"), document.at("seconds")};
  } catch (const Json::exception& error) {
    throw FileError(file, fmt::format("{}: not what an adapter's run leaves: {}", file, fault_of(error)));
  } catch (const std::exception& error) {
    throw FileError(file, fmt::format("{}: not what an adapter's run leaves: {}", file, error.what()));
  }
}

}  // namespace plumbline
