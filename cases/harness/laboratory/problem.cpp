#include "cases/harness/laboratory/problem.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "cases/harness/description/prose.hpp"
#include "cases/harness/files/errors.hpp"
#include "cases/harness/files/pool.hpp"
#include "cases/harness/laboratory/bar_patch.hpp"
#include "kernel/integrator_traits.hpp"
#include "kernel/transfers/transfer.hpp"

namespace plumbline {
namespace {

std::vector<const StabilityProblem*>& registered() {
  static std::vector<const StabilityProblem*> all;
  return all;
}

}  // namespace

std::vector<double> evenly_spaced(double low, double high, int count) {
  std::vector<double> all;
  for (int k = 0; k < count; ++k) all.push_back(low + (high - low) * k / (count - 1));
  return all;
}

const std::vector<const StabilityProblem*>& stability_problems() { return registered(); }

const StabilityProblem& find_stability_problem(const std::string& name) {
  std::vector<std::string> names;
  for (const StabilityProblem* problem : registered()) {
    if (problem->name() == name) return *problem;
    names.push_back(problem->name());
  }
  throw unknown_name("stability problem", name, names);
}

RegisterStabilityProblem::RegisterStabilityProblem(const StabilityProblem* entry) {
  auto& all = registered();
  const auto place = std::upper_bound(all.begin(), all.end(), entry,
                                      [](const auto* a, const auto* b) { return a->name() < b->name(); });
  all.insert(place, entry);
}

ProblemStatement StabilityProblem::statement() const {
  const Prose prose = written_prose(name());
  return {name(),
          prose.title(),
          prose.paragraphs("Source"),
          prose.paragraphs("Physics"),
          prose.code("Equations"),
          prose.paragraphs("Sampled")};
}

namespace {

bool is_of_integrators(const std::string& key) {
  if (key == "integrator") return true;
  for (const IntegratorEntry& entry : integrators()) {
    const auto integrator = entry.make();
    for (const IntegratorParameter& parameter : integrator->parameters()) {
      if (parameter.name == key) return true;
    }
  }
  return false;
}

}  // namespace

Settings stability_settings(const StabilityProblem& problem, const std::string& scheme,
                            const std::vector<Override>& overrides, const std::vector<std::string>& typed) {
  if (const auto known = scheme_names(); std::find(known.begin(), known.end(), scheme) == known.end()) {
    throw unknown_name("scheme", scheme, known);
  }
  const std::vector<std::string> of_runs{"cells", "cfl", "dt", "split", "points"};
  const auto is_of_runs = [&](const std::string& key) {
    if (key == "contact" && problem.kind() == Kind::solid && !problem.has_contact()) return true;
    return std::find(of_runs.begin(), of_runs.end(), key) != of_runs.end();
  };
  std::vector<Key> all;
  for (Key& key : kind_keys(problem.kind())) {
    if (problem.has_grid() ? !is_of_runs(key.name) : is_of_integrators(key.name)) all.push_back(std::move(key));
  }
  if (problem.has_grid()) {
    all.push_back({.name = "positions",
                   .value = "moving",
                   .choices = {"frozen", "moving"},
                   .description = "whether points are put back to where they were after each step"});
  }
  for (Key& key : problem.keys()) all.push_back(std::move(key));
  Settings settings(std::move(all));
  const std::string owner = "stability problem " + problem.name();
  for (const auto& [key, value] : scheme_choices(scheme, problem.kind())) {
    if (settings.has(key)) settings.set(key, value, owner);
  }
  for (const auto& [key, value] : problem.choices(scheme)) settings.set(key, value, owner);
  for (const auto& [key, value] : overrides) settings.set(key, value, owner);
  for (const std::string& assignment : typed) settings.set_text(assignment, owner);
  if (!problem.has_grid()) return settings;
  const IntegratorEntry* entry = find_integrator(settings.text("integrator"));
  refuse_lacks(*entry, settings);
  return settings;
}

Experiment experiment_of(const StabilityProblem& problem, const Settings& settings) {
  Experiment experiment;
  experiment.patch = [&problem, settings](const Extent& extent) { return problem.patch(settings, extent); };
  experiment.integrator = {settings.text("integrator"), integrator_parameters(settings)};
  experiment.positions = settings.text("positions") == "frozen" ? Positions::frozen : Positions::moving;
  return experiment;
}

Patch StabilityProblem::patch(const Settings&, const Extent&) const {
  throw std::logic_error("the stability problem " + name() + " has neither a patch nor a step of its own");
}

Prediction StabilityProblem::predicted(const Settings& settings, const Scan& scan, double width) const {
  return predict(experiment_of(*this, settings), scan, width);
}

Observation StabilityProblem::observed(const Settings& settings, int reach) const {
  return observe(experiment_of(*this, settings), scan(settings), watch(settings), reach);
}

Configuration examine(const StabilityProblem& problem, const std::string& scheme, const Settings& settings,
                      bool with_runs) {
  Configuration found{&problem,
                      scheme,
                      settings,
                      problem.unit(),
                      problem.scan(settings),
                      {},
                      {},
                      problem.closed_form(settings),
                      problem.statement().sampled};
  found.predicted = problem.predicted(settings, 1e-9);
  if (!with_runs) return found;
  found.observed = problem.observed(settings, found.predicted.reach);
  found.orders = problem.orders(settings);
  return found;
}

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

// At most the end of the scan; not a number where the step cannot be taken or has no derivative.
double limit_for_map(const StabilityProblem& problem, const Settings& settings) {
  try {
    return std::min(problem.predicted(settings, 1e-5).limit(), problem.scan(settings).high);
  } catch (const std::runtime_error&) {
    return none;
  }
}

void draw_limits(const StabilityProblem& problem, const MapPlan& plan, int threads, StabilityMap& map) {
  const std::size_t columns = plan.x.values.size(), rows = plan.y.values.size();
  map.values.assign(rows, std::vector<double>(columns, 0));
  map.closed_form.assign(rows, std::vector<double>(columns, none));
  for_all(columns * rows, threads, [&](std::size_t k) {
    const std::size_t i = k % columns, j = k / columns;
    std::vector<Override> overrides = plan.overrides;
    overrides.emplace_back(plan.x.key, plan.x.values[i]);
    overrides.emplace_back(plan.y.key, plan.y.values[j]);
    const Settings settings = stability_settings(problem, plan.scheme, overrides);
    map.values[j][i] = limit_for_map(problem, settings);
    if (const auto closed = problem.closed_form(settings)) map.closed_form[j][i] = closed->limit;
  });
  const auto has = [](const auto& row) { return std::any_of(row.begin(), row.end(), [](double v) { return v == v; }); };
  if (std::none_of(map.closed_form.begin(), map.closed_form.end(), has)) map.closed_form.clear();
  map.observed.resize(plan.observe.size());
  for_all(plan.observe.size(), threads, [&](std::size_t k) {
    const auto [x, y] = plan.observe[k];
    std::vector<Override> overrides = plan.overrides;
    overrides.emplace_back(plan.x.key, x);
    overrides.emplace_back(plan.y.key, y);
    const Settings settings = stability_settings(problem, plan.scheme, overrides);
    const Configuration here = examine(problem, plan.scheme, settings, true);
    const auto& brackets = here.observed->brackets;
    map.observed[k] = {x, y, brackets.empty() ? none : brackets.front().low,
                       brackets.empty() ? none : brackets.front().high};
  });
}

void draw_growth(const StabilityProblem& problem, const MapPlan& plan, int threads, StabilityMap& map) {
  const Settings settings = stability_settings(problem, plan.scheme, plan.overrides);
  const Experiment experiment = experiment_of(problem, settings);
  map.values.assign(plan.y.values.size(), {});
  for_all(plan.y.values.size(), threads, [&](std::size_t j) {
    try {
      map.values[j] = radii_over_waves(experiment, plan.y.values[j], plan.x.values);
    } catch (const std::runtime_error&) {
      map.values[j].assign(plan.x.values.size(), none);
    }
  });
  if (plan.observe.empty()) return;
  const Configuration seen = examine(problem, plan.scheme, settings, true);
  for (const Bracket& bracket : seen.observed->brackets)
    map.observed.push_back({none, none, bracket.low, bracket.high});
}

}  // namespace

