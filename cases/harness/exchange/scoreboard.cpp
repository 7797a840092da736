#include "cases/harness/exchange/scoreboard.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "cases/harness/exchange/final_state.hpp"
#include "cases/harness/exchange/result_file.hpp"
#include "cases/harness/files/errors.hpp"
#include "cases/harness/files/input_file.hpp"

namespace plumbline {
namespace {

// What an error says beyond the path that it begins with.
std::string reason_of(const std::exception& error, const std::string& path) {
  const std::string text = error.what();
  return text.rfind(path + ": ", 0) == 0 ? text.substr(path.size() + 2) : text;
}

ProblemScores& problem_of(std::vector<ProblemScores>& problems, const Start& start) {
  const auto found = std::find_if(problems.begin(), problems.end(), [&](const ProblemScores& p) {
    return p.entry == start.entry && p.starts.front().typed == start.typed;
  });
  if (found != problems.end()) return *found;
  problems.push_back({.entry = start.entry, .starts = {}, .measure = {}, .own = {}, .programs = {}});
  return problems.back();
}

void take_start(const ScoreFolder& folder, const std::string& name, Scoreboard& board) {
  const std::string path = folder.start(name);
  try {
    const Start start = read_start(path);
    std::vector<Start>& starts = problem_of(board.problems, start).starts;
    const auto same = std::find_if(starts.begin(), starts.end(),
                                   [&](const Start& s) { return s.cells == start.cells; });
    if (same == starts.end()) {
      starts.push_back(start);
    } else {
      board.refused.push_back({name, "the same start as " + same->name});
    }
  } catch (const std::exception& error) {
    board.refused.push_back({name, reason_of(error, path)});
  }
}

void take_starts(const ScoreFolder& folder, Scoreboard& board) {
  for (const std::string& name : folder.starts()) take_start(folder, name, board);
  for (ProblemScores& problem : board.problems) {
    std::sort(problem.starts.begin(), problem.starts.end(),
              [](const Start& a, const Start& b) { return a.cells < b.cells; });
  }
  std::stable_sort(board.problems.begin(), board.problems.end(),
                   [](const ProblemScores& a, const ProblemScores& b) { return a.entry->name < b.entry->name; });
}

// Of the measures that a final state has: the first that theory gives an order to, else the first.
std::string leading_measure(const Start& start) {
  const Settings settings = start.settings();
  const std::vector<Measure> all = measures_to_be_judged(*start.entry->problem(settings), settings);
  for (const Statement::TheoryOrder& theory : start.entry->statement().theory_orders) {
    if (std::any_of(all.begin(), all.end(), [&](const Measure& m) { return m.name == theory.measure; }))
      return theory.measure;
  }
  return all.empty() ? "" : all.front().name;
}

StudyResult run_default(const ProblemScores& problem, int threads, const Progress& progress, RunStore& store) {
  StudyPlan plan{.id = "default", .title = "the default scheme from the same starts", .why = {}};
  std::vector<PlannedRun> planned;
  for (const Start& start : problem.starts) {
    plan.values.push_back(start.cells);
    planned.push_back({static_cast<double>(start.cells), start.settings()});
  }
  return run_study(*problem.entry, plan, planned, threads, progress, &store);
}

Entry without_result(const std::optional<AdapterEnd>& end) {
  if (!end || end->how == AdapterEnd::How::written) return {Outcome::missing, "there is no result", {}, false};
  return {end->how == AdapterEnd::How::late ? Outcome::late : Outcome::failed, end->reason, {}, false};
}

// A program's result of one start, judged alone. Whatever is wrong with it is said in the entry; throws Interrupted.
Entry judge_result(const ScoreFolder& folder, const std::string& program, const Start& start, double patience) {
  const std::string path = folder.result(program, start.name);
  try {
    const auto end = folder.read_end(program, start.name);
    if (!is_there(path)) return without_result(end);
    const ResultFile file(path, patience);
    if (file.case_name != start.entry->name || file.cells != start.cells) {
      return {Outcome::mismatched,
              fmt::format("it is of {} at {} cells; {} at {} cells is wanted", file.case_name, file.cells,
                          start.entry->name, start.cells),
              {},
              false};
    }
    score(*start.entry, {path}, start.typed, patience);
    if (file.wall_s > 0) return {Outcome::scored, "", file.wall_s, false};
    if (end && end->how == AdapterEnd::How::written) return {Outcome::scored, "", end->seconds, true};
    return {Outcome::scored, "", {}, false};
  } catch (const Interrupted&) {
    throw;
  } catch (const UsageError& error) {
    return {Outcome::mismatched, reason_of(error, path), {}, false};
  } catch (const std::exception& error) {
    return {Outcome::damaged, reason_of(error, path), {}, false};
  }
}

ProgramScore score_program(const ScoreFolder& folder, double patience, const std::string& program,
                           const ProblemScores& problem) {
  ProgramScore scored{.program = program, .entries = {}, .score = {}, .reason = {}};
  std::vector<std::string> files;
  for (const Start& start : problem.starts) {
    scored.entries.push_back(judge_result(folder, program, start, patience));
    if (scored.entries.back().outcome == Outcome::scored) files.push_back(folder.result(program, start.name));
  }
  if (files.empty()) return scored;
  try {
    scored.score = score(*problem.entry, files, problem.starts.front().typed, patience);
  } catch (const UsageError& error) {
    scored.reason = error.what();
  } catch (const FileError& error) {  // it was read before, but nothing about it can be relied upon
    scored.reason = error.what();
  }
  return scored;
}

Json number_or_null(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

// Orders of all measures; none of a single level.
Json orders_of(const StudyResult& study) {
  Json orders = Json::object();
  if (study.levels.size() < 2) return orders;
  for (const auto& [measure, fit] : study.fits) orders[measure] = to_json(fit);
  return orders;
}

Json own_document(const StudyResult& own) {
  Json levels = Json::array();
  for (const StudyLevel& at : own.levels) {
    Json errors = Json::object();
    for (const Measure& m : at.run.measures) errors[m.name] = m.error;
    Json level{
        {"cells", at.run.settings.integer("cells")}, {"h", at.h}, {"errors", errors}, {"seconds", at.run.wall_s}};
    level["stop"] = at.run.stop ? Json(at.run.stop->reason) : Json(nullptr);
    levels.push_back(std::move(level));
  }
  return {{"scheme", own.scheme}, {"levels", levels}, {"orders", orders_of(own)}};
}

Json entry_document(const Start& start, const Entry& entry, const ProgramScore& scored, const StudyResult& own) {
  const StudyLevel *level = scored.level(start.cells), *other = own.level(start.cells);
  Json errors = Json::object();
  if (level) {
    for (const Measure& m : level->run.measures) {
      errors[m.name] = {{"error", m.error}, {"ratio", number_or_null(error_ratio(m.name, level, other))}};
    }
  }
  Json document{{"start", start.name},
                {"cells", start.cells},
                {"outcome", name(entry.outcome)},
                {"reason", entry.reason},
                {"errors", errors}};
  document["verdict"] = level ? Json(name(overall(verdicts(gates_of_level(*scored.score, *level))))) : Json(nullptr);
  document["seconds"] = number_or_null(entry.seconds);
  document["timed"] = !entry.seconds ? Json(nullptr) : Json(entry.timed_adapter ? "adapter" : "program");
  return document;
}

Json program_document(const ProgramScore& scored, const ProblemScores& problem) {
  Json entries = Json::array(), not_judged = Json::array();
  for (std::size_t k = 0; k < scored.entries.size(); ++k)
    entries.push_back(entry_document(problem.starts[k], scored.entries[k], scored, problem.own));
  Json document{{"name", scored.program}, {"entries", entries}, {"reason", scored.reason}};
  const auto& score = scored.score;
  if (score) {
    for (const NotJudged& gate : score->not_judged) not_judged.push_back({{"id", gate.id}, {"reason", gate.reason}});
  }
  document["program"] = score ? Json(score->program) : Json(nullptr);
  document["version"] = score ? Json(score->version) : Json(nullptr);
  document["study"] = score && score->declared ? Json(*score->declared) : Json(nullptr);
  document["verdict"] = score ? Json(name(overall(verdicts(score->gates)))) : Json(nullptr);
  document["orders"] = score ? orders_of(score->study) : Json::object();
  document["gates"] = score ? to_json(score->gates) : Json::array();
  document["not_judged"] = not_judged;
  return document;
}

Json problem_document(const ProblemScores& problem) {
  Json programs = Json::array(), units = Json::object();
  for (const ProgramScore& scored : problem.programs) programs.push_back(program_document(scored, problem));
  for (const StudyLevel& at : problem.own.levels) {
    for (const Measure& m : at.run.measures) units[m.name] = m.unit;
  }
  return {{"case", problem.entry->name},
          {"title", problem.entry->statement().title},
          {"settings", problem.starts.front().typed},
          {"measure", problem.measure},
          {"units", units},
          {"own", own_document(problem.own)},
          {"programs", programs}};
}

}  // namespace

std::string_view name(Outcome outcome) {
  constexpr std::array<std::string_view, 6> names{"scored", "missing", "damaged", "mismatched", "failed", "late"};
  return names[static_cast<std::size_t>(outcome)];
}

const StudyLevel* ProgramScore::level(int cells) const { return score ? score->study.level(cells) : nullptr; }

Scoreboard make_scoreboard(const ScoreFolder& folder, double patience, int threads, const Progress& progress,
                           RunStore& store) {
  Scoreboard board;
  take_starts(folder, board);
  const std::vector<std::string> programs = folder.programs();
  for (ProblemScores& problem : board.problems) {
    problem.own = run_default(problem, threads, progress, store);
    problem.measure = leading_measure(problem.starts.front());
    for (const std::string& program : programs)
      problem.programs.push_back(score_program(folder, patience, program, problem));
  }
  for (const std::string& program : programs) {
    for (const std::string& file : folder.strays(program)) board.strays.push_back(program + "/" + file);
  }
  return board;
}

std::optional<double> error_ratio(const std::string& measure, const StudyLevel* level, const StudyLevel* other) {
  const Measure* mine = level ? level->run.find(measure) : nullptr;
  const Measure* theirs = other ? other->run.find(measure) : nullptr;
  if (!mine || !theirs || !(theirs->error > 0)) return std::nullopt;
  return mine->error / theirs->error;
}

std::vector<Verdict> verdicts(const Scoreboard& board) {
  std::vector<Verdict> all(board.refused.size(), Verdict::invalid);
  for (const ProblemScores& problem : board.problems) {
    for (const ProgramScore& scored : problem.programs) {
      for (const Entry& entry : scored.entries) {
        if (entry.outcome != Outcome::scored) all.push_back(Verdict::invalid);
      }
      if (!scored.reason.empty()) all.push_back(Verdict::invalid);
      if (!scored.score) continue;
      const std::vector<Verdict> own = verdicts(scored.score->gates);
      all.insert(all.end(), own.begin(), own.end());
    }
  }
  return all;
}

Json scoreboard_document(const Scoreboard& board, const Provenance& provenance) {
  Json problems = Json::array(), refused = Json::array();
  for (const ProblemScores& problem : board.problems) problems.push_back(problem_document(problem));
  for (const auto& [start, reason] : board.refused) refused.push_back({{"start", start}, {"reason", reason}});
  return {{"scoreboard", scoreboard_format},
          {"problems", problems},
          {"refused", refused},
          {"strays", board.strays},
          {"provenance", to_json(provenance)}};
}

}  // namespace plumbline
