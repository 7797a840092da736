#include "cases/harness/commands/verify_parts.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "cases/harness/files/errors.hpp"

namespace plumbline {
namespace {

Json summary(const std::string& kind, const std::string& name, const JudgedPart& judged) {
  std::vector<Verdict> verdicts;
  Json red = Json::array();
  for (const JudgedGate& gate : judged.gates) {
    verdicts.push_back(gate.judgement.verdict);
    if (!gate.explanation.empty()) red.push_back(gate.gate.id);
  }
  return {{"kind", kind},
          {"name", name},
          {"verdict", plumbline::name(overall(verdicts))},
          {"gates", judged.gates.size()},
          {"red", red}};
}

}  // namespace

void add_part_options(const Arguments& command, ChosenParts& chosen) {
  for (const PartKind& kind : part_kinds()) {
    command
        .option("--" + kind.name, chosen[kind.name], "a " + kind.name + " to be judged by gates of its own; repeatable")
        .repeatable();
  }
}

bool none(const ChosenParts& chosen) {
  return std::all_of(chosen.begin(), chosen.end(), [](const auto& kind) { return kind.second.empty(); });
}

void refuse_cases(const ChosenParts& chosen, const std::vector<std::string>& patterns) {
  if (patterns.empty()) return;
  for (const auto& [kind, names] : chosen) {
    if (names.empty()) continue;
    throw UsageError("--" + kind, names.front(), "no cases beside it", {},
                     fmt::format("--{0} {1} judges the {0} by gates of its own, without cases ({2} is named); `--set "
                                 "{0}={1}` verifies cases with it",
                                 kind, names.front(), patterns.front()));
  }
}

std::string shape_for(const ChosenParts& chosen, const std::vector<std::string>& assignments) {
  std::string shape = Scene().shape;
  const auto transfers = chosen.find("transfer");
  for (const std::string& assignment : assignments) {
    const std::string key = assignment.substr(0, assignment.find('='));
    if (key != "shape" || transfers == chosen.end() || transfers->second.empty()) {
      throw UsageError(
          key, assignment, "shape, of transfers", {},
          fmt::format("--set {}: a part is judged without keys, but for the shape with which a transfer is",
                      assignment));
    }
    shape = assignment.substr(key.size() + 1);
  }
  return shape;
}

Json judge_parts(const ChosenParts& chosen, PartJudging how,
                 const std::function<JudgingProgress(const std::string& name)>& progress, Verification& verification) {
  Json all = Json::array();
  for (const PartKind& kind : part_kinds()) {
    const auto names = chosen.find(kind.name);
    if (names == chosen.end()) continue;
    for (const std::string& name : names->second) {
      how.progress = progress(name);
      JudgedPart judged = judge_part(kind, name, how);
      end_progress();
      all.push_back(summary(kind.name, name, judged));
      verification.declared += judged.declared;
      std::move(judged.gates.begin(), judged.gates.end(), std::back_inserter(verification.gates));
      std::move(judged.not_applicable.begin(), judged.not_applicable.end(),
                std::back_inserter(verification.not_applicable));
    }
  }
  return all;
}

std::string part_line(const Json& part) {
  std::string red;
  for (const Json& id : part["red"]) red += (red.empty() ? "" : ", ") + id.get<std::string>();
  return fmt::format("{} {}: {}", part["kind"].get<std::string>(), part["name"].get<std::string>(),
                     red.empty() ? fmt::format("green, {} gates", part["gates"].get<int>()) : "red by " + red);
}

}  // namespace plumbline
