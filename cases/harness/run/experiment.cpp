#include "cases/harness/run/experiment.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "cases/harness/description/cannot_run.hpp"
#include "cases/harness/files/errors.hpp"
#include "cases/harness/files/signals.hpp"
#include "cases/harness/run/budget.hpp"
#include "cases/harness/run/guarded_integrator.hpp"
#include "cases/harness/run/simulation_state.hpp"
#include "kernel/inadmissible.hpp"

namespace plumbline {
namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Keeps every k-th step's row, with k doubled whenever twice the allowed number has gathered, the extreme row and the
// last one. The step that stopped a run has no row: its ledger may be half booked.
class LedgerRecorder {
 public:
  LedgerRecorder(int dim, bool axisymmetric) : dim_(dim), axisymmetric_(axisymmetric) {}

  void record(const Simulation& simulation) {
    const Ledger& ledger = simulation.ledger();
    if (simulation.steps() % stride_ == 0) {
      rows_.push_back(row(simulation));
      if (rows_.size() >= 2 * most_rows) thin();
    }
    if (ledger.energy.largest_residual() != extreme_) {
      extreme_ = ledger.energy.largest_residual();
      extreme_row_ = row(simulation);
    }
    last_step_ = simulation.steps();
  }

  void history(Archive& archive) {
    archive("stride", stride_);
    archive("last_step", last_step_);
    archive("extreme", extreme_);
    archive("extreme_row", extreme_row_);
    archive("rows", rows_);
    const std::size_t width = 2 + columns().size();
    const auto fits = [&](const std::vector<double>& row) { return row.size() == width; };
    if (!std::all_of(rows_.begin(), rows_.end(), fits) || !(extreme_row_.empty() || fits(extreme_row_)))
      throw ArchiveError("rows of the ledger are not as long as the ledger has accounts");
  }

  LedgerHistory history(const Simulation& simulation) {
    while (rows_.size() > most_rows) thin();
    if (simulation.steps() == last_step_ && last_step_ % stride_ != 0) rows_.push_back(row(simulation));
    if (!extreme_row_.empty()) rows_.push_back(extreme_row_);
    std::sort(rows_.begin(), rows_.end());
    const auto same_step = [](const auto& a, const auto& b) { return a[0] == b[0]; };
    rows_.erase(std::unique(rows_.begin(), rows_.end(), same_step), rows_.end());
    LedgerHistory history;
    const auto names = columns();
    for (const auto& [quantity, column] : names) history.series.push_back({quantity, column, {}});
    for (const auto& r : rows_) {
      history.step.push_back(r[0]);
      history.time.push_back(r[1]);
      for (std::size_t k = 0; k < names.size(); ++k) history.series[k].values.push_back(r[k + 2]);
    }
    return history;
  }

 private:
  static constexpr std::size_t most_rows = 1998;  // and two more: the extreme and the last

  void thin() {
    stride_ *= 2;
    std::vector<std::vector<double>> kept;
    for (auto& r : rows_) {
      if (static_cast<long>(r[0]) % stride_ == 0) kept.push_back(std::move(r));
    }
    rows_ = std::move(kept);
  }

  std::vector<std::pair<std::string, std::string>> columns() const {
    std::vector<std::pair<std::string, std::string>> names;
    for (const auto& [quantity, account] : Ledger{}.accounts(dim_, axisymmetric_)) {
      names.push_back({quantity, "store"});
      for (const std::string_view flow : flow_names) names.push_back({quantity, std::string(flow)});
      names.push_back({quantity, "residual"});
    }
    for (const char* store : {"kinetic", "internal", "elastic", "viscous"}) names.push_back({"energy", store});
    return names;
  }

  std::vector<double> row(const Simulation& simulation) const {
    const Ledger& ledger = simulation.ledger();
    std::vector<double> values{static_cast<double>(simulation.steps()), simulation.time()};
    for (const auto& [quantity, account] : ledger.accounts(dim_, axisymmetric_)) {
      values.push_back(account->store());
      for (int f = 0; f < flow_count; ++f) values.push_back(account->flow(static_cast<Flow>(f)));
      values.push_back(account->residual());
    }
    const EnergyStores& stores = ledger.stores;
    values.insert(values.end(), {stores.kinetic, stores.internal, stores.elastic, ledger.viscous});
    return values;
  }

  int dim_;
  bool axisymmetric_;
  long stride_ = 1, last_step_ = 0;
  double extreme_ = 0;
  std::vector<double> extreme_row_;
  std::vector<std::vector<double>> rows_;
};

// Ends a run whose step falls until the run would never come to its end, as that of a gas does which an unstable step heats:
// many times the steps that it has taken and those that its first step was to lead to are still to come.
class StepWatch {
 public:
  StepWatch(double end_time, const Settings& settings) : end_(end_time), settings_(settings) {}

  // Throws InadmissibleState; UsageError after a first step of which the run would need more than it may take. `now`: after
  // one step at least.
  void look(const Simulation& now) {
    const double dt = now.last_dt(), steps = static_cast<double>(now.steps());
    if (first_estimate_ == 0) {
      first_estimate_ = end_ / dt;
      require_steps(end_, dt, settings_);
    }
    const double left = (end_ - now.time()) / dt;
    if (left <= few + many * (steps + first_estimate_)) return;
    InadmissibleState stop("the step has become so short that the end will not be reached", "all", 0, "dt", dt);
    stop.step = now.steps();
    stop.time = now.time();
    throw stop;
  }

