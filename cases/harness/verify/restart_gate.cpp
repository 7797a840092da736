#include "cases/harness/verify/restart_gate.hpp"

#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <map>

#include "cases/harness/files/scratch_folder.hpp"
#include "cases/harness/results/checkpoint_file.hpp"
#include "cases/harness/results/fingerprint.hpp"

namespace plumbline {
namespace {

// All that came of a run but for the time that it took.
Archive::Table numbers_of(RunResult& run) {
  Archive archive;
  const auto whole = [](bool value) { return value ? 1.0 : 0.0; };
  std::array<double, 6> counts{whole(run.finished),
                               static_cast<double>(run.steps),
                               static_cast<double>(run.points),
                               static_cast<double>(run.doubles_per_point),
                               run.dt,
                               run.end_time};
  archive("run", counts);
  if (run.stop) {
    std::array<double, 4> stop{static_cast<double>(run.stop->step), run.stop->time,
                               static_cast<double>(run.stop->point), run.stop->value};
    archive("stop/" + run.stop->field, stop);
  }
  archive("rows/step", run.history.step);
  archive("rows/time", run.history.time);
  for (auto& series : run.history.series) archive("rows/" + series.quantity + "/" + series.column, series.values);
  for (const Measure& m : run.measures) {
    std::array<double, 5> values{m.error, m.scale, m.value.value_or(0), m.reference.value_or(0), m.reference_bound};
    archive("measures/" + m.name, values);
  }
  for (ProfileColumn& column : run.profile.columns) archive("profile/" + column.name, column.values);
  return archive.take();
}

struct Ended {
  Archive::Table result, state;  // what came of it; the run's state after its last step
};

void compare(const Archive::Table& one, const Archive::Table& other, RestartDifference& difference) {
  std::map<std::string, std::pair<const std::vector<double>*, const std::vector<double>*>> all;
  for (const auto& [name, values] : one) all[name].first = &values;
  for (const auto& [name, values] : other) all[name].second = &values;
  for (const auto& [name, both] : all) {
    const std::vector<double> none, &a = both.first ? *both.first : none, &b = both.second ? *both.second : none;
    const std::size_t most = std::max(a.size(), b.size());
    long differ = both.first && both.second ? 0 : 1;
    if (a.size() != b.size()) differ = static_cast<long>(most);
    for (std::size_t k = 0; a.size() == b.size() && k < most; ++k) {
      differ += std::bit_cast<std::uint64_t>(a[k]) != std::bit_cast<std::uint64_t>(b[k]);
    }
    difference.compared += static_cast<long>(most);
    difference.numbers += differ;
    if (differ > 0 && difference.first.empty()) difference.first = name;
  }
}

}  // namespace

RestartDifference restart_difference(const Case& entry, const std::string& scheme, const Settings& settings,
                                     double share) {
  const ScratchFolder folder;
  const std::string file = folder / "restart.h5";
  const double end = entry.problem(settings)->end_time();
  const auto reached = [end](double time, double part) { return time >= part * end - 1e-12 * end; };
  const auto run = [&](const RunState* from, bool write) {
    Ended ended;
    bool written = !write;
    RunStates states;
    states.from = from;
    states.wanted = [&](const Simulation& now) {
      return (!written && reached(now.time(), share)) || reached(now.time(), 1);
    };
    states.keep = [&](const RunState& state) {
      if (!written) {
        write_checkpoint(
            file, {entry.name, scheme, settings.canonical(), fingerprint(entry), build_in_words(), {}, 0, state});
        written = true;
      }
      if (reached(state.time, 1)) ended.state = state.numbers;
    };
    RunResult result = run_experiment(entry, scheme, settings, 1, {}, states);
    ended.result = numbers_of(result);
    return ended;
  };
  const Ended whole = run(nullptr, true);
  if (!std::filesystem::exists(file)) return {};
  const CheckpointFile checkpoint = read_checkpoint(file);
  require_same_code(checkpoint, file);
  RestartDifference difference;
  if (!(settings_of(checkpoint, file) == settings)) return {1, 1, "settings"};
  const Ended resumed = run(&checkpoint.state, false);
  compare(whole.state, resumed.state, difference);
  compare(whole.result, resumed.result, difference);
  return difference;
}

CaseGate restart_gate(const std::string& study, const std::string& what, std::vector<Override> overrides,
                      const std::string& suffix) {
  const auto differing = [overrides = std::move(overrides)](const StudyResult& s) {
    if (s.levels.empty() || s.levels.front().run.steps == 0)
      throw std::runtime_error("there are no steps to be taken up again");
    Settings settings = s.levels.front().run.settings;
    for (const auto& [key, value] : overrides) settings.set(key, value, s.entry->name);
    const RestartDifference difference = restart_difference(*s.entry, s.plan.scheme, settings, 0.5);
    if (difference.compared == 0) {
      throw std::runtime_error("the run ended before the half of its time: there is nothing to be taken up again");
    }
    Measured measured = Measured::of(static_cast<double>(difference.numbers));
    measured.note = difference.first.empty()
                        ? fmt::format("{} numbers compared", difference.compared)
                        : fmt::format("of {}, the first in {}", difference.compared, difference.first);
    return measured;
  };
  return gate(study + "/restart" + suffix, number_of("numbers that a restart changes", differing), exactly(0),
              identity("a run is a function of its state: stopped half-way, written to a file and taken up again, " +
                       what + " end with the same bits"));
}

}  // namespace plumbline
