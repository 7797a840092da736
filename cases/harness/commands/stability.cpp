#include <algorithm>
#include <cmath>
#include <deque>

#include "cases/harness/commands/command.hpp"
#include "cases/harness/files/pool.hpp"
#include "cases/harness/laboratory/known_limits.hpp"
#include "cases/harness/laboratory/stability_documents.hpp"
#include "kernel/time_integrator.hpp"

namespace plumbline {
namespace {

struct StabilityOptions {
  std::vector<std::string> problems, over;
  bool no_runs = false, maps = false;
  std::string tier = "quick";
};

// What to examine of one problem.
struct Chosen {
  std::string scheme;
  std::vector<Override> overrides;
};

// "key=v1,v2,...": the key with each of its values.
std::vector<std::string> assignments(const std::string& over) {
  const std::size_t equals = over.find('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == over.size()) {
    throw UsageError("--over", over, "key=value,value,...", {},
                     fmt::format("--over wants key=value,value,..., got '{}'", over));
  }
  std::vector<std::string> all;
  std::size_t start = equals + 1;
  while (start <= over.size()) {
    const std::size_t comma = std::min(over.find(',', start), over.size());
    all.push_back(over.substr(0, equals + 1) + over.substr(start, comma - start));
    start = comma + 1;
  }
  return all;
}

// The chosen schemes and integrators; where neither is named and all problems are asked for, every scheme, and of quick
// problems every integrator that can work with the problem's own choices or its concessions.
std::vector<Chosen> choices_of(const StabilityProblem& problem, const CommonOptions& options, bool all) {
  std::vector<Chosen> found;
  if (!all || !options.schemes.empty() || !options.integrators.empty()) {
    for (const SchemeChoice& chosen : chosen_schemes(options)) found.push_back({chosen.scheme, chosen.overrides});
    return found;
  }
  if (!problem.compares_integrators()) return {{"default", {}}, {"york1997", {}}};
  for (const IntegratorEntry& entry : integrators()) {
    const WorkableSettings workable = workable_settings(problem, {{"integrator", entry.name}});
    if (workable.settings) found.push_back({"default", workable.overrides});
  }
  if (problem.has_grid()) found.push_back({"york1997", {}});
  return found;
}

std::vector<std::pair<std::string, Settings>> settings_of(const StabilityProblem& problem, const CommonOptions& options,
                                                          const StabilityOptions& own, bool all) {
  std::vector<std::vector<std::string>> typed{options.settings};
  for (const std::string& over : own.over) {
    std::vector<std::vector<std::string>> product;
    for (const auto& before : typed) {
      for (const std::string& assignment : assignments(over)) {
        product.push_back(before);
        product.back().push_back(assignment);
      }
    }
    typed = std::move(product);
  }
  std::vector<std::pair<std::string, Settings>> found;
  for (const Chosen& chosen : choices_of(problem, options, all)) {
    for (const auto& assignments_made : typed) {
      Settings settings = stability_settings(problem, chosen.scheme, chosen.overrides, assignments_made);
      const bool there = std::any_of(found.begin(), found.end(),
                                     [&](const auto& other) { return other.second == settings; });
      if (!there) found.emplace_back(chosen.scheme, std::move(settings));
    }
  }
  return found;
}

std::string text_of(const StableInterval& interval) {
  return std::isinf(interval.high) ? fmt::format("{:.6g} ... end of the scan", interval.low)
                                   : fmt::format("{:.6g} ... {:.8g}", interval.low, interval.high);
}

// The known limits of every integrator that was asked for, found once each: on all problems, or on those where that is
// quick, as always for implicit steps.
class KnownLists {
 public:
  KnownLists(bool all, int threads) : all_(all), threads_(threads) {}

  const KnownList& of(const IntegratorChoice& integrator) {
    const auto found = std::find_if(lists_.begin(), lists_.end(), [&](const KnownList& list) {
      return list.integrator.name == integrator.name && list.integrator.parameters == integrator.parameters;
    });
    if (found != lists_.end()) return *found;
    KnownList list{integrator, {}, {}};
    const bool far = reaches_far(integrator);  // an implicit step: most problems take minutes
    for (const StabilityProblem* problem : stability_problems()) {
      const bool wanted = (all_ && !far) || problem->quickly_listed(!far);
      if (problem->listed().empty() || !wanted) continue;
      list.problems.push_back(problem);
    }
    list.rows = limits_of(integrator, threads_, list.problems);
    lists_.push_back(std::move(list));
    return lists_.back();
  }
  const std::deque<KnownList>& lists() const { return lists_; }

