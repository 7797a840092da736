// Parts of a scheme that `verify` judges by gates of their own: --shape and the like.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "cases/harness/commands/command.hpp"
#include "cases/harness/parts/parts.hpp"

namespace plumbline {

// Names by kind of part.
using ChosenParts = std::map<std::string, std::vector<std::string>>;

// An option for each kind; `chosen` outlives the parsing.
void add_part_options(const Arguments& command, ChosenParts& chosen);
bool none(const ChosenParts& chosen);

// Throws UsageError where cases are named beside parts, which are judged without any.
void refuse_cases(const ChosenParts& chosen, const std::vector<std::string>& patterns);

// The gates of each part are added to `verification`; returns what is known of each, as JSON documents have it (`parts` of the
// schema). Throws UsageError for an unknown name.
Json judge_parts(const ChosenParts& chosen, PartJudging how,
                 const std::function<JudgingProgress(const std::string& name)>& progress, Verification& verification);

// The shape that --set shape=X names for the transfers among the parts, else the default one. Throws UsageError for any other key:
// parts have none.
std::string shape_for(const ChosenParts& chosen, const std::vector<std::string>& assignments);

// "shape cubic: red by unity/line"
std::string part_line(const Json& part);

}  // namespace plumbline
