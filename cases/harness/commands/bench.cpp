#include <algorithm>
#include <map>
#include <thread>

#include "cases/harness/bench/bench_targets.hpp"
#include "cases/harness/commands/bench_cases.hpp"
#include "cases/harness/commands/bench_runs.hpp"
#include "cases/harness/commands/command.hpp"
#include "cases/harness/results/fingerprint.hpp"
#include "kernel/shapes/shape.hpp"

namespace plumbline {
namespace {

struct BenchOptions {
  double points = 1e7;  // no flow has more
  bool threads_given = false;
  bool of_cases = false;
  std::vector<std::string> patterns;
  int repeats = bench_repeats;
  std::string tier;  // none given: quick with --cases, full without
};

// Every geometry with every spline and the three transfers of one pass, under the default integrator, or York's where that refuses.
std::vector<BenchFlow> matrix(long points) {
  std::vector<BenchFlow> flows;
  for (const auto& [dimension, axisymmetric] : {std::pair{1, false}, {2, false}, {2, true}, {3, false}}) {
    for (const ShapeEntry& shape : shapes()) {
      if (shape.boxes || shape.at_start) continue;  // for solids
      for (const char* transfer : {"apic", "flip", "pic"}) {
        BenchFlow flow{dimension, axisymmetric, shape.name, transfer, "leapfrog", points};
        if (!flow.is_possible()) flow.integrator = "musl";
        flows.push_back(flow);
      }
    }
  }
  return flows;
}

std::vector<BenchFlow> scale(long most) {
  std::vector<BenchFlow> flows;
  for (long points = 1000; points <= most; points *= 10) flows.push_back({.points = points});
  return flows;
}

const std::vector<TimedRun>& standard_runs() {
  static const std::vector<TimedRun> runs{{"gas, 1-D, 1600 cells", "sod", "default", 1600, 1e7, false},
                                          {"York's gas, 1-D, 800 cells", "sod", "york1997", 800, 1e7, false},
                                          {"York's spring, ten points", "spring-mass", "york1997", 10, 0.1, true}};
  return runs;
}

Tier tier_from(const std::string& name) {
  if (name == "quick") return Tier::quick;
  if (name == "full") return Tier::full;
  throw unknown_name("--tier", name, {"quick", "full"});
}

class Bench {
 public:
  Bench(const Invocation& invocation, const BenchOptions& options)
      : common_(invocation.options),
        out_(invocation.options),
        most_(static_cast<long>(options.points)),
        full_(options.tier.empty() || tier_from(options.tier) == Tier::full) {
    const int cores = static_cast<int>(std::thread::hardware_concurrency());
    const int more = options.threads_given ? common_.threads : std::min(2, cores);
    if (more > 1) threads_.push_back(more);
  }

  void measure_standard() {
    head("Targets: 2-D, quadratic B-splines, APIC, 16 points per cell");
    for (const char* integrator : {"leapfrog", "energy"}) {
      measure("target", {.integrator = integrator, .points = std::min(most_, 1000000L)});
    }
    head("Scale: the same under the default integrator, by number of points");
    for (const BenchFlow& flow : scale(most_)) measure("scale", flow);
    if (full_) {
      head("Dimension, shape, transfer");
      for (const BenchFlow& flow : matrix(matrix_points())) measure("matrix", flow);
    }
    head("Whole runs");
    for (const TimedRun& run : standard_runs()) measure(run);
    for (const TimedChoice& choice : choices()) measure(choice);
    for (Json& target : scale_targets(kernels_)) targets_.push_back(std::move(target));
  }

  // The choices that were asked for, on the 1-D tube; an integrator also in the plane.
  void measure_chosen() {
    for (const SchemeChoice& choice : chosen_schemes(common_)) {
      const std::string with = choice.overrides.empty() ? "" : " with " + to_text(choice.overrides.front().second);
      measure({"gas, 1-D, " + choice.scheme + with, "sod", choice.scheme, 800, 1e7, false, choice.overrides});
    }
    for (const std::string& integrator : common_.integrators) {
      for (BenchFlow flow : matrix(matrix_points())) {
        flow.integrator = integrator;
        if (flow.dimension == 2 && !flow.axisymmetric && flow.is_possible()) measure("matrix", flow);
      }
    }
  }

  Json document(const Provenance& provenance) {
    out_.line("\nTargets");
    for (const Json& t : targets_) {
      out_.line("  {:72} {:.4g} {}, {} {:.4g}: {}", t["name"].get<std::string>(), t["measured"].get<double>(),
                t["unit"].get<std::string>(), t["low"].is_null() ? "at most" : "at least",
                (t["low"].is_null() ? t["high"] : t["low"]).get<double>(), t["met"].get<bool>() ? "met" : "MISSED");
    }
    const double empty = time_empty_step();
    out_.line("Empty step (one point): {:.0f} ns, ledger included", 1e9 * empty);
    return {{"machine", limits_.document()},
            {"kernels", kernels_},
            {"targets", targets_},
            {"empty_step", {{"seconds_per_step", empty}}},
            {"provenance", to_json(provenance)}};
  }