 private:
  bool all_;
  int threads_;
  std::deque<KnownList> lists_;
};

std::string names_of(const std::vector<const StabilityProblem*>& problems) {
  std::string names;
  for (const StabilityProblem* problem : problems) names += (names.empty() ? "" : ", ") + problem->name();
  return names;
}

IntegratorChoice integrator_of(const Configuration& found) {
  return {found.settings.text("integrator"), integrator_parameters(found.settings)};
}

// Which limit is the smallest known, and which this one is.
void print_smallest(const Output& out, const Configuration& found, const KnownList& known) {
  const SmallestKnown smallest = smallest_known(found, known);
  const std::string& integrator = known.integrator.name;
  std::string line;
  if (smallest.is_this) {
    line = fmt::format("this is the smallest known limit of {}: {:.4g} h/c on {} ({})", integrator, smallest.limit,
                       smallest.problem, smallest.words);
  } else if (smallest.limit > 0) {
    line = fmt::format("smallest known limit of {}: {:.4g} h/c on {} ({}); this is {}: {}", integrator, smallest.limit,
                       smallest.problem, smallest.words, found.problem->name(), limit_in_words(found));
  } else {
    line = fmt::format("no limit of {} in h/c is known; this is {}: {}", integrator, found.problem->name(),
                       limit_in_words(found));
  }
  std::string without;
  for (const KnownLimit& row : known.rows) {
    if (!row.no_stable_step() || row.problem == found.problem) continue;
    const std::string words = row.words();
    without += fmt::format("; no stable step on {}{}", row.problem->name(), words.empty() ? "" : " (" + words + ")");
  }
  out.line("  {}{}", line, without);
}

void print(const Output& out, const StabilityProblem& problem, const Configuration& found) {
  std::string chosen;
  for (const Key& key : problem.keys()) chosen += fmt::format(" {}={}", key.name, to_text(found.settings[key.name]));
  std::string method = found.settings.text("integrator");
  for (const char* key : {"shape", "transfer", "ppc"}) {
    if (found.settings.has(key)) method += fmt::format(" {}", to_text(found.settings[key]));
  }
  for (const auto& [name, value] : integrator_parameters(found.settings)) chosen += fmt::format(" {}={}", name, value);
  out.line("{}:{} [{}]", method, chosen, found.scheme);
  if (!found.note.empty()) {
    out.line("  nothing found: {}", found.note);
    return;
  }
  std::string stable;
  for (const StableInterval& interval : found.predicted.stable)
    stable += (stable.empty() ? "" : ", ") + text_of(interval);
  if (found.predicted.always_unstable()) stable = "no step of the scan";
  out.line("  predicted stable  {} ({}){}", stable, found.unit,
           found.closed_form ? fmt::format("; closed form {:.8g}", found.closed_form->limit) : "");
  if (found.observed) {
    std::string seen;
    for (const Bracket& b : found.observed->brackets) {
      seen += fmt::format("{}{} between {:.6g} and {:.6g}", seen.empty() ? "" : ", ",
                          b.stable_below ? "lost" : "regained", b.low, b.high);
    }
    if (found.observed->always_stable) seen = "stable at every step of the scan";
    if (found.observed->always_unstable) seen = "unstable at every step of the scan";
    out.line("  observed          {}", seen);
  }
  const auto& growth = found.predicted.growth;
  if (!growth.empty() && growth.front().per_step > stable_radius) {
    out.line("  grows at the smallest step of the scan, {:.4g}: {:.6g} a step, rate {:.3g} in units of 1/time",
             growth.front().dt, growth.front().per_step, std::log(growth.front().per_step) / growth.front().dt);
  }
  for (const auto& [quantity, order] : found.orders) {
    out.line("  order of {}: {:.4f} [{:.4f}, {:.4f}]", quantity, order.order, order.low, order.high);
  }
  if (!found.sampled.empty()) out.line("  sampled: {}", found.sampled);
}

// What converges is of first order; a tenth is left to the terms of higher order in a fit.
constexpr double least_order = 0.9;

// Prints the orders that say that the step does not follow the problem; how many.
int print_lost_orders(const Output& out, const Configuration& found) {
  int lost = 0;
  for (const auto& [quantity, order] : found.orders) {
    if (order.high >= least_order) continue;
    out.line("  {} order of {}: {:.4f} is below {}: {} does not converge", coloured(Verdict::fail), quantity,
             order.order, least_order, found.settings.text("integrator"));
    ++lost;
  }
  return lost;
}

// Of every integrator, shape and transfer; in the quick tier of those that York's and the default scheme of gases choose.
Json safe_table(Tier tier, int threads) {
  const bool full = tier == Tier::full;
  std::vector<std::pair<Method, int>> rows;  // and points per cell
  const std::vector<Method> all = full ? methods({"linear", "gimp", "quadratic", "cubic"},
                                                 {"pic", "flip", "apic", "xpic", "fmpm"})
                                       : methods({"linear", "quadratic"}, {"flip", "apic"});
  for (const Method& method : all) {
    for (const int ppc : full ? std::vector<int>{1, 2} : std::vector<int>{2}) rows.emplace_back(method, ppc);
  }
  std::vector<Json> found(rows.size());
  for_all(rows.size(), threads,
          [&](std::size_t k) { found[k] = to_json(safe_step_of_bar(rows[k].first, 2, {}, rows[k].second, full)); });
  return Json(found);
}

// What the laboratory finds; why it finds nothing is a result, too: a step that cannot be taken, or has no derivative.
Configuration examined(const StabilityProblem& problem, const std::string& scheme, const Settings& settings,
                       bool runs) {
  try {
    return examine(problem, scheme, settings, runs);
  } catch (const UsageError&) {
    throw;
  } catch (const std::runtime_error& error) {
    return {&problem, scheme, settings, problem.unit(), problem.scan(settings), {}, {}, {}, {}, {}, error.what()};
  }
}

Json examine_all(const Output& out, const StabilityProblem& problem, const CommonOptions& options,
                 const StabilityOptions& own, bool all, KnownLists& known, int& lost_orders) {
  const Tier tier = own.tier == "full" ? Tier::full : Tier::quick;
  const auto chosen = settings_of(problem, options, own, all);
  std::vector<std::optional<Configuration>> found(chosen.size());
  for_all(chosen.size(), options.threads, [&](std::size_t k) {
    const auto& [scheme, settings] = chosen[k];
    found[k] = examined(problem, scheme, settings, !own.no_runs);
  });
  out.line("{}: {} [{}]", problem.name(), problem.statement().title, problem.statement().source);
  Json document = problem_document(problem);
  for (const auto& configuration : found) {
    const KnownList& list = known.of(integrator_of(*configuration));
    print(out, problem, *configuration);
    lost_orders += print_lost_orders(out, *configuration);
    print_smallest(out, *configuration, list);
    document["configurations"].push_back(to_json(*configuration));
    document["configurations"].back()["smallest_known"] = to_json(smallest_known(*configuration, list));
  }
  if (!own.maps) return document;
  document["maps"] = Json::array();
  for (const MapPlan& plan : problem.maps(tier)) {
    document["maps"].push_back(to_json(draw_map(problem, plan, options.threads)));
  }
  document["safe"] = problem.name() == "bar" ? safe_table(tier, options.threads) : Json::array();
  out.line("  {} maps, {} rows of safe steps", document["maps"].size(), document["safe"].size());
  return document;
}

int execute(const Invocation& invocation, const StabilityOptions& own) {
  const bool all = own.problems == std::vector<std::string>{"all"};
  std::vector<const StabilityProblem*> problems;
  if (all) problems = stability_problems();
  for (const std::string& name : all ? std::vector<std::string>{} : own.problems) {
    problems.push_back(&find_stability_problem(name));
  }
  const Output out(invocation.options);
  Json documents = Json::array();
  int lost_orders = 0;
  KnownLists known(all, invocation.options.threads);
  for (const StabilityProblem* problem : problems) {
    documents.push_back(examine_all(out, *problem, invocation.options, own, all, known, lost_orders));
  }
  for (const KnownList& list : known.lists()) {
    out.line("known limits of {}: those on {}{}", list.integrator.name, names_of(list.problems),
             all || reaches_far(list.integrator) ? "" : "; `stability all` has those on every problem");
  }
  Json document = problems.size() == 1 && !all ? documents.front() : Json{{"problems", documents}};
  document["known_limits"] = Json::array();
  for (const KnownList& list : known.lists()) document["known_limits"].push_back(to_json(list));
  document["provenance"] = to_json(invocation.provenance());
  write_json(invocation.options, document);
  return lost_orders > 0 ? exit_red : 0;
}

}  // namespace

Command add_stability(const Arguments& program, Invocation& invocation) {
  const Arguments sub = program.command("stability",
                                        "limits of the time step: predicted by the step itself, and seen in runs",
                                        "Example: plumbline stability bar --integrator usl --over N=0.1,0.3,0.5");
  auto options = std::make_shared<StabilityOptions>();
  sub.option("problem", options->problems, "the problems, or all").required();
  sub.option("--over", options->over, "key=value,value,...: each of the values (repeatable)").repeatable();
  sub.flag("--no-runs", options->no_runs, "predict only");
  sub.flag("--maps", options->maps, "the problem's maps, too, and of `bar` the table of safe steps");
  sub.option("--tier", options->tier, "how fine the maps are").one_of({"quick", "full"});
  add_run_options(sub, invocation.options);
  return {sub, [&invocation, options] { return execute(invocation, *options); }};
}

}  // namespace plumbline
