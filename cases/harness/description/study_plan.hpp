// What verify runs of a case: refinement studies.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cases/harness/description/settings.hpp"

namespace plumbline {

enum class Tier { quick, full };

// What is refined.
enum class Vary { cells, dt, ppc, offset };
std::string name(Vary vary);
Vary vary_from(const std::string& name);  // UsageError

// A refinement study that verify runs: a scheme with overrides, varied over values.
struct StudyPlan {
  std::string id, title;
  std::string why;  // the order that theory allows, and why
  std::string scheme = "default";
  std::vector<Override> overrides = {};
  Vary vary = Vary::cells;
  std::vector<double> values = {};       // cells; factors of the step for dt; points per cell; offsets
  Tier tier = Tier::quick;               // the lowest tier that runs it
  std::vector<double> full_values = {};  // replaces `values` in the full tier, if not empty
  bool offsets_in_full = false;          // the full tier repeats each level at four sub-cell offsets
  int frames = 0;                        // 2 ... 100: so many snapshots of its last level for the report's pictures
  std::optional<double> frames_at = {};  // of the level with this value instead

  // The same study of york1997; with overrides; that varies something else than the cells; with other values in the full
  // tier; in this tier and above; with pictures.
  StudyPlan of_york() &&;
  StudyPlan with(std::vector<Override> choices) &&;
  StudyPlan over(Vary varied) &&;
  StudyPlan in_full(std::vector<double> levels) &&;
  StudyPlan in(Tier lowest) &&;
  StudyPlan pictured(int count, std::optional<double> level = {}) &&;
};
// A study in cells of the default scheme in the quick tier.
StudyPlan study(std::string id, std::string title, std::string why, std::vector<double> values);

}  // namespace plumbline
