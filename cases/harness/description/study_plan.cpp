#include "cases/harness/description/study_plan.hpp"

#include <array>
#include <cstddef>
#include <utility>

#include "cases/harness/files/errors.hpp"

namespace plumbline {
namespace {

constexpr std::array vary_names{"cells", "dt", "ppc", "offset"};

}  // namespace

std::string name(Vary vary) { return vary_names[static_cast<std::size_t>(vary)]; }

Vary vary_from(const std::string& text) {
  for (std::size_t k = 0; k < vary_names.size(); ++k) {
    if (text == vary_names[k]) return static_cast<Vary>(k);
  }
  throw unknown_name("--vary", text, {vary_names.begin(), vary_names.end()});
}

StudyPlan study(std::string id, std::string title, std::string why, std::vector<double> values) {
  return {.id = std::move(id), .title = std::move(title), .why = std::move(why), .values = std::move(values)};
}

StudyPlan StudyPlan::of_york() && {
  scheme = "york1997";
  return std::move(*this);
}

StudyPlan StudyPlan::with(std::vector<Override> choices) && {
  overrides = std::move(choices);
  return std::move(*this);
}

StudyPlan StudyPlan::over(Vary varied) && {
  vary = varied;
  return std::move(*this);
}

StudyPlan StudyPlan::in_full(std::vector<double> levels) && {
  full_values = std::move(levels);
  return std::move(*this);
}

StudyPlan StudyPlan::in(Tier lowest) && {
  tier = lowest;
  return std::move(*this);
}

StudyPlan StudyPlan::pictured(int count, std::optional<double> level) && {
  frames = count;
  frames_at = level;
  return std::move(*this);
}

}  // namespace plumbline