StabilityMap draw_map(const StabilityProblem& problem, const MapPlan& plan, int threads) {
  StabilityMap map;
  map.plan = plan;
  map.unit = problem.unit();
  const Settings settings = stability_settings(problem, plan.scheme, plan.overrides);
  map.integrator = settings.text("integrator");
  map.shape = problem.has_grid() ? settings.text("shape") : "none";
  map.transfer = "none";
  if (problem.has_grid()) {
    map.transfer = transfer_in_words(settings.text("transfer"), static_cast<int>(settings.number("transfer_order")));
  }
  map.id = problem.name() + "/" + plan.scheme + "/" + map.integrator + "/" + map.shape + "/" + map.transfer + "/" +
           plan.kind + "-" + plan.x.key + "-" + plan.y.key + "/" + short_hash(settings.canonical()).substr(0, 6);
  if (plan.kind == "limit") draw_limits(problem, plan, threads, map);
  if (plan.kind == "growth") draw_growth(problem, plan, threads, map);
  return map;
}

std::vector<Override> Method::overrides() const {
  return {{"integrator", integrator}, {"shape", shape}, {"transfer", transfer}};
}

std::vector<Method> methods(const std::vector<std::string>& shapes, const std::vector<std::string>& transfers) {
  std::vector<Method> all;
  for (const IntegratorEntry& entry : integrators()) {
    for (const std::string& shape : shapes) {
      for (const std::string& transfer : transfers) {
        if (lacks(entry, shape, transfer).empty()) all.push_back({entry.name, shape, transfer});
      }
    }
  }
  return all;
}

std::vector<Method> explicit_methods(const std::vector<std::string>& shapes,
                                     const std::vector<std::string>& transfers) {
  std::vector<Method> all = methods(shapes, transfers);
  const auto far = [](const Method& method) {
    const MapChoice maps{method.shape, method.transfer, 2};
    const auto patch = [maps](const Extent& extent) { return bar_patch(maps, 1, 0.5, extent); };
    return reach_of_step({patch, {method.integrator, {}}, Positions::frozen}, 3) > far_reach;
  };
  all.erase(std::remove_if(all.begin(), all.end(), far), all.end());
  return all;
}

}  // namespace plumbline
