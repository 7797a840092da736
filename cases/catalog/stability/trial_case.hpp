// Cases whose numbers the laboratory finds: no run of a scene, but trials, each a study of one level.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cases/harness/description/case.hpp"

namespace plumbline {

struct Findings {
  std::vector<Measure> measures;
  Profile profile;
};

struct Trial {
  std::string name, title, why;
  std::function<Findings()> find;
  Tier tier = Tier::quick;  // the lowest that makes it
};

// One study per trial, its id the trial's name, its only level trial_level. The scene that the harness steps is a bar at
// rest: what is judged is what Trial::find finds.
class TrialCase : public Case {
 public:
  static constexpr double trial_level = 8;

  virtual std::vector<Trial> trials() const = 0;

  Kind kind() const final { return Kind::solid; }
  bool takes_integrators() const final { return false; }
  std::vector<Key> keys() const final;
  std::vector<Override> points_and_end(const std::string& scheme) const final;
  void derive(Settings& settings, const std::string& scheme) const final;
  std::unique_ptr<Problem> problem(const Settings& settings) const final;
  std::vector<StudyPlan> studies() const final;
  std::vector<double> default_levels() const final { return {trial_level}; }
};

// A measure without a reference of its own: gates say what it must be.
Measure finding(std::string name, double value, std::string unit = "1");

}  // namespace plumbline
