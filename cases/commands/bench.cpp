#include <algorithm>
#include <chrono>

#include "cases/commands/command.hpp"
#include "kernel/materials/uniaxial_membrane.hpp"

namespace plumbline {
namespace {

double seconds(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

// Bytes per second of copying arrays that do not fit the caches: the machine's limit for streaming over columns.
double copy_rate() {
  const std::size_t n = 16u << 20;
  std::vector<double> from(n, 1.0), to(n, 0.0);
  std::vector<double> times;
  for (int k = 0; k < 5; ++k) times.push_back(seconds([&] { std::copy(from.begin(), from.end(), to.begin()); }));
  return 2.0 * 8.0 * static_cast<double>(n) / median(times);
}

struct Entry {
  std::string name, case_name, scheme;
  int cells;
  double target;  // point-steps per second, or seconds where target_is_time
  bool target_is_time;
  int passes;  // sweeps over the points in one step, for the traffic
  std::vector<Override> overrides = {};
};

Json bench_entry(const Entry& at, const std::vector<std::string>& typed, double bytes_per_s, const Output& out) {
  const Case& entry = find_case(at.case_name);
  std::vector<Override> overrides = at.overrides;
  overrides.emplace_back("cells", static_cast<double>(at.cells));
  const Settings settings = entry.settings(at.scheme, overrides, typed);
  std::vector<RunResult> runs;
  std::vector<double> times;
  for (int k = 0; k < 5; ++k) {
    runs.push_back(run_experiment(entry, at.scheme, settings));
    times.push_back(runs.back().wall_s);
  }
  const RunResult& run = runs.front();
  const double time = median(times), rate = static_cast<double>(run.points) * static_cast<double>(run.steps) / time;
  const double bytes = 8.0 * run.doubles_per_point;
  const double traffic = rate * bytes * at.passes / bytes_per_s;
  const bool met = at.target_is_time ? time <= at.target : rate >= at.target;
  out.line(
      "{:28} {:8} points {:6} steps  median {:.4g} s  {:.3g} point-steps/s  {:.2g} of copy bandwidth  target {} "
      "{:.3g}{}: {}",
      at.name, run.points, run.steps, time, rate, traffic, at.target_is_time ? "at most" : "at least", at.target,
      at.target_is_time ? " s" : "", met ? "met" : "MISSED");
  return {{"name", at.name},
          {"dimension", run.dim},
          {"material", name(entry.kind())},
          {"shape", settings.text("shape")},
          {"transfer", settings.text("transfer")},
          {"integrator", settings.text("integrator")},
          {"points", run.points},
          {"ppc", settings.number("ppc")},
          {"threads", 1},
          {"steps", run.steps},
          {"wall_s", time},
          {"point_steps_per_s", rate},
          {"bytes_per_point", bytes},
          {"flops_per_point", nullptr},
          {"fraction_of_limit", traffic},
          {"energy_drift", run.ledger.energy.relative_drift(false)},
          {"target", at.target},
          {"met", met}};
}

// A scene of one point: what a step costs beside its points.
Json empty_step(const Output& out) {
  Scene scene;
  scene.grid.cells[0] = 4;
  scene.shape = "linear";
  scene.transfer = "flip";
  auto membrane = std::make_shared<UniaxialMembrane>();
  membrane->youngs_modulus = membrane->density = 1;
  Body body = make_body("point", membrane, 1, 1);
  body.points(column::position)[0] = 2.0;
  body.points(column::mass)[0] = body.points(column::volume)[0] = 1.0;
  scene.bodies.push_back(body);
  StepControl control;
  control.dt = 1e-3;
  Simulation simulation(scene, "musl", control);
  constexpr int steps = 200000;
  const double time = seconds([&] {
    for (int k = 0; k < steps; ++k) simulation.step(1.0);
  });
  out.line("{:28} {:.0f} ns a step, ledger included", "empty step (one point)", 1e9 * time / steps);
  return {{"seconds_per_step", time / steps}};
}

int execute(const Invocation& invocation) {
  const Output out(invocation.options);
  const double bytes_per_s = copy_rate();
  const Provenance p = build_provenance();
  out.line("{}, {}, copy {:.3g} GB/s", p.cpu, p.instruction_set, bytes_per_s / 1e9);
  Json document{{"machine",
                 {{"cpu", p.cpu},
                  {"instruction_set", p.instruction_set},
                  {"compiler", p.compiler},
                  {"flags", p.flags},
                  {"copy_bytes_per_s", bytes_per_s}}},
                {"kernels", Json::array()}};
  std::vector<Entry> entries{{"gas, 1-D, 1600 cells", "sod", "default", 1600, 1e7, false, 11},
                             {"York's gas, 1-D, 800 cells", "sod", "york1997", 800, 1e7, false, 10},
                             {"York's spring, ten points", "spring-mass", "york1997", 10, 0.1, true, 9}};
  const CommonOptions& common = invocation.options;
  if (!common.schemes.empty() || !common.integrators.empty()) {
    entries.clear();
    for (const SchemeChoice& choice : chosen_schemes(common)) {
      const std::string integrator = choice.overrides.empty() ? ""
                                                              : " with " + to_text(choice.overrides.front().second);
      entries.push_back(
          {"gas, 1-D, " + choice.scheme + integrator, "sod", choice.scheme, 800, 1e7, false, 10, choice.overrides});
    }
  }
  for (const Entry& entry : entries)
    document["kernels"].push_back(bench_entry(entry, common.settings, bytes_per_s, out));
  document["empty_step"] = empty_step(out);
  write_json(invocation.options, document);
  return 0;
}

}  // namespace

Command add_bench(CLI::App& app, Invocation& invocation) {
  CLI::App* sub = app.add_subcommand("bench", "speed of the production kernel through the production step");
  sub->footer("Example: plumbline bench --json bench.json");
  add_run_options(*sub, invocation.options);
  return {sub, [&invocation] { return execute(invocation); }};
}

}  // namespace plumbline
