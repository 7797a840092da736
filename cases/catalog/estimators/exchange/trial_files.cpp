#include "cases/catalog/estimators/exchange/trial_files.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <system_error>

#include "cases/catalog/estimators/exchange/given_stress.hpp"

namespace plumbline {

TrialFolder::TrialFolder() {
  static std::atomic<int> count = 0;
  std::error_code none;
  const auto folder = std::filesystem::temp_directory_path(none);
  if (none) throw FileError("TMPDIR", "there is no folder for temporary files: " + none.message());
  path_ = folder / fmt::format("plumbline-estimators-{}-{}", ::getpid(), count++);
  std::filesystem::create_directory(path_, none);
  if (none) throw FileError(path_.string(), path_.string() + ": cannot be made: " + none.message());
}

TrialFolder::~TrialFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

void add_table(const std::string& name, const ForeignReader& file, const std::string& dataset,
               const std::vector<std::size_t>& shape, const std::vector<double>& values, KnownAnswers& all) {
  const bool there = file.has(dataset);
  all.push_back(yes(name + ".there", there));
  if (!there) return;
  const NumberTable table = file.numbers(dataset);
  all.push_back(yes(name + ".shape", table.shape == shape));
  all.push_back({name, farthest(table.values, values), 0});
}

}  // namespace plumbline
