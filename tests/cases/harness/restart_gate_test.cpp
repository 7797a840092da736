// Every case goes on from its checkpoint to the same bits, and the gate that says so sees it when one does not.
#include "cases/harness/restart_gate.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/cases/harness/toy_case.hpp"

namespace plumbline {
namespace {

// --- all cases ----------------------------------------------------------------------------------------------------------

// A problem as it is, but for an earlier end.
class EndsEarly final : public Problem {
 public:
  EndsEarly(std::unique_ptr<Problem> whole, double end) : whole_(std::move(whole)), end_(end) {}
  Scene scene() const override { return whole_->scene(); }
  double end_time() const override { return end_; }
  void observe(const Simulation& simulation) override { whole_->observe(simulation); }
  void history(Archive& archive) override { whole_->history(archive); }
  std::vector<Measure> measures(const Simulation& simulation) const override { return whole_->measures(simulation); }
  Profile profile(const Simulation& simulation) const override { return whole_->profile(simulation); }

 private:
  std::unique_ptr<Problem> whole_;
  double end_;
};

class Shortened final : public Case {
 public:
  Shortened(const Case& whole, long steps) : whole_(whole), steps_(steps) {}
  Statement statement() const override { return whole_.statement(); }
  Kind kind() const override { return whole_.kind(); }
  std::vector<Key> keys() const override { return whole_.keys(); }
  std::vector<Override> points_and_end(const std::string& scheme) const override {
    return whole_.points_and_end(scheme);
  }
  std::unique_ptr<Problem> problem(const Settings& settings) const override {
    auto problem = whole_.problem(settings);
    const double end = std::min(problem->end_time(), static_cast<double>(steps_) * first_step(*problem, settings));
    return std::make_unique<EndsEarly>(std::move(problem), end);
  }
  std::vector<StudyPlan> studies() const override { return {}; }
  std::vector<CaseGate> gates() const override { return {}; }
  GateCount gate_count() const override { return {}; }
  std::vector<double> default_levels() const override { return whole_.default_levels(); }

 private:
  static double first_step(const Problem& problem, const Settings& settings) {
    Simulation run(problem.scene(), settings.text("integrator"), step_control(settings));
    run.step(problem.end_time());
    return run.last_dt();
  }
  const Case& whole_;
  long steps_;
};

// What is averaged over the last part of a run begins with an end of its own.
Settings settings_for(const Case& entry) {
  const double coarsest = entry.default_levels().front();
  Settings settings = entry.settings("default", {{"cells", coarsest}});
  constexpr double steps = 40;
  if (!settings.has("t_end")) return settings;
  const auto problem = entry.problem(settings);
  Simulation run(problem->scene(), settings.text("integrator"), step_control(settings));
  run.step(problem->end_time());
  if (run.last_dt() * steps < problem->end_time()) settings.set("t_end", run.last_dt() * steps, entry.name());
  return settings;
}

class EachCase : public testing::TestWithParam<const Case*> {};

TEST_P(EachCase, GoesOnToTheSameBits) {
  const Shortened entry(*GetParam(), 40);
  const Settings settings = settings_for(*GetParam());
  for (const double share : {0.0, 0.5, 1.0}) {
    const RestartDifference difference = restart_difference(entry, "default", settings, share);
    EXPECT_EQ(difference.numbers, 0) << "from " << share << " of the end time on: " << difference.first;
    EXPECT_GT(difference.compared, 20);
  }
}

INSTANTIATE_TEST_SUITE_P(All, EachCase, testing::ValuesIn(cases()), [](const auto& about) {
  std::string name = about.param->name();
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

}  // namespace
}  // namespace plumbline