 private:
  long matrix_points() const { return std::clamp(most_ / 10, 1000L, 200000L); }  // many flows: smaller than the largest

  void head(const std::string& title) {
    out_.line("\n{}\n  {:38} {:>9} {:>7} {:>9} {:>17} {:>7} {:>7} {:>7} {:>9} {:>9} {:>8}", title, "", "points",
              "threads", "M steps/s", "least ... most", "B moved", "flops", "B held", "of memory", "of flops", "drift");
  }

  void measure(const std::string& part, const BenchFlow& flow) {
    for (const StepTiming& timing : timed(flow)) {
      kernels_.push_back(kernel_entry(part, flow, timing, limits_));
      const Json& k = kernels_.back();
      const auto text = [&](const char* key, double factor, int digits) {
        return k[key].is_null() ? std::string("-") : fmt::format("{:.{}f}", factor * k[key].get<double>(), digits);
      };
      out_.line("  {:38} {:>9} {:>7} {:>9} {:>17} {:>7} {:>7} {:>7} {:>9} {:>9} {:>8.0e}", flow.name(), timing.points,
                timing.threads, text("particle_steps_per_s", 1e-6, 2),
                text("slowest", 1e-6, 2) + " ... " + text("fastest", 1e-6, 2), text("bytes_per_point", 1, 0),
                text("flops_per_point", 1, 0), text("memory_bytes_per_point", 1, 0), text("bandwidth_fraction", 1, 2),
                text("flop_fraction", 1, 2), timing.energy_drift);
      if (part != "target" || timing.threads > 2 || timing.points < 900000) continue;
      const double rate = k["particle_steps_per_s"].get<double>(), least = timing.threads == 1 ? 45e6 : 80e6;
      targets_.push_back(
          target_entry(fmt::format("{}, {:.0e} points, {} thread{}", flow.name(), static_cast<double>(timing.points),
                                   timing.threads, timing.threads == 1 ? "" : "s"),
                       "particle-steps/s", rate, least, {}));
    }
  }

  // Each flow is timed once, though it may belong to several parts.
  const std::vector<StepTiming>& timed(const BenchFlow& flow) {
    std::vector<StepTiming>& known = timings_[fmt::format("{}, {} points", flow.name(), flow.points)];
    if (known.empty()) known = time_flow(flow, threads_);
    return known;
  }

  void measure(const TimedRun& run) {
    auto [kernel, target] = time_run(run, common_.settings, full_ ? bench_repeats : 3);
    add(run, std::move(kernel));
    targets_.push_back(std::move(target));
  }

  // A run with two values of a setting: what a particle-step with the second costs over one with the first.
  struct TimedChoice {
    const char *title, *case_name, *key, *first, *second;
    int cells;
    Override length;
    const char* target;
    double most;
  };
  static const std::vector<TimedChoice>& choices() {
    static const std::vector<TimedChoice> all{
        {"membrane in space",
         "breathing-sphere",
         "tangents",
         "carried",
         "neighbours",
         8,
         {"periods", 1.0},
         "cost of a membrane's particle-step with neighbours over that with carried tangents",
         1.5},
        {"solid in the plane",
         "spinning-disk",
         "shape",
         "gimp",
         "cpdi",
         16,
         {"turns", 0.1},
         "cost of a solid's particle-step with domains over that with boxes",
         1.5}};
    return all;
  }
  void measure(const TimedChoice& choice) {
    double rate[2];
    const char* const values[] = {choice.first, choice.second};
    for (std::size_t k = 0; k < 2; ++k) {
      const TimedRun run{
          fmt::format("{}, {}", choice.title, values[k]), choice.case_name, "default", choice.cells, 0, false,
          {{choice.key, values[k]}, choice.length}};
      Json kernel = time_run(run, common_.settings, full_ ? bench_repeats : 3).first;
      rate[k] = kernel["particle_steps_per_s"].get<double>();
      add(run, std::move(kernel));
    }
    targets_.push_back(target_entry(choice.target, "1", rate[0] / rate[1], {}, choice.most));
  }

  void add(const TimedRun& run, Json kernel) {
    out_.line("  {:38} {:>9} {:>7} {:>9.2f}   {} steps in {:.4g} s", run.name, kernel["points"].get<long>(), 1,
              1e-6 * kernel["particle_steps_per_s"].get<double>(), kernel["steps"].get<long>(),
              kernel["wall_s"].get<double>());
    kernels_.push_back(std::move(kernel));
  }

