#include "cases/catalog/stability/trial_case.hpp"

#include "cases/harness/laboratory/bar_patch.hpp"

namespace plumbline {
namespace {

class TrialProblem final : public Problem {
 public:
  TrialProblem(const Settings& settings, Trial trial) : settings_(settings), trial_(std::move(trial)) {}

  Scene scene() const override {
    Scene scene = bar_patch({}, 1, 0.5, {settings_.integer("cells"), 0}).scene;
    apply_choices(settings_, scene);
    return scene;
  }
  double end_time() const override { return 1e-3; }
  std::vector<Measure> measures(const Simulation&) const override { return found().measures; }
  Profile profile(const Simulation&) const override { return found().profile; }

 private:
  const Findings& found() const {
    if (!found_) found_ = trial_.find();
    return *found_;
  }

  Settings settings_;
  Trial trial_;
  mutable std::optional<Findings> found_;
};

}  // namespace

std::vector<Key> TrialCase::keys() const {
  std::vector<std::string> names;
  for (const Trial& trial : trials()) names.push_back(trial.name);
  return {{.name = "trial", .value = names.front(), .choices = names, .description = "what the laboratory looks at"}};
}

std::vector<Override> TrialCase::points_and_end(const std::string&) const { return {{"cells", trial_level}}; }

void TrialCase::derive(Settings& settings, const std::string& scheme) const {
  if (scheme == "york1997" && !settings.is_set("dt") && !settings.is_set("cfl")) {
    settings.set("cfl", 0.5, "york1997");
  }
}

std::unique_ptr<Problem> TrialCase::problem(const Settings& settings) const {
  for (Trial& trial : trials()) {
    if (trial.name == settings.text("trial")) return std::make_unique<TrialProblem>(settings, std::move(trial));
  }
  return nullptr;
}

std::vector<StudyPlan> TrialCase::studies() const {
  std::vector<StudyPlan> all;
  for (const Trial& trial : trials()) {
    all.push_back({.id = trial.name,
                   .title = trial.title,
                   .why = trial.why,
                   .overrides = {{"trial", trial.name}},
                   .values = {trial_level},
                   .tier = trial.tier});
  }
  return all;
}

Measure finding(std::string name, double value, std::string unit) {
  Measure measure;
  measure.name = std::move(name);
  measure.value = value;
  measure.error = value;
  measure.scale = 1;
  measure.unit = std::move(unit);
  return measure;
}

}  // namespace plumbline