  void history(Archive& archive) { archive("first_estimate", first_estimate_); }

 private:
  static constexpr double few = 1e5, many = 1000;  // ends no run of the quick tier
  double end_, first_estimate_ = 0;
  const Settings& settings_;
};

// Gives what a run consists of the state that was kept; `history` names all of it.
template <class History>
void take_up(const RunState& state, const History& history) {
  Archive archive(state.numbers);
  history(archive);
  archive.require_all_read();
}

}  // namespace

const Measure* RunResult::find(const std::string& measure) const {
  for (const Measure& m : measures) {
    if (m.name == measure) return &m;
  }
  return nullptr;
}

StepControl step_control(const Settings& settings) {
  StepControl control;
  if (settings.is_set("dt")) {
    control.dt = settings.number("dt");
  } else {
    control.cfl = settings.number("cfl");
  }
  control.parameters = integrator_parameters(settings);
  return control;
}

namespace {

RunResult make_trial(const Case& entry, const std::string& scheme, const Settings& settings) {
  RunResult result(entry.name, scheme, settings);
  result.dim = 0;
  const auto start = std::chrono::steady_clock::now();
  Findings found = entry.trial(settings).find();
  result.wall_s = seconds_since(start);
  result.measures = std::move(found.measures);
  result.profile = std::move(found.profile);
  result.finished = true;
  return result;
}

}  // namespace

RunResult run_experiment(const Case& entry, const std::string& scheme, const Settings& settings, int threads,
                         const FrameRequest& frames, const RunStates& states) {
  if (!entry.trials.empty()) return make_trial(entry, scheme, settings);
  require_memory(foreseen_size(entry, settings), settings);  // a problem may fill its bodies as soon as it is made
  const auto problem = entry.problem(settings);
  require_end(problem->end_time());
  if (settings.is_set("dt")) require_steps(problem->end_time(), settings.number("dt"), settings);
  Scene scene = problem->scene();
  throw_if_interrupted();
  require_memory(size_of(scene), settings);
  RunResult result(entry.name, scheme, settings);
  result.dim = scene.grid.dim;
  result.axisymmetric = scene.grid.axisymmetric;
  result.h = scene.grid.h;
  result.end_time = problem->end_time();
  try {
    StepControl control = step_control(settings);
    control.threads = threads;
    Simulation simulation(std::move(scene), settings.text("integrator"), control);
    result.courant = control.dt ? *control.dt / simulation.step_limit() : control.cfl;
    LedgerRecorder recorder(result.dim, result.axisymmetric);
    FrameRecorder pictures(frames, simulation.scene(), result.end_time);
    pictures.look(simulation);
    StepWatch steps(result.end_time, settings);
    const auto history = [&](Archive& archive) {
      archive_simulation(archive, simulation, settings.text("integrator"));
      archive("ledger_rows", recorder);
      archive("frames", pictures);
      archive("step_watch", steps);
      archive("problem", *problem);
    };
    if (states.from) take_up(*states.from, history);
    double looking_s = states.from ? -states.from->wall_s : 0;
    const auto start = std::chrono::steady_clock::now();
    const auto stepping_s = [&] { return seconds_since(start) - looking_s; };
    const auto offer_state = [&] {
      if (!states.wanted || !states.wanted(simulation)) return;
      const auto before = std::chrono::steady_clock::now();
      const double wall_s = stepping_s();
      Archive archive;
      history(archive);
      states.keep({simulation.steps(), simulation.time(), wall_s, archive.take()});
      looking_s += seconds_since(before);
    };
    const auto finish = [&] {
      result.wall_s = stepping_s();
      result.steps = simulation.steps();
      result.points = simulation.points();
      result.doubles_per_point = simulation.scene().bodies.front().points.doubles_per_point();
      result.dt = result.steps > 0 ? simulation.time() / static_cast<double>(result.steps) : 0;
      result.ledger = simulation.ledger();
      result.history = recorder.history(simulation);
      result.frames = pictures.take();
    };
    const auto look = [&](const Simulation& now) {
      if (frames.count == 0) return;
      const auto before = std::chrono::steady_clock::now();
      pictures.look(now);
      looking_s += seconds_since(before);
    };
    try {
      offer_state();
      simulation.run_until(result.end_time, [&](const Simulation& now) {
        steps.look(now);
        problem->observe(now);
        recorder.record(now);
        throw_if_interrupted();
        look(now);
        offer_state();
      });
      finish();
    } catch (const InadmissibleState&) {
      finish();
      throw;
    } catch (const MisbehavingIntegrator&) {
      finish();
      throw;
    }
    simulation.refresh_density();
    result.measures = problem->measures(simulation);
    result.profile = problem->profile(simulation);
    throw_if_interrupted();  // one that came while they were worked out is not lost
    result.finished = true;
  } catch (const CannotWork& parts) {
    throw cannot_run(entry, settings, parts);
  } catch (const InadmissibleState& state) {
    result.stop = Stop{state.reason, state.body, state.field, state.step, state.time, state.point, state.value};
  } catch (const MisbehavingIntegrator& error) {
    if (error.step == 0) throw;
    result.stop = Stop{error.reason, "all", misbehaviour_field, error.step, error.time, 0, std::nan("")};
  }
  return result;
}

}  // namespace plumbline