  const CommonOptions& common_;
  Output out_;
  long most_;
  bool full_;
  std::vector<int> threads_{1};
  MachineLimits limits_;
  std::map<std::string, std::vector<StepTiming>> timings_;
  Json kernels_ = Json::array(), targets_ = Json::array();
};

// Median, and how far the repeats lie apart, of every run with a time.
void print_costs(const Output& out, const Json& runs) {
  out.line("{:20} {:28} {:22} {:>8} {:>12} {:>10} {:>22} {:>3}", "case", "scheme", "study", "value", "particle-steps",
           "s", "least ... most", "of");
  for (const Json& run : runs) {
    auto times = run["wall_s"].get<std::vector<double>>();
    std::sort(times.begin(), times.end());
    out.line("{:20} {:28} {:22} {:>8} {:>12} {:>10.4g} {:>22} {:>3}{}", run["case"].get<std::string>(),
             run["scheme"].get<std::string>(), run["study"].get<std::string>(), run["value"].get<double>(),
             run["particle_steps"].get<long>(), times[times.size() / 2],
             fmt::format("{:.4g} ... {:.4g}", times.front(), times.back()), times.size(),
             run["source"] == "stored" ? ", stored" : "");
  }
}

// What accuracy costs: --cases.
int execute_cases(const Invocation& invocation, const BenchOptions& options) {
  const CommonOptions& common = invocation.options;
  if (!common.schemes.empty() || !common.integrators.empty() || !common.settings.empty() || options.threads_given) {
    throw UsageError("--cases", "with --scheme, --integrator, --set or --threads", "--cases alone", {},
                     "--cases times the studies as the cases declare them, on one thread: it goes with none of "
                     "--scheme, --integrator, --set and --threads");
  }
  const std::string tier_name = options.tier.empty() ? "quick" : options.tier;
  const Tier tier = tier_from(tier_name);
  std::vector<CostRun> runs;
  for (const Case* entry : matching_cases(options.patterns)) {
    for (CostRun& run : cost_runs(*entry, tier)) runs.push_back(std::move(run));
  }
  const auto samples = time_cost_runs(runs, options.repeats, cost_budget(tier), common.results);
  Json entries = Json::array();
  Json left_out = Json::array();
  for (std::size_t k = 0; k < runs.size(); ++k) {
    Json entry = cost_entry(runs[k], samples[k]);
    if (samples[k].document.is_null()) left_out.push_back(cost_run_name(runs[k]));
    if (!entry.is_null()) entries.push_back(std::move(entry));
  }
  const Output out(common);
  print_costs(out, entries);
  if (!left_out.empty()) {
    out.line("{} longer runs are left out: neither in the time of the {} tier, nor stored in {}", left_out.size(),
             tier_name, common.results);
  }
  const std::string code = code_fingerprint();
  write_json(common, {{"machine", MachineLimits().document()},
                      {"fingerprint", code.empty() ? Json(nullptr) : Json(code)},
                      {"tier", tier_name},
                      {"repeats", options.repeats},
                      {"runs", std::move(entries)},
                      {"left_out", std::move(left_out)},
                      {"provenance", to_json(invocation.provenance())}});
  return 0;
}

int execute(const Invocation& invocation, const BenchOptions& options) {
  const CommonOptions& common = invocation.options;
  if (options.of_cases) return execute_cases(invocation, options);
  if (!options.patterns.empty()) {
    throw UsageError("pattern", options.patterns.front(), "a pattern after --cases", {"--cases"},
                     fmt::format("'{}': cases are timed with --cases only", options.patterns.front()));
  }
  const bool chosen = !common.schemes.empty() || !common.integrators.empty() || !common.settings.empty();
  for (const SchemeChoice& choice : chosen_schemes(common))  // a wrong name must not cost time
    find_case("sod").settings(choice.scheme, choice.overrides, common.settings);
  Bench bench(invocation, options);
  try {
    if (chosen) {
      bench.measure_chosen();
    } else {
      bench.measure_standard();
    }
  } catch (const InadmissibleState& state) {
    print_text(stderr, fmt::format("plumbline: stopped at step {}: {}\n", state.step, state.what()));
    return exit_stopped;
  }
  write_json(common, bench.document(invocation.provenance()));
  return 0;
}

}  // namespace

Command add_bench(const Arguments& program, Invocation& invocation) {
  const Arguments sub = program.command(
      "bench", "speed of the production kernel through the production step",
      "Example: plumbline bench --points 1e6 --json bench.json\n         plumbline bench --cases 'sod*' --json "
      "cost.json\n"
      "Times are of one thread and of two, or of --threads. "
      "With "
      "--scheme, --integrator or --set: of these choices alone, on a small flow.");
  auto options = std::make_shared<BenchOptions>();
  sub.option("--points", options->points, "largest number of points; 1e7 takes some minutes and 5 GB")
      .number_within(1e3, 1e8);
  sub.flag("--cases", options->of_cases,
           "time the refinement studies of the cases instead: error against cost, on one thread, interleaved");
  sub.option("pattern", options->patterns, "with --cases: case names or patterns; all cases if none");
  sub.option("--repeats", options->repeats, "with --cases: samples of a short run; a long one has fewer")
      .whole_number(1, 100);
  sub.option("--tier", options->tier,
             "quick: without the table of dimensions, shapes and transfers; of --cases, half a "
             "minute in all. If not given: full; of --cases, quick");
  add_run_options(sub, invocation.options);
  return {sub, [&invocation, options, sub] {
            options->threads_given = sub.given("--threads");
            return execute(invocation, *options);
          }};
}

}  // namespace plumbline
