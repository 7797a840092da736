#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include <unistd.h>

#include <algorithm>
#include <map>
#include <sstream>
#include <thread>

#include "cases/harness/commands/command.hpp"
#include "cases/harness/commands/recorded.hpp"
#include "cases/harness/commands/verify_parts.hpp"
#include "cases/harness/files/input_file.hpp"
#include "cases/harness/files/json_text.hpp"
#include "cases/harness/files/text_file.hpp"
#include "cases/harness/integrators/judge.hpp"
#include "cases/harness/integrators/scorecard.hpp"
#include "cases/harness/judge/expected_failures.hpp"
#include "cases/harness/run/guarded_integrator.hpp"

namespace plumbline {
namespace {

struct VerifyOptions {
  std::vector<std::string> patterns, gates;
  std::string tier = "quick", junit;
  std::string against;
  bool core = false, until_red = false;
  ChosenParts parts;
};

Json to_json(const FailureCounts& counts) {
  Json document = Json::object();
  for (const FailureOf whose : all_failures_of) document[std::string(name(whose))] = counts[whose];
  return document;
}

Json to_json(const std::vector<RecordedValue::Key>& gates) {
  Json list = Json::array();
  for (const auto& [case_name, study, id, tier] : gates)
    list.push_back({{"case", case_name}, {"study", study}, {"id", id}});
  return list;
}

void print_recorded(const Output& out, const Verification& verification, const std::string& tier) {
  if (verification.regressions > 0) {
    out.line("{} of the gates judge a recorded value (ID/regression); those that hold are not listed",
             verification.regressions);
  }
  if (verification.unrecorded.empty()) return;
  const auto& [case_name, study, id, in_tier] = verification.unrecorded.front();
  out.line(
      "no value of the {} tier is recorded of {} gates that pass, {} of {} the first: `plumbline tolerances "
      "cases/tolerances.json --record` of the JSON of this command records them",
      tier, verification.unrecorded.size(), id, case_name);
}

void write_junit(const std::string& path, const std::vector<JudgedGate>& gates, bool allow_inconclusive) {
  boost::property_tree::ptree suite;
  int failures = 0;
  for (const JudgedGate& g : gates) {
    boost::property_tree::ptree test;
    test.put("<xmlattr>.classname", g.case_name);
    test.put("<xmlattr>.name", g.gate.id);
    if (is_red(g, allow_inconclusive)) {
      ++failures;
      test.put("failure.<xmlattr>.message", fmt::format("{}: measured {}; {}", name(g.judgement.verdict),
                                                        g.measured.value.value_or(0), g.gate.reason));
    }
    suite.add_child("testcase", test);
  }
  suite.put("<xmlattr>.name", "plumbline");
  suite.put("<xmlattr>.tests", gates.size());
  suite.put("<xmlattr>.failures", failures);
  boost::property_tree::ptree root;
  root.add_child("testsuite", suite);
  std::ostringstream text;
  boost::property_tree::write_xml(text, root);
  write_text_file(path, text.str());
}

JudgingProgress judging_progress(const std::string& integrator) {
  if (!::isatty(STDERR_FILENO)) return {};
  return [integrator](std::size_t done, std::size_t of, const std::string& gate) {
    fmt::print(stderr, "\r\033[K{}: {} of {} gates, last {}", integrator, done, of, gate);
    std::fflush(stderr);
  };
}

// The values that assignments give to an integrator's parameters. Others' keys are refused, unless `lenient`.
std::map<std::string, double> parameters_of(const Subject& subject, const std::vector<std::string>& assignments,
                                            bool lenient) {
  Settings settings(integrator_keys(subject.entry()));
  for (const std::string& assignment : assignments) {
    const std::string key = assignment.substr(0, assignment.find('='));
    if (!lenient || settings.has(key)) settings.set_text(assignment, "integrator " + subject.name());
  }
  std::map<std::string, double> chosen;
  for (const Key& key : settings.keys()) chosen[key.name] = settings.number(key.name);
  return chosen;
}

Json read_scorecard(const std::string& file) {
  const Json document = Json::parse(read_text_file(file), nullptr, false);
  if (document.is_discarded() || !document.is_object()) throw FileError(file, file + ": not a scorecard");
  const Json* card = document.contains("scorecards") && !document["scorecards"].empty() ? &document["scorecards"][0]
                                                                                        : &document;
  for (const char* key : {"integrator", "families", "limits", "cost"}) {
    if (!card->contains(key)) throw FileError(file, fmt::format("{}: no scorecard: it has no {}", file, key));
  }
  return *card;
}

// The half of a scorecard that an integrator is set beside: another integrator's, or that of an earlier scorecard's file.
// Its costs are timed in turns with `subject`.
Json opponent(const std::string& against, const Subject& subject, Json& half, const JudgingOptions& how) {
  const std::string name = against.empty() ? usual_opponent(subject.name()) : against;
  if (!find_integrator(name) && is_there(name)) return read_scorecard(name);
  const Subject other({name, {}});
  const JudgingOptions core{Effort::core, how.threads};
  Json other_half = scorecard_half(other, judge_integrator(other, core), core);
  if (how.effort == Effort::whole) add_costs(subject, half, other, other_half);
  return other_half;
}

// Written to the results folder, too.
Json scorecard_of(const Subject& subject, const JudgedIntegrator& judged, const VerifyOptions& options,
                  const JudgingOptions& how, const ResultsFolder& folder) {
  Json half = scorecard_half(subject, judged, how);
  const Json against = opponent(options.against, subject, half, how);
  Json card = scorecard(std::move(half), against, judged);
  card["gates"] = to_json(judged.gates);
  card["not_applicable"] = to_json(judged.not_applicable);
  write_text_file(folder.path() + "/scorecard-" + subject.name() + ".json", json_text(card, 1) + "\n");
  return card;
}

struct Scorecards {
  Json all = Json::array();
  bool missing = false;  // an integrator misbehaved where one was to be made
};

// The gates of each integrator, and its scorecard.
Scorecards judge_integrators(const CommonOptions& common, const VerifyOptions& options, const ResultsFolder& folder,
                             Verification& verification) {
  const bool with_cases = !options.patterns.empty();
  const JudgingOptions how{options.core || with_cases ? Effort::core : Effort::whole, common.threads,
                           options.until_red};
  Scorecards scorecards;
  for (const std::string& name : common.integrators) {
    const Subject plain({name, {}});
    const Subject subject({name, parameters_of(plain, common.settings, with_cases)});
    JudgedIntegrator judged = judge_integrator(subject, how, judging_progress(name));
    end_progress();
    try {
      if (!options.until_red) scorecards.all.push_back(scorecard_of(subject, judged, options, how, folder));
    } catch (const MisbehavingIntegrator& error) {  // its gates keep their verdicts
      Output(common).line("no scorecard of {}: {}", name, error.what());
      scorecards.missing = true;
    }
    verification.declared += judged.declared;
    std::move(judged.gates.begin(), judged.gates.end(), std::back_inserter(verification.gates));
    std::move(judged.not_applicable.begin(), judged.not_applicable.end(),
              std::back_inserter(verification.not_applicable));
  }
  return scorecards;
}

// Each pattern of a gate must match one of those that the selection of some case may judge.
void refuse_unknown_gates(const std::vector<const Case*>& entries, const Selection& selection, Tier tier) {
  if (selection.gates.empty()) return;
  std::vector<std::string> names;
  for (const Case* entry : entries) {
    for (const std::string& name : gate_names(*entry, tier, selection)) {
      names.push_back(name);
      names.push_back(regression_of(name));
    }
  }
  for (const std::string& pattern : selection.gates) {
    Selection one;
    one.gates = {pattern};
    if (std::none_of(names.begin(), names.end(), [&](const std::string& name) { return one.takes(name); }))
      throw unknown_name("gate", pattern, names);
  }
}

// A case that is asked for by its own name must work with what was chosen; one that a pattern matches is listed.
void verify_cases(const CommonOptions& common, const VerifyOptions& options, RunStore& store,
                  Verification& verification) {
  const auto& asked = options.patterns;
  const Tier tier = options.tier == "full" ? Tier::full : Tier::quick;
  const std::vector<const Case*> entries = matching_cases(asked);
  Selection selection{common.schemes, common.integrators, common.settings, false, &recorded_values(), options.gates};
  refuse_unknown_gates(entries, selection, tier);
  for (const Case* entry : entries) {
    selection.by_name = std::find(asked.begin(), asked.end(), entry->name) != asked.end();
    verify_case(*entry, tier, selection, common.threads, store, terminal_progress(entry->name), verification);
    end_progress();
  }
}

// All but recorded values that hold, and identities of an integrator that do: there are hundreds, and they are counted.
std::vector<JudgedGate> worth_a_line(std::vector<JudgedGate> gates) {
  gates.erase(std::remove_if(gates.begin(), gates.end(),
                             [](const JudgedGate& gate) {
                               const bool many = gate.study == "identities" || of_record(gate);
                               return many && gate.judgement.verdict == Verdict::pass;
                             }),
              gates.end());
  return gates;
}

int execute(const Invocation& invocation, const VerifyOptions& options) {
  const CommonOptions& common = invocation.options;
  refuse_cases(options.parts, options.patterns);
  if (!options.gates.empty() && options.patterns.empty()) {
    throw UsageError("--gate", options.gates.front(), "with the name of a case", {},
                     "--gate names gates of cases: name the case, too");
  }
  const std::vector<std::string> tiers{"quick", "full"};
  if (options.tier != tiers[0] && options.tier != tiers[1]) throw unknown_name("--tier", options.tier, tiers);
  if (!options.junit.empty()) require_writable(options.junit);
  const ResultsFolder folder(common.results);
  const Provenance provenance = invocation.provenance();
  RunStore store(folder, provenance, common.reuse);
  const Output out(common);
  Verification verification;
  const Scorecards scorecards = judge_integrators(common, options, folder, verification);
  PartJudging of_parts{common.threads, options.until_red, {}};
  if (!none(options.parts) && common.integrators.empty()) of_parts.shape = shape_for(options.parts, common.settings);
  const Json parts = judge_parts(options.parts, of_parts, judging_progress, verification);
  const bool parts_alone = options.patterns.empty() && common.schemes.empty() &&
                           (!common.integrators.empty() || !none(options.parts));
  if (!parts_alone) verify_cases(common, options, store, verification);
  const FailureCounts failures = expected_failures(verification.gates);
  const Json document{{"gates", to_json(verification.gates)},
                      {"counts", counts_document(verification.gates)},
                      {"expected_failures", to_json(failures)},
                      {"executed", verification.gates.size()},
                      {"regressions", verification.regressions},
                      {"unrecorded", to_json(verification.unrecorded)},
                      {"lost", to_json(verification.lost)},
                      {"settings", common.settings},
                      {"chosen_gates", options.gates},
                      {"declared", verification.declared},
                      {"not_applicable", to_json(verification.not_applicable)},
                      {"scorecards", scorecards.all},
                      {"parts", parts},
                      {"tier", options.tier},
                      {"provenance", to_json(provenance)}};
  const bool some_gates = !options.gates.empty();
  if (!parts_alone && !some_gates) folder.write_verdicts(document, verification.entries, options.tier, provenance);
  out.gates(some_gates ? verification.gates : worth_a_line(verification.gates));
  for (const NotApplicable& one : verification.not_applicable) {
    out.line("not applicable: {} with {}: {}", one.what, one.integrator, CannotWork(one.lacks).what());
  }
  std::string counts;
  for (const auto& [verdict, count] : document["counts"].items()) {
    if (count.get<int>() > 0) counts += fmt::format(" {} {}", verdict, count.get<int>());
  }
  const std::string expected = words(failures);
  out.line("{} gates executed, {} not applicable, {} declared:{}{}", verification.gates.size(),
           verification.not_applicable.size(), verification.declared, counts, expected.empty() ? "" : "; " + expected);
  if (!some_gates) print_recorded(out, verification, options.tier);
  for (const Json& card : scorecards.all) {
    for (const std::string& line : scorecard_lines(card)) out.line("{}", line);
  }
  for (const Json& part : parts) out.line("{}", part_line(part));
  print_reused(out, store);
  write_json(common, document);
  if (!options.junit.empty()) write_junit(options.junit, verification.gates, common.allow_inconclusive);
  if (!options.until_red && !complete(verification)) {
    for (const auto& [case_name, study, id, tier] : verification.lost)
      out.line("lost: gate {} of {}, study {}, is declared or recorded and was not executed", id, case_name, study);
    out.line("INVALID: the number of gates executed and not applicable is not the number declared");
    return exit_red;
  }
  const bool red = std::any_of(verification.gates.begin(), verification.gates.end(),
                               [&](const JudgedGate& gate) { return is_red(gate, common.allow_inconclusive); });
  if (red || verification.gates.empty()) return exit_red;
  return scorecards.missing ? exit_stopped : 0;
}

}  // namespace

Command add_verify(const Arguments& program, Invocation& invocation) {
  const Arguments sub = program.command("verify", "all gates of the matching cases, or of a part of a scheme",
                                        "Examples: plumbline verify 'sod*' --tier quick --junit verify.xml\n"
                                        "          plumbline verify --integrator mine --plugin libmine.so\n"
                                        "          plumbline verify --shape cubic");
  auto options = std::make_shared<VerifyOptions>();
  sub.option("pattern", options->patterns, "case names or patterns; all cases if none");
  sub.option("--tier", options->tier, "quick or full");
  sub.option("--gate", options->gates,
             "of the cases these gates alone, by name or pattern, with the runs that they need (repeatable)")
      .repeatable();
  sub.option("--junit", options->junit, "write JUnit XML to a file");
  sub.option("--against", options->against,
             "of --integrator: an integrator, or the file of an earlier scorecard, to be set beside");
  sub.flag("--core", options->core, "of --integrator without cases: the core gates alone, in seconds");
  sub.flag("--until-red", options->until_red,
           "of --integrator, --shape and the like: begin no gate after one that is red");
  add_part_options(sub, options->parts);
  add_run_options(sub, invocation.options);
  add_reuse(sub, invocation.options);
  add_no_fusion(sub, invocation.options);
  return {sub, [&invocation, options, sub] {
            const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
            if (!sub.given("--threads")) invocation.options.threads = static_cast<int>(cores);
            return execute(invocation, *options);
          }};
}

}  // namespace plumbline
