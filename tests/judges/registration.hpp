// Integrators of the corpus that `ci/judges` judges, registered from functions.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "kernel/time_integrator.hpp"

namespace plumbline::judged {

// What stands as source of an integrator that nobody has published.
inline const char* const here = "tests/judges";

// What a step keeps for the next in captured variables, each integrator has of its own and its copies take over.
using Step = std::function<void(Stages& mpm, double dt)>;

class FromFunction final : public TimeIntegrator {
 public:
  explicit FromFunction(Step step) : step_(std::move(step)) {}
  void step(Stages& mpm, double dt) override { step_(mpm, dt); }

 private:
  Step step_;
};

// The class of an integrator is what its name begins with: right, weak or wrong.
class Judged {
 public:
  Judged(const std::string& name, const std::string& title, const std::string& source, const Step& step)
      : registered_({name, title, source, [step] { return std::make_unique<FromFunction>(step); },
                     [](const TimeIntegrator& now) {
                       return std::make_unique<FromFunction>(static_cast<const FromFunction&>(now));
                     }}) {}
  Judged(const std::string& name, const std::string& defect, const Step& step) : Judged(name, defect, here, step) {}

 private:
  RegisterIntegrator registered_;
};

}  // namespace plumbline::judged
