#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include <sstream>

#include "cases/commands/command.hpp"
#include "cases/harness/text_file.hpp"

namespace plumbline {
namespace {

struct VerifyOptions {
  std::vector<std::string> patterns;
  std::string tier = "quick", junit;
};

void write_junit(const std::string& path, const std::vector<JudgedGate>& gates, bool allow_inconclusive) {
  boost::property_tree::ptree suite;
  int failures = 0;
  for (const JudgedGate& g : gates) {
    boost::property_tree::ptree test;
    test.put("<xmlattr>.classname", g.case_name);
    test.put("<xmlattr>.name", g.gate.id);
    const std::vector<Verdict> one{g.judgement.verdict};
    if (exit_status(one, allow_inconclusive) != 0) {
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

int execute(const Invocation& invocation, const VerifyOptions& options) {
  const CommonOptions& common = invocation.options;
  const std::vector<std::string> tiers{"quick", "full"};
  if (options.tier != tiers[0] && options.tier != tiers[1]) throw unknown_name("--tier", options.tier, tiers);
  const Selection selection{common.schemes, common.integrators, common.settings};
  const auto entries = matching_cases(options.patterns);
  const ResultsFolder folder(common.results);
  const Provenance provenance = invocation.provenance();
  RunStore store(folder, provenance, common.reuse);
  const Output out(common);
  Verification verification;
  for (const Case* entry : entries) {
    verify_case(*entry, options.tier == "full" ? Tier::full : Tier::quick, selection, common.threads, store,
                terminal_progress(entry->name()), verification);
    end_progress();
  }
  const Json document{{"gates", to_json(verification.gates)},
                      {"counts", counts_document(verification.gates)},
                      {"executed", verification.gates.size()},
                      {"declared", verification.declared},
                      {"tier", options.tier}};
  folder.write_verdicts(document, verification.entries, options.tier, provenance);
  out.gates(verification.gates);
  std::string counts;
  for (const auto& [verdict, count] : document["counts"].items()) {
    if (count.get<int>() > 0) counts += fmt::format(" {} {}", verdict, count.get<int>());
  }
  out.line("{} gates executed, {} declared:{}", verification.gates.size(), verification.declared, counts);
  print_reused(out, store);
  write_json(common, document);
  if (!options.junit.empty()) write_junit(options.junit, verification.gates, common.allow_inconclusive);
  if (complete(verification)) return exit_of(false, verification.gates, common.allow_inconclusive);
  out.line("INVALID: the number of gates executed is not the number declared");
  return exit_red;
}

}  // namespace

Command add_verify(CLI::App& app, Invocation& invocation) {
  CLI::App* sub = app.add_subcommand("verify", "all gates of the matching cases");
  sub->footer("Example: plumbline verify 'sod*' --tier quick --junit verify.xml");
  auto options = std::make_shared<VerifyOptions>();
  sub->add_option("pattern", options->patterns, "case names or patterns; all cases if none");
  sub->add_option("--tier", options->tier, "quick or full");
  sub->add_option("--junit", options->junit, "write JUnit XML to a file");
  add_run_options(*sub, invocation.options);
  add_reuse(*sub, invocation.options);
  return {sub, [&invocation, options] { return execute(invocation, *options); }};
}

}  // namespace plumbline
