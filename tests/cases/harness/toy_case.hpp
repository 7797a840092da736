// A case in a few lines for the tests of the harness: three points of membrane that drift and swing, and measures,
// profile, studies and gates as each test wants them.
#pragma once

#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "cases/harness/description/case.hpp"
#include "cases/harness/description/prose.hpp"
#include "cases/harness/judge/gates.hpp"
#include "kernel/materials/uniaxial_membrane.hpp"

namespace plumbline {

struct Toy {
  std::string name = "toy";
  Kind kind = Kind::membrane;
  int dim = 1;
  double dt = 1e-3, end = 1e-2;        // s
  std::vector<Override> choices = {};  // beside the step
  std::function<Override(const Settings&)> york_step = {};
  std::function<void(Scene&)> change = {};
  std::function<void(const Simulation&)> observe = {};
  std::function<std::vector<Measure>(const Settings&, const Simulation&)> measures = {};
  std::function<Profile(const Settings&, const Simulation&)> profile = {};
  std::vector<StudyPlan> studies = {};
  std::vector<CaseGate> gates = {};
  std::map<std::string, std::string> may_be_undefined = {};
  bool any_integrator = false;
  std::vector<double> levels = {4, 8};
  std::function<std::vector<Comparator>(const Settings&, const std::vector<double>&)> comparators = {};
};

class ToyProblem final : public Problem {
 public:
  ToyProblem(const Toy& toy, const Settings& settings) : toy_(toy), settings_(settings) {}

  Scene scene() const override {
    Scene scene;
    scene.grid.dim = toy_.dim;
    scene.grid.h = 1 / settings_.number("cells");
    scene.grid.cells = {settings_.integer("cells"), toy_.dim == 2 ? settings_.integer("cells") : 1};
    scene.shape = settings_.text("shape");
    scene.transfer = settings_.text("transfer");
    auto law = std::make_shared<UniaxialMembrane>();
    law->youngs_modulus = 1;
    law->density = 1;
    law->one_way = false;
    Body body = make_body("toy", law, 3, toy_.dim);
    for (int p = 0; p < 3; ++p) {
      body.points(column::position)[p] = 0.4 + 0.1 * p;
      if (toy_.dim == 2) body.points(column::position, 1)[p] = 0.5;
      body.points(column::velocity)[p] = 0.01 * (p + 1);
      body.points(column::volume)[p] = body.points(column::mass)[p] = 0.1;
    }
    scene.bodies.push_back(std::move(body));
    if (toy_.change) toy_.change(scene);
    return scene;
  }
  double end_time() const override { return toy_.end; }
  void observe(const Simulation& simulation) override {
    if (toy_.observe) toy_.observe(simulation);
  }
  std::vector<Measure> measures(const Simulation& simulation) const override {
    return toy_.measures ? toy_.measures(settings_, simulation) : std::vector<Measure>{};
  }
  Profile profile(const Simulation& simulation) const override {
    return toy_.profile ? toy_.profile(settings_, simulation) : Profile{};
  }

 private:
  Toy toy_;
  Settings settings_;
};

// What it says in words.
inline const RegisterProse toy_prose{
    "toy",
    "# toy\n\n## Source\nnone\n\n## Claim\nnone\n\n## Physics\nnone\n\n## Cells\nnone\n\n"
    "## Reference: none\nnone\n\n## Bound of the reference\nnone\n",
    "<svg/>"};

inline Case toy_case(const Toy& toy = {}) {
  Case made{.name = toy.name, .kind = toy.kind, .sets = {{"dt", toy.dt}}, .york_step = toy.york_step};
  made.keys = {positive_key("weight", 1, "kg", "of nothing")};
  made.sets.insert(made.sets.end(), toy.choices.begin(), toy.choices.end());
  made.problem = [toy](const Settings& settings) { return std::make_unique<ToyProblem>(toy, settings); };
  made.studies = toy.studies;
  made.gates = toy.gates;
  made.levels = toy.levels;
  made.any_integrator = toy.any_integrator;
  made.may_be_undefined = toy.may_be_undefined;
  made.comparators = toy.comparators;
  return made;
}

// A declaration without a number that it judges.
inline Gate toy_gate(std::string id, Range expected) {
  Gate gate;
  gate.id = std::move(id);
  gate.quantity = "a number";
  gate.expected = expected;
  gate.reason = "the test wants it";
  return gate;
}

inline const Because wanted_by_test = requirement("the test wants it");

// A measure "error" of exactly constant h^order, whatever the simulation did.
inline std::vector<Measure> power_law_error(double h, double constant, double order) {
  return {{"error", constant * std::pow(h, order), 1.0, {}, {}, 0.0, "m"}};
}

}  // namespace plumbline
